# Everything is set up in .venv, in this folder; the stamps in it tell what is up to date.
PYTHON ?= python3
VENV := .venv
ifeq ($(OS),Windows_NT)
BIN := $(VENV)/Scripts
else
BIN := $(VENV)/bin
endif
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
SOURCES := pyproject.toml hatch_build.py $(shell find widgets/front_end -type f -not -path '*/node_modules/*' -not -name '*.pyc')

.DEFAULT_GOAL := help
.PHONY: help lab test check clean

help:  ## list these targets
	@sed -n 's/^\([a-z]*\):.*## /make \1\t/p' $(MAKEFILE_LIST) | expand -t 12

lab: $(VENV)/lab.stamp  ## open the course in JupyterLab; ARGS="--no-browser --port 9000"
	@$(BIN)/casteljau lab $(ARGS)

test: $(VENV)/tests.stamp  ## run all tests; ARGS="-k hermite" runs some
	@$(BIN)/python tests/chromium.py
	$(BIN)/python -m pytest $(ARGS)

check: $(VENV)/tests.stamp  ## style, types and the arrows between the rooms
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/python -m pytest --quiet --numprocesses=0 --durations=0 tests/test_layers.py

clean:  ## remove everything that was set up or built
	rm -rf $(VENV) widgets/static widgets/front_end/node_modules artefacts build dist
	rm -rf .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

$(VENV)/made.stamp:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { echo "make: \
	expected Python 3.11 or newer, got $$($(PYTHON) -V 2>/dev/null || echo no $(PYTHON)); name one, \
	as in: make lab PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { echo "make: expected a Python with \
	venv, got one without; on Debian and Ubuntu: apt install python3-venv" >&2; exit 1; }
	@echo "Setting up $(VENV): a minute or two, this once ..."
	@$(PYTHON) -m venv $(VENV)
	@touch $@

$(VENV)/lab.stamp: $(VENV)/made.stamp $(SOURCES)
	@$(PIP) --editable .
	@touch $@

$(VENV)/tests.stamp: $(VENV)/made.stamp $(SOURCES)
	@$(PIP) --editable '.[tests]'
	@touch $(VENV)/lab.stamp $@
