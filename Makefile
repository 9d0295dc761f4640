# `make` derives, proves and emits the kernels; `make test` checks all, but for what `make thorough` tries besides. They
# set up .venv by themselves.
PYTHON ?= python3
VENV   := .venv
RUN    := $(VENV)/bin/python
# What deriving and generating need is installed, and what tests, lint and types need besides.
READY  := $(VENV)/.ready
TESTED := $(VENV)/.test
# Each worker begins with a stretch of its own, so that few fixtures are made twice, and helps out when it is done.
PYTEST := $(RUN) -m pytest -n auto --maxprocesses 4 --dist worksteal
PIP    := $(RUN) -m pip --disable-pip-version-check install --quiet --quiet --constraint constraints.txt

CHECKS := check-errata check-theorems check-kernels

.DEFAULT_GOAL := generate
.PHONY: generate check $(CHECKS) proofs verify show test thorough test-native quick smoke lint types mutants native bench accuracy figures parameterizations clean help

generate: $(READY)  ## derive, prove and write the committed kernels (the default)
	$(RUN) -m derive generate

check: $(CHECKS)  ## fail if a generated file or page is stale, missing or foreign, or a control does not fail

check-kernels: $(READY)
	$(RUN) -m derive generate --check

check-errata: $(READY)
	$(RUN) -m derive verify --format markdown -o docs/errata.md --check

check-theorems: $(READY)
	$(RUN) -m derive.proof -o docs/theorems.md --check

proofs: $(READY)  ## prove all theorems, see every control fail, and write docs/theorems.md
	$(RUN) -m derive.proof -o docs/theorems.md

verify: $(READY)  ## decide every equation of the papers and write docs/errata.md
	$(RUN) -m derive verify --format markdown -o docs/errata.md

show: $(READY)  ## print the formulas of an order: make show N=3
	$(RUN) -m derive show -n $(or $(N),1-3)

test: $(TESTED)  ## lint, types, stale check, proofs with their controls and all tests but the thorough ones
	$(MAKE) --no-print-directory --jobs=2 types check lint
	$(PYTEST) -m "not thorough"

thorough: $(TESTED)  ## tests of compilers, further charts and mutants, which take minutes more
	$(PYTEST) -m thorough

# Left out is what makes kernels of its own, beneath which nothing compiled is installed.
test-native: $(TESTED)  ## the tests of kernels once more, on compiled functions of all committed charts
	rm -rf build/test-native
	$(RUN) -m tests.support.native build/test-native
	DUALCAY_NATIVE=1 PYTHONPATH=$(CURDIR)/build/test-native/site $(PYTEST) -m "not thorough" tests/generated \
	    --ignore tests/generated/test_sign_flips.py --ignore tests/generated/test_kernel_other_orders.py

quick: $(TESTED)  ## lint, types and a smoke of every room, in less than a minute
	$(MAKE) --no-print-directory --jobs=3 types smoke lint

smoke: $(TESTED)
	$(PYTEST) -m smoke

lint: $(TESTED)  ## ruff
	$(RUN) -m ruff check .

types: $(TESTED)  ## mypy --strict
	$(RUN) -m mypy

mutants: $(TESTED)  ## share of small changes that are refused: make mutants ROOM=programs,maps SAMPLE=200 FLOOR=95
	$(RUN) -m tests.mutants $(ROOM:%=--room %) $(SAMPLE:%=--sample %) $(FLOOR:%=--floor %)

native: $(READY)  ## compile the committed charts and install them, dualcay-native, beneath the NumPy kernels (minutes)
	$(RUN) -m derive generate --target native -o build/native
	$(PIP) ./build/native

bench: $(VENV)/.bench  ## proof times by order, then kernels, compiled ones too, against peers (docs/benchmarks.md)
	$(RUN) -m benchmarks.proofs
	$(RUN) -m benchmarks -o docs/benchmarks.md

parameterizations: $(VENV)/.bench  ## what charts are like, measured too: docs/parameterizations.md and its plot
	$(RUN) -m benchmarks.charts
	$(RUN) -m derive compare --plot docs/parameterizations.png > /dev/null
	$(RUN) -m derive compare --format markdown > docs/parameterizations.md

figures: $(VENV)/.bench  ## the pictures of the README (docs/figures), with all libraries: make figures BENCH=bench,peers
	$(RUN) -m benchmarks.figures

accuracy: $(VENV)/.bench  ## worst errors and figures in docs: make accuracy SEARCH=60 looks for worse inputs
	$(RUN) -m benchmarks.accuracy --search $(or $(SEARCH),0)
	$(RUN) -m benchmarks.conditioning

clean:  ## remove the environment and caches
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

help:  ## list these targets
	@grep -hE '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*##/\t/' | expand -t 12

# The environment is rebuilt when what it holds changes.
$(READY): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python >= 3.11 is needed: make PYTHON=python3.11")'
	$(PYTHON) -m venv $(VENV)
	$(PIP) --editable '.[derive]'
	touch $@

$(TESTED): $(READY)
	$(PIP) --editable '.[test]'
	touch $@

# What benchmarks need besides; jaxlie and pinocchio, which are large, with BENCH=bench,peers.
$(VENV)/.bench: $(TESTED)
	$(PIP) --editable '.[$(or $(BENCH),bench)]'
	touch $@
