# `make` derives, proves and emits the kernels. `make test` checks everything except the slow tests of `make thorough`.
# Every target sets up the environment .venv when it is missing.
PYTHON ?= python3
VENV   := .venv
RUN    := $(VENV)/bin/python
# Hundreds of processes import the same modules; without their bytecode, each would compile them again.
unexport PYTHONDONTWRITEBYTECODE
# Empty files that say what is installed: packages to derive and generate; packages to test, lint and check types.
READY  := $(VENV)/.ready
TESTED := $(VENV)/.test
# Each worker starts with neighbouring tests, so that few fixtures are made twice; idle workers take over the rest.
PYTEST := $(RUN) -m pytest -n auto --maxprocesses 4 --dist worksteal
# Tests of `make test`; `make test TESTS="not coq"` runs the slow ones too, which share packages and imports with these.
TESTS  := not thorough and not coq
PIP    := $(RUN) -m pip --disable-pip-version-check install --quiet --quiet --constraint constraints.txt

# MathJax sets the site's formulas: its version, its folder, and a stamp that is written when the folder is complete.
MATHJAX := 4.1.3
ASSETS  := build/docs/assets/mathjax
MATHJAX_READY := build/docs/.mathjax-$(MATHJAX)
# Pyodide runs the page "Try it" in browsers: its version, the platform of its wheels, its folder, and a stamp.
PYODIDE := 314.0.7
WASM    := --platform pyemscripten_2026_0_wasm32 --python-version 3.14 --implementation cp --abi cp314
ENGINE  := build/docs/assets/engine
ENGINE_READY := build/docs/.pyodide-$(PYODIDE)
# Functions whose machine code is compared with its text: a sample; all of them take hours: make machine-proofs BYTES=
BYTES  ?= --chart cayley2 --real double --function rate
# Certified bounds of rounding errors.
BOUNDS := benchmarks/certified.json

CHECKS := check-errata check-theorems check-kernels

.DEFAULT_GOAL := generate
.PHONY: generate check $(CHECKS) check-field check-verdicts proofs machine-proofs bounds verify show test thorough test-native quick smoke lint types mutants native bench accuracy figures parameterizations docs clean help

generate: $(READY)  ## derive, prove and write the committed kernels (the default)
	$(RUN) -m derive generate

check: $(CHECKS)  ## fail if a generated file or page is stale, missing or foreign, or if a control passes

check-kernels: $(READY)
	$(RUN) -m derive generate --check

check-errata: $(READY)
	$(RUN) -m derive verify --format markdown --data -o docs/errata.md --check

check-field: $(READY)
	$(RUN) -m docs.pages.field -o docs/field.md --check

check-verdicts: check-errata check-field  ## fail if an equation or a formula in use is decided otherwise than its page says (minutes)

check-theorems: $(READY)
	$(RUN) -m docs.pages.proving -o docs/theorems.md --check

proofs: $(READY)  ## prove all theorems, require that every control fails, and write docs/theorems.md
	$(RUN) -m docs.pages.proving -o docs/theorems.md

machine-proofs: $(TESTED)  ## check theorems and emitted programs with Coq, rounding with Gappa, machine code (apt-get install coq gappa)
	$(RUN) -m proofs
	$(RUN) -m proofs.bridge
	$(RUN) -m derive generate --target c -n 1-5,8 --family exponential -o build/bytes
	$(RUN) -m proofs.bytes build/bytes $(BYTES)
	@if command -v gappa > /dev/null; then $(RUN) -m proofs.rounding --check $(BOUNDS); \
	    else echo "skipped: bounds of rounding errors need Gappa (apt-get install gappa)"; fi

bounds: $(VENV)/.bench  ## find bounds of rounding errors with Gappa, and write them into docs/accuracy.md
	$(RUN) -m proofs.rounding -o $(BOUNDS)
	$(RUN) -m benchmarks.accuracy --bounds-only

verify: $(READY)  ## decide every equation of the papers and of documents in use: docs/errata.md, docs/field.md and .json
	$(RUN) -m derive verify --format markdown --data -o docs/errata.md
	$(RUN) -m docs.pages.field -o docs/field.md

show: $(READY)  ## print the formulas of an order: make show N=3
	$(RUN) -m derive show -n $(or $(N),1-3)

# The equations of the papers take minutes: `make check-verdicts` decides all of them, tests a sample.
test: $(TESTED)  ## lint, types, stale kernels, proofs with controls, and all tests but the thorough ones
	$(MAKE) --no-print-directory --jobs=2 types check-theorems check-kernels lint
	$(PYTEST) -m "$(TESTS)"

thorough: $(TESTED)  ## slow tests: compilers and further charts
	$(PYTEST) -m "thorough and not coq"

# Tests that write kernels of their own are left out: no compiled functions are installed for these.
test-native: $(TESTED)  ## kernel tests on compiled functions of all committed charts
	rm -rf build/test-native
	$(RUN) -m tests.support.native build/test-native
	DUALCAY_NATIVE=1 PYTHONPATH=$(CURDIR)/build/test-native/site $(PYTEST) -m "not thorough" tests/generated

