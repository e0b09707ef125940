# stayput: `make demo` shows what it does, `make test` checks it. Everything lives in .venv.

PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
PIP    := $(BIN)/python -m pip --disable-pip-version-check
# A stamp names what was installed and from which versions, so a second run installs nothing.
KEY    := $(shell cat pyproject.toml requirements.lock 2>/dev/null | cksum | cut -d ' ' -f 1)
STAMP  := $(VENV)/.installed-$(KEY)
ALL    := formats,app,cluster,inventory,test,docs,lint

.PHONY: help install demo test lint bench bench-app bench-inventory docs lock clean

help:
	@echo "make demo     which measure keeps a bookcase standing: the verdict, a report (out/)"
	@echo "make test     every test"
	@echo "make lint     ruff, formatting, types"
	@echo "make bench    speed and accuracy beside MuJoCo; ensembles, buildings, devices"
	@echo "make bench-app, make bench-inventory   the server under load and the page in Chromium; tables of furniture"
	@echo "make docs     documentation pages (docs/_build/html)"
	@echo "make install  the core in $(VENV)    make lock  fresh requirements.lock    make clean"

install: $(STAMP)-core

demo: $(STAMP)-core
	@mkdir -p out
	$(BIN)/stayput verify examples/bookcase.toml --report out/bookcase.html

test: $(STAMP)-test
	$(BIN)/python -m pytest -n auto $(PYTEST_ARGS)

lint: $(STAMP)-lint
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright --pythonpath $(BIN)/python

bench: $(STAMP)-test
	@mkdir -p out
	$(BIN)/python benchmarks/bench.py --plot out/work_precision.png $(BENCH_ARGS)
	$(BIN)/python benchmarks/ensemble.py
	$(BIN)/python benchmarks/building.py
	$(BIN)/python benchmarks/devices.py

bench-app: $(STAMP)-test
	$(BIN)/python benchmarks/app.py $(BENCH_ARGS)
	$(BIN)/python benchmarks/page.py

bench-inventory: $(STAMP)-test
	$(BIN)/python benchmarks/inventory.py $(BENCH_ARGS)

docs: $(STAMP)-docs
	$(BIN)/python -m sphinx -W --keep-going -q -b html -d docs/_build/doctrees docs docs/_build/html
	@echo "docs/_build/html/index.html"

$(VENV)/bin/python:
	@command -v $(PYTHON) >/dev/null 2>&1 \
	  || { echo "There is no $(PYTHON) here; install Python 3.11 or newer, or name one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	  || { echo "$$($(PYTHON) --version) is too old; stayput needs 3.11 or newer: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null \
	  || { echo "$(PYTHON) cannot make virtual environments; install its venv package (Debian, Ubuntu: apt install python3-venv)." >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)

# Byte-compiling in parallel afterwards takes half as long as pip's own.
$(STAMP)-core: EXTRAS :=
$(STAMP)-test: EXTRAS := [formats,app,inventory,test]
$(STAMP)-lint: EXTRAS := [formats,app,inventory,test,lint]
$(STAMP)-docs: EXTRAS := [formats,app,inventory,docs]
$(STAMP)-core $(STAMP)-test $(STAMP)-lint $(STAMP)-docs: | $(VENV)/bin/python
	$(PIP) install --quiet --no-compile -c requirements.lock -e '.$(EXTRAS)'
	-@$(BIN)/python -m compileall -q -j 0 -x '/tests?/' $(VENV)/lib >/dev/null 2>&1
	@touch $@

lock:
	@set -e; dir=$$(mktemp -d); trap 'rm -rf "$$dir"' EXIT; \
	$(PYTHON) -m venv "$$dir"; \
	"$$dir"/bin/python -m pip --disable-pip-version-check install --quiet '.[$(ALL)]'; \
	"$$dir"/bin/python -m pip list --format=freeze --exclude pip --exclude setuptools --exclude stayput \
	  | LC_ALL=C sort -f > requirements.lock
	@echo "requirements.lock: $$(wc -l < requirements.lock) packages"

clean:
	rm -rf out build dist docs/_build docs/gallery docs/generated .pytest_cache .ruff_cache .hypothesis
	find src tests benchmarks docs -name __pycache__ -type d -prune -exec rm -rf {} +
