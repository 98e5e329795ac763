# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo   mills a saddle whose middle passes the singularity; results in out/
# make test   every ring of tests; make bench   speeds as ratios to peers in the same run
PYTHON := .venv/bin/python
FIVEAXIS := $(PYTHON) -m freecad_fiveaxis

.PHONY: help demo test lint core linuxcnc freecad bench parts clean

help:
	@sed -n '2,3s/^# //p' Makefile

demo:
	@scripts/prepare demo
	@scripts/demo

test: lint core linuxcnc freecad

lint:
	@scripts/prepare test
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy

core:
	@scripts/prepare test
	$(PYTHON) -m pytest -n 2 -m "not rs274"

linuxcnc:
	@scripts/prepare test
	@scripts/prepare linuxcnc
	$(PYTHON) -m pytest -m rs274

freecad:
	@scripts/prepare test
	@scripts/prepare freecad
	tests/freecad/run

bench:
	@scripts/prepare bench
	$(PYTHON) benchmarks/run.py

clean:
	rm -rf out build .pytest_cache .mypy_cache .ruff_cache .hypothesis
