# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo   mills a saddle whose middle passes the singularity; results in out/
# make test   what shows in eight minutes that all is well: lint, core, LinuxCNC's interpreter, the FreeCAD that is installed
# make test-all   every test: also what takes long to prove, every window, FreeCAD 1.0 and 1.1
# make changed   the tests that reach what has changed since the last commit, nearest first, for a minute
# make docs   the reference of the programming interface, in out/docs
# make install   link this folder into the Mod folder of the FreeCAD that is here
# make release   the branch (BRANCH=release) that FreeCAD's Addon Manager installs from: HEAD without tests, benchmarks and examples
# make bench   speeds as ratios to peers; make bench-window   those of the 3D view, inside FreeCAD's window
PYTHON := .venv/bin/python
FIVEAXIS := $(PYTHON) -m freecad_fiveaxis

unexport PYTHONDONTWRITEBYTECODE
# where it is set, each process of each test compiles the whole package again, a tenth of what the core ring takes

# glibc gives each column back to the system and asks for it anew; a test's process keeps it, as the command line does (core/base/memory.py)
export MALLOC_ARENA_MAX := 1
export MALLOC_MMAP_THRESHOLD_ := 268435456
export MALLOC_TRIM_THRESHOLD_ := 268435456
# OpenBLAS waits by spinning: a tenth of what the core ring takes, where two processes of tests share two cores
export OPENBLAS_NUM_THREADS ?= 1

TWO := -n 2 --dist worksteal --capture=sys
# half of the tests each, in their order, so that what the tests of a file share is made once; who is done takes of the other's half.
# What tests print is caught in Python alone: where it is caught in the system too, each of 8,000 tests costs 2 ms more
marked = $(sort $(shell grep -rlE '$(1)' --include='test_*.py' tests/core tests/contracts tests/golden tests/fuzz))
# the files of tests whose marks are these words; to read all others takes longer than some rings (tests/conftest.py looks that none is missed).
# Sorted: the file whose engines take longest to begin lies whole in one half

.PHONY: help demo test test-all changed lint docs core oldest slow large interpreter linuxcnc freecad runner headless headless-short window window-short \
    sitting test-matrix trixie forky chroots install release bench bench-window mutants clean

help:
	@sed -n '2,9s/^# //p' Makefile

demo:
	@bash scripts/prepare demo
	@bash scripts/demo

test:
	@bash scripts/prepare test
	@bash scripts/rings lint core headless-short -- window-short interpreter sitting

test-all: # what must pass before anything lands
	@bash scripts/prepare test
	@bash scripts/rings lint core slow headless large oldest docs demo -- chroots window forky trixie linuxcnc sitting runner

changed:
	@bash scripts/prepare test
	@$(PYTHON) scripts/changed

lint:
	@bash scripts/prepare test
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/codespell
	.venv/bin/mypy

docs: # the reference of the programming interface, in out/docs; what it warns of is an error
	@bash scripts/prepare docs
	$(PYTHON) -W error scripts/reference out/docs

core:
	@bash scripts/prepare test
	$(PYTHON) -m pytest $(TWO) -m "not rs274 and not slow and not thorough"

oldest: # the core's tests, but for those of the project's texts, and of the thorough ones what runs more lines, on the oldest numpy and scipy that pyproject.toml allows
	@bash scripts/prepare oldest
	[ ! -e .cache/oldest/.complete ] || .cache/oldest/bin/python -m pytest $(TWO) -m "not rs274 and not slow and not texts and (not thorough or oldest)" -p no:cacheprovider

slow: # what takes long to prove, and more kinds of what the core ring shows: dense samples, dynamic programmes, real meshes
	@bash scripts/prepare test
	@bash scripts/prepare meshes
	@bash scripts/prepare engines
	$(PYTHON) -m pytest $(TWO) -m "(slow or thorough) and not large and not rs274" $(call marked,slow|thorough|some_in_core)

large: # more samples of what the slow ring proves by one of each kind
	@bash scripts/prepare test
	@bash scripts/prepare meshes
	$(PYTHON) -m pytest $(TWO) -m large $(call marked,large)

interpreter: # LinuxCNC's, over what we post
	@bash scripts/prepare test
	@bash scripts/prepare linuxcnc
	$(PYTHON) -m pytest --capture=sys -m rs274 $(call marked,rs274)

linuxcnc: interpreter # and its whole controller
	@bash scripts/prepare test
	@bash scripts/prepare linuxcnc
	$(PYTHON) -m pytest -m linuxcnc tests/linuxcnc

freecad: runner headless window

runner: # of the rings in FreeCAD, from outside: what it says of tests that fail, hang and crash, and of an add-on that is broken
	@bash scripts/prepare test
	@bash scripts/prepare sitting
	$(PYTHON) -m pytest tests/freecad/test_run.py
	$(PYTHON) -m pytest tests/sitting/test_run.py

headless-short: export FIVEAXIS_MARKED = not thorough
headless-short: # without tests of two seconds and more, which the whole ring has
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run headless

headless:
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run headless

window:
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run window

window-short: # the way of a user once through, in one FreeCAD
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run window -m short tests/freecad/test_loading.py tests/gui

sitting: # FreeCAD as a user starts it, by mouse and keys alone; pictures and table.md in out/sitting
	@bash scripts/prepare test
	@bash scripts/prepare sitting
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

release: # with git alone: the work tree stays as it is
	@bash scripts/release $(BRANCH)

install:
	@bash scripts/install

bench:
	@bash scripts/prepare bench
	@bash scripts/prepare meshes
	@bash scripts/prepare engines
	$(PYTHON) benchmarks/run.py

bench-window: # what a frame of the 3D view takes
	@bash scripts/prepare test
	@bash scripts/prepare freecad
	bash tests/freecad/run window benchmarks/freecad/bench_scene.py

mutants: # lines of the core changed one at a time in a copy: do the tests notice? N=20 of them, ALL=1, SEED=7, FILE=search.py
	@bash scripts/prepare test
	@$(PYTHON) tests/mutation/mutate.py $(if $(ALL),--all) $(if $(N),--count $(N)) $(if $(SEED),--seed $(SEED)) $(if $(FILE),--file $(FILE))

clean:
	rm -rf out build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
