# SPDX-License-Identifier: LGPL-2.1-or-later
"""``scripts/translations`` as a module, for the tests of it and of what it extracts."""

import importlib.util
import sys
from functools import cache
from importlib.machinery import SourceFileLoader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def load():
    loader = SourceFileLoader("translations_script", str(ROOT / "scripts" / "translations"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    written, sys.dont_write_bytecode = sys.dont_write_bytecode, True  # no cache beside the scripts
    try:
        loader.exec_module(module)
    finally:
        sys.dont_write_bytecode = written
    return module


translations = load()
translations.texts = cache(translations.texts)  # of the files as they are; no test changes them
