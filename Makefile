# `make` derives, proves and emits the kernels; `make test` checks everything. Both set up .venv by themselves.
PYTHON ?= python3
VENV   := .venv
RUN    := $(VENV)/bin/python
READY  := $(VENV)/.ready

.DEFAULT_GOAL := generate
.PHONY: generate check verify show test lint types bench accuracy clean help

generate: $(READY)  ## derive, prove and write the committed kernels (the default)
	$(RUN) -m derive generate

check: $(READY)  ## fail if a generated file is stale, missing or foreign
	$(RUN) -m derive generate --check
	$(RUN) -m derive verify --format markdown -o docs/errata.md --check

verify: $(READY)  ## decide every equation of the papers and write docs/errata.md
	$(RUN) -m derive verify --format markdown -o docs/errata.md

show: $(READY)  ## print the formulas of an order: make show N=3
	$(RUN) -m derive show -n $(or $(N),1-3)

test: lint types check  ## lint, types, stale check and all tests
	$(RUN) -m pytest -n 2

lint: $(READY)  ## ruff
	$(RUN) -m ruff check .

types: $(READY)  ## mypy --strict
	$(RUN) -m mypy

bench: $(VENV)/.bench  ## proof times by order, then kernels against peers and their former release (docs/benchmarks.md)
	$(RUN) benchmarks/proofs.py
	$(RUN) -m benchmarks -o docs/benchmarks.md

accuracy: $(VENV)/.bench  ## worst errors and figures in docs: make accuracy SEARCH=60 looks for worse inputs
	$(RUN) -m benchmarks.accuracy --search $(or $(SEARCH),0)

clean:  ## remove the environment and caches
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

help:  ## list these targets
	@grep -hE '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*##/\t/' | expand -t 12

# The environment is rebuilt when what it holds changes.
$(READY): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python >= 3.11 is needed: make PYTHON=python3.11")'
	$(PYTHON) -m venv $(VENV)
	$(RUN) -m pip install --quiet --constraint constraints.txt --editable '.[derive,flint,test]'
	touch $@

# What benchmarks need besides; jaxlie and pinocchio, which are large, with BENCH=bench,peers.
$(VENV)/.bench: $(READY)
	$(RUN) -m pip install --quiet --constraint constraints.txt --editable '.[$(or $(BENCH),bench)]'
	touch $@
