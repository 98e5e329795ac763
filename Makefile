# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo   mills a saddle whose middle passes the singularity; results in out/
# make test   every ring of tests, on the FreeCAD that is installed; make test-matrix   on FreeCAD 1.0 and 1.1 too, in chroots
# make install   link this folder into the Mod folder of the FreeCAD that is here; make bench   speeds as ratios to peers
PYTHON := .venv/bin/python
FIVEAXIS := $(PYTHON) -m freecad_fiveaxis

.PHONY: help demo test lint core oldest slow linuxcnc freecad sitting test-matrix install bench clean

help:
	@sed -n '2,4s/^# //p' Makefile

demo:
	@scripts/prepare demo
	@scripts/demo

test: lint core slow linuxcnc freecad sitting

lint:
	@scripts/prepare test
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy

core:
	@scripts/prepare test
	$(PYTHON) -m pytest -n 2 -m "not rs274 and not slow"

oldest: # the core ring on the oldest numpy and scipy that pyproject.toml allows
	@scripts/prepare oldest
	[ ! -e .cache/oldest/.complete ] || .cache/oldest/bin/python -m pytest -n 2 -m "not rs274 and not slow" -p no:cacheprovider

slow: # what takes long to prove: dense samples of many blocks, dynamic programmes, every cure on every machine, real meshes
	@scripts/prepare test
	@scripts/prepare meshes
	$(PYTHON) -m pytest -n 2 -m "slow and not rs274"

linuxcnc:
	@scripts/prepare test
	@scripts/prepare linuxcnc
	$(PYTHON) -m pytest -m rs274
	$(PYTHON) -m pytest -m linuxcnc tests/linuxcnc

freecad:
	@scripts/prepare test
	@scripts/prepare freecad
	$(PYTHON) -m pytest tests/freecad/test_run.py
	tests/freecad/run all

sitting: # FreeCAD as a user starts it, by mouse and keys alone; pictures and table.md in out/sitting
	@scripts/prepare test
	@scripts/prepare sitting
	$(PYTHON) -m pytest tests/sitting/test_run.py
	tests/sitting/run short

test-matrix:
	@scripts/prepare test
	@scripts/prepare freecad-pytest
	scripts/freecad_chroot trixie
	scripts/freecad_chroot trixie tests/sitting/run short
	scripts/freecad_chroot forky
	scripts/freecad_chroot forky tests/sitting/run short

install:
	@scripts/install

bench:
	@scripts/prepare bench
	@scripts/prepare meshes
	$(PYTHON) benchmarks/run.py

clean:
	rm -rf out build .pytest_cache .mypy_cache .ruff_cache .hypothesis
