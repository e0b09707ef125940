# stayput: `make demo` shows what it does, `make test` checks it. Everything lives in .venv.

PYTHON ?= python3
VENV   ?= .venv
MINUTES ?= 10
BIN    := $(VENV)/bin
PIP    := $(BIN)/python -m pip --disable-pip-version-check
# The first pip that installs dependency groups (PEP 735).
PIP_WITH_GROUPS := pip>=25.1
# A stamp names what was installed and from which versions, so a second run installs nothing.
KEY    := $(shell cat pyproject.toml requirements.lock 2>/dev/null | cksum | cut -d ' ' -f 1)
STAMP  := $(VENV)/.installed-$(KEY)
EXTRAS := formats,app,inventory
SPHINX := $(BIN)/python -m sphinx -W --keep-going -q
# Runs a command while no other make does: two at once would write the same files of .venv.
ALONE  := $(PYTHON) -c 'import fcntl, subprocess, sys; file = open("Makefile"); \
  fcntl.flock(file, fcntl.LOCK_EX); sys.exit(subprocess.call(sys.argv[1:]))'

.PHONY: help install demo paper test test-all coverage soak peers lint bench bench-app bench-inventory docs lock release-notes clean

help:
	@echo "make demo     which measure keeps a bookcase standing: the verdict, a report (out/)"
	@echo "make paper    every section of the paper, its published numbers beside ours (out/paper); RECORD=file: its record"
	@echo "make test     every test, of a matrix one case (ten minutes on two cores)"
	@echo "make test-all every test with all of its cases, as continuous integration runs them"
	@echo "make soak     input made to break what reads it, for MINUTES=10 or as long as asked"
	@echo "make coverage every test, and which lines of Python they run (out/coverage)"
	@echo "make peers    pelicun and OpenQuake read our fragility curves, in an environment of their own (out/peers)"
	@echo "make lint     ruff, formatting, types, and whether the documentation's references lead somewhere"
	@echo "make bench    speed and accuracy beside MuJoCo; ensembles, buildings, devices, verifications, starts"
	@echo "make bench-app, make bench-inventory   the server under load and the page in Chromium; tables of furniture"
	@echo "make docs     documentation pages (docs/_build/html)"
	@echo "make release-notes   the newest version's part of CHANGELOG.md, or that of VERSION=0.1.0"
	@echo "make install  the core in $(VENV)    make lock  fresh requirements.lock    make clean"

install: $(STAMP)-core

demo: $(STAMP)-core
	@mkdir -p out
	$(BIN)/stayput verify examples/bookcase.toml --report out/bookcase.html

# RECORD: the record of JMA Kobe 1995, NS, for Table 4.3; the built-in near-fault motion where there is none.
paper: $(STAMP)-core
	$(BIN)/python -m studies $(if $(RECORD),--record "$(RECORD)")

test: QUICK := -m "not long"
test test-all: $(STAMP)-test
	@$(BIN)/python tests/prerequisites.py
	$(BIN)/python -m pytest -n auto --dist worksteal $(QUICK) $(PYTEST_ARGS)

coverage: $(STAMP)-test
	@$(BIN)/python tests/prerequisites.py
	@rm -rf out/coverage && mkdir -p out/coverage
	$(BIN)/python -m pytest -n auto --dist worksteal --cov --cov-report=term:skip-covered \
	  --cov-report=html $(PYTEST_ARGS)

# Each round tries other examples; the round in which the time ends is finished.
soak: $(STAMP)-test
	@end=$$(( $$(date +%s) + 60 * $(MINUTES) )); round=0; \
	while [ $$(date +%s) -lt $$end ]; do \
	  round=$$(( round + 1 )); echo "Round $$round"; \
	  HYPOTHESIS_PROFILE=soak $(BIN)/python -m pytest tests/property -m hostile -n auto -x -q $(PYTEST_ARGS) || exit 1; \
	done; echo "$$round rounds: nothing found"

# Broken references end the build of the documentation, which takes too long for every commit: they are checked without its runs.
lint: $(STAMP)-lint $(STAMP)-docs
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright --pythonpath $(BIN)/python
	@rm -rf docs/generated/api
	$(SPHINX) -b dummy -t references -D nb_execution_mode=off -D sphinx_gallery_conf.plot_gallery=False \
	  -d docs/_build/references docs docs/_build/dummy

