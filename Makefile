# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo   mills a saddle whose middle passes the singularity; results in out/
# make test   every ring of tests, side by side, on the FreeCAD that is installed; make test-all   also on FreeCAD 1.0 and 1.1, large samples
# make install   link this folder into the Mod folder of the FreeCAD that is here; make bench   speeds as ratios to peers
PYTHON := .venv/bin/python
FIVEAXIS := $(PYTHON) -m freecad_fiveaxis

TWO := -n 2 --dist worksteal
# half of the tests each, in their order, so that what the tests of a file share is made once; who is done takes of the other's half
SLOWEST := --durations=10

.PHONY: help demo test test-all lint core oldest slow large linuxcnc freecad runner headless window sitting test-matrix trixie forky \
    chroots install bench clean

help:
	@sed -n '2,4s/^# //p' Makefile

demo:
	@bash scripts/prepare demo
	@bash scripts/demo

test:
	@bash scripts/prepare test
	@bash scripts/rings lint core slow headless -- window linuxcnc sitting runner

test-all: # what must pass before anything lands
	@bash scripts/prepare test
	@bash scripts/rings lint core slow headless large oldest demo -- chroots window forky trixie linuxcnc sitting runner

lint:
	@bash scripts/prepare test
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy

core:
	@bash scripts/prepare test
	$(PYTHON) -m pytest $(TWO) $(SLOWEST) -m "not rs274 and not slow"

oldest: # the core ring on the oldest numpy and scipy that pyproject.toml allows
	@bash scripts/prepare oldest
	[ ! -e .cache/oldest/.complete ] || .cache/oldest/bin/python -m pytest $(TWO) $(SLOWEST) -m "not rs274 and not slow" -p no:cacheprovider

slow: # what takes long to prove: dense samples of many blocks, dynamic programmes, every cure on every machine, real meshes
	@bash scripts/prepare test
	@bash scripts/prepare meshes
	$(PYTHON) -m pytest $(TWO) $(SLOWEST) -m "slow and not large and not rs274"

large: # more samples of what the slow ring proves by one of each kind
	@bash scripts/prepare test
	@bash scripts/prepare meshes
	$(PYTHON) -m pytest $(TWO) $(SLOWEST) -m large

linuxcnc:
	@bash scripts/prepare test
	@bash scripts/prepare linuxcnc
	$(PYTHON) -m pytest $(SLOWEST) -m rs274
	$(PYTHON) -m pytest $(SLOWEST) -m linuxcnc tests/linuxcnc

freecad: runner headless window

runner: # of the two rings below, from outside FreeCAD: what it says of tests that fail, hang and crash
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	$(PYTHON) -m pytest $(SLOWEST) tests/freecad/test_run.py

headless:
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run headless

window:
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run window

sitting: # FreeCAD as a user starts it, by mouse and keys alone; pictures and table.md in out/sitting
	@bash scripts/prepare test
	@bash scripts/prepare sitting
	$(PYTHON) -m pytest $(SLOWEST) tests/sitting/test_run.py
	bash tests/sitting/run short

test-matrix: trixie forky

trixie forky: # the rings in FreeCAD once more, in a chroot of that Debian: trixie has FreeCAD 1.0, forky 1.1
	@bash scripts/prepare test
	@bash scripts/prepare freecad-pytest
	bash scripts/freecad_chroot $@
	bash scripts/freecad_chroot $@ bash tests/sitting/run short

chroots: # made ahead, while other rings run
	bash scripts/freecad_chroot trixie bash -c true
	bash scripts/freecad_chroot forky bash -c true

install:
	@bash scripts/install

bench:
	@bash scripts/prepare bench
	@bash scripts/prepare meshes
	$(PYTHON) benchmarks/run.py

clean:
	rm -rf out build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