quick: $(TESTED)  ## lint, types, stale kernels and one smoke test per room, in half a minute
	$(MAKE) --no-print-directory --jobs=3 types smoke check-kernels lint

# In one process, since types and stale kernels take the other processors meanwhile.
smoke: $(TESTED)
	$(RUN) -m pytest -m smoke

lint: $(TESTED)  ## ruff
	$(RUN) -m ruff check .

types: $(TESTED)  ## mypy --strict
	$(RUN) -m mypy

mutants: $(TESTED)  ## share of small changes that are refused: make mutants ROOM=programs,maps SAMPLE=200 FLOOR=95
	$(RUN) -m tests.mutants $(ROOM:%=--room %) $(SAMPLE:%=--sample %) $(FLOOR:%=--floor %)

native: $(READY)  ## compile and install dualcay-native, which runs beneath the NumPy kernels (minutes)
	$(RUN) -m derive generate --target native -o build/native
	$(PIP) ./build/native

bench: $(VENV)/.bench  ## times of proofs, and of kernels against peers or another checkout: make bench AGAINST=OTHER/generated/dualcay
	$(RUN) -m benchmarks.proofs
	$(RUN) -m benchmarks -o docs/benchmarks.md
	$(if $(AGAINST),$(RUN) -m benchmarks.recorded --against $(AGAINST) -o docs/benchmarks.md)

parameterizations: $(VENV)/.bench  ## properties of charts, measured: docs/parameterizations.md and its plot
	$(RUN) -m benchmarks.charts
	$(RUN) -m derive compare --plot docs/parameterizations.svg > /dev/null
	$(RUN) -m derive compare --format markdown > docs/parameterizations.md

figures: $(VENV)/.bench  ## pictures of the README and the site (docs/figures); with all libraries: make figures BENCH=bench,peers
	$(RUN) -m benchmarks.figures

accuracy: $(VENV)/.bench  ## largest errors and their figures; search for worse inputs: make accuracy SEARCH=60
	$(RUN) -m benchmarks.accuracy --search $(or $(SEARCH),0)
	$(RUN) -m benchmarks.conditioning

docs: $(VENV)/.docs $(MATHJAX_READY) $(ENGINE_READY)  ## the site, built offline: build/docs/html/index.html
	$(RUN) -m sphinx -W --keep-going --jobs auto --quiet docs build/docs/html
	$(RUN) -m docs._ext.links build/docs/html

clean:  ## remove the environment, caches and what the site's build writes
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
	rm -rf docs/examples docs/reference/generated docs/sg_execution_times.rst
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

help:  ## list these targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*##/\t/' | expand -t 18

# The environment is installed again when its requirements change.
$(READY): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python >= 3.11 is needed: make PYTHON=python3.11")'
	$(PYTHON) -m venv $(VENV)
	$(PIP) --editable '.[derive]'
	touch $@

$(TESTED): $(READY)
	$(PIP) --editable '.[test]'
	touch $@

# Packages for the site.
$(VENV)/.docs: $(READY)
	$(PIP) --editable '.[docs]'
	touch $@

# MathJax with its font from npm, so that the site needs no other host.
$(MATHJAX_READY):
	@command -v npm > /dev/null || { echo "make docs needs npm, which downloads MathJax: apt-get install npm" >&2; exit 3; }
	rm -rf $(ASSETS) && mkdir -p $(ASSETS)/mathjax-newcm-font
	cd build/docs && npm pack --silent mathjax@$(MATHJAX) @mathjax/mathjax-newcm-font@$(MATHJAX) > /dev/null
	tar xzf build/docs/mathjax-$(MATHJAX).tgz -C $(ASSETS) --strip-components=1
	tar xzf build/docs/mathjax-mathjax-newcm-font-$(MATHJAX).tgz -C $(ASSETS)/mathjax-newcm-font --strip-components=1 package/chtml package/chtml.js
	touch $@

# Pyodide from npm and python-flint for it. Without them the site is built, and its page "Try it" says what it lacks.
$(ENGINE_READY):
	rm -rf $(ENGINE) build/docs/python_flint-*_wasm32.whl && mkdir -p $(ENGINE)
	cd build/docs && npm pack --silent pyodide@$(PYODIDE) > /dev/null && tar xzf pyodide-$(PYODIDE).tgz -C assets/engine \
	    --strip-components=1 $(addprefix package/,package.json pyodide.mjs pyodide.asm.mjs pyodide.asm.wasm pyodide-lock.json python_stdlib.zip) \
	  && cd ../.. && $(RUN) -m pip --disable-pip-version-check download --quiet --no-deps --only-binary :all: $(WASM) \
	    --constraint constraints.txt --dest build/docs python-flint && touch $@ \
	  || echo "left out of the page \"Try it\": its engine, since Pyodide or python-flint for it cannot be downloaded" >&2

# Packages for benchmarks; BENCH=bench,peers adds jaxlie and pinocchio, which are large.
$(VENV)/.bench: $(TESTED)
	$(PIP) --editable '.[$(or $(BENCH),bench)]'
	touch $@