bench: $(STAMP)-test
	@mkdir -p out
	$(BIN)/python benchmarks/bench.py --plot out/work_precision.png $(BENCH_ARGS)
	$(BIN)/python benchmarks/ensemble.py
	$(BIN)/python benchmarks/building.py
	$(BIN)/python benchmarks/devices.py
	$(BIN)/python benchmarks/start.py
	$(BIN)/python benchmarks/verdicts.py
	$(BIN)/python benchmarks/space.py

bench-app: $(STAMP)-test
	$(BIN)/python benchmarks/app.py $(BENCH_ARGS)
	$(BIN)/python benchmarks/page.py

bench-inventory: $(STAMP)-test
	$(BIN)/python benchmarks/inventory.py $(BENCH_ARGS)

# Stubs of names that are gone would be warned of.
docs: $(STAMP)-docs
	@rm -rf docs/generated/api
	$(SPHINX) -b html -d docs/_build/doctrees docs docs/_build/html
	@echo "docs/_build/html/index.html"

$(VENV)/bin/python:
	@command -v $(PYTHON) >/dev/null 2>&1 \
	  || { echo "There is no $(PYTHON) here; install Python 3.11 or newer, or name one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	  || { echo "$$($(PYTHON) --version) is too old; stayput needs 3.11 or newer: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null \
	  || { echo "$(PYTHON) cannot make virtual environments; install its venv package (Debian, Ubuntu: apt install python3-venv)." >&2; exit 1; }
	@$(ALONE) sh -c 'test -x $@ || $(PYTHON) -m venv $(VENV)'

# The pip that comes with Python may be older; users of the core (`make demo`) need no newer one.
$(VENV)/.pip: | $(VENV)/bin/python
	@$(ALONE) sh -c 'test -e $@ || { $(PIP) install --quiet --upgrade "$(PIP_WITH_GROUPS)" && touch $@; }'

$(STAMP)-core: WHAT := -e .
$(STAMP)-test: WHAT := -e '.[$(EXTRAS)]' --group test
$(STAMP)-lint: WHAT := -e '.[$(EXTRAS)]' --group test --group lint
$(STAMP)-docs: WHAT := -e '.[$(EXTRAS)]' --group docs
$(STAMP)-test $(STAMP)-lint $(STAMP)-docs: | $(VENV)/.pip
# Byte-compiling in parallel afterwards takes half as long as pip's own.
$(STAMP)-core $(STAMP)-test $(STAMP)-lint $(STAMP)-docs: | $(VENV)/bin/python
	@$(ALONE) sh -c "test -e $@ || { echo Installing into $(VENV) ...; \
	  $(PIP) install --quiet --no-compile -c requirements.lock $(WHAT) && touch $@; }"
	-@$(BIN)/python -m compileall -q -j 0 -x '/tests?/' $(VENV)/lib >/dev/null 2>&1

# The dependency group says why they need an environment of their own.
peers: | $(VENV)/.pip
	$(PYTHON) -m venv out/peers
	out/peers/bin/python -m pip install --quiet --upgrade "$(PIP_WITH_GROUPS)"
	out/peers/bin/python -m pip install --quiet -e . --group peers
	out/peers/bin/python -m pytest tests/validation/test_fragility_exports.py

lock:
	@set -e; dir=$$(mktemp -d); trap 'rm -rf "$$dir"' EXIT; \
	$(PYTHON) -m venv "$$dir"; \
	pip="$$dir/bin/python -m pip --disable-pip-version-check"; \
	$$pip install --quiet --upgrade "$(PIP_WITH_GROUPS)"; \
	$$pip install --quiet '.[$(EXTRAS),cluster]' --group test --group docs --group lint; \
	$$pip list --format=freeze --exclude pip --exclude setuptools --exclude stayput \
	  | LC_ALL=C sort -f > requirements.lock
	@echo "requirements.lock: $$(wc -l < requirements.lock) packages"

release-notes:
	@$(PYTHON) docs/release_notes.py $(VERSION)

clean:
	rm -rf out build dist docs/_build docs/gallery docs/generated .pytest_cache .ruff_cache .hypothesis
	find src studies tests benchmarks docs -name __pycache__ -type d -prune -exec rm -rf {} +
