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
	@bash scripts/prepare demo
	@bash scripts/demo

test: lint core slow linuxcnc freecad sitting

lint:
	@bash scripts/prepare test
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy

core:
	@bash scripts/prepare test
	$(PYTHON) -m pytest -n 2 -m "not rs274 and not slow"

oldest: # the core ring on the oldest numpy and scipy that pyproject.toml allows
	@bash scripts/prepare oldest
	[ ! -e .cache/oldest/.complete ] || .cache/oldest/bin/python -m pytest -n 2 -m "not rs274 and not slow" -p no:cacheprovider

slow: # what takes long to prove: dense samples of many blocks, dynamic programmes, every cure on every machine, real meshes
	@bash scripts/prepare test
	@bash scripts/prepare meshes
	$(PYTHON) -m pytest -n 2 -m "slow and not rs274"

linuxcnc:
	@bash scripts/prepare test
	@bash scripts/prepare linuxcnc
	$(PYTHON) -m pytest -m rs274
	$(PYTHON) -m pytest -m linuxcnc tests/linuxcnc

freecad:
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	$(PYTHON) -m pytest tests/freecad/test_run.py
	bash tests/freecad/run all

sitting: # FreeCAD as a user starts it, by mouse and keys alone; pictures and table.md in out/sitting
	@bash scripts/prepare test
	@bash scripts/prepare sitting
	$(PYTHON) -m pytest tests/sitting/test_run.py
	bash tests/sitting/run short

test-matrix:
	@bash scripts/prepare test
	@bash scripts/prepare freecad-pytest
	bash scripts/freecad_chroot trixie
	bash scripts/freecad_chroot trixie bash tests/sitting/run short
	bash scripts/freecad_chroot forky
	bash scripts/freecad_chroot forky bash tests/sitting/run short

install:
	@bash scripts/install

bench:
	@bash scripts/prepare bench
	@bash scripts/prepare meshes
	$(PYTHON) benchmarks/run.py

clean:
	rm -rf out build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
