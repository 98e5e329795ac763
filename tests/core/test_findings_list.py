# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of finding is in one list, the list is what is used, and its page is written from it."""

import ast
import functools
import re
import subprocess
import sys
from pathlib import Path

import pytest
from sources import parse_source

from freecad_fiveaxis.core.base import codes
from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
CORE = ROOT / "freecad_fiveaxis" / "core"
ELSEWHERE = {CORE / "base" / "codes.py", CORE / "base" / "findings.py"}
MARKERS = CORE / "report" / "drawing.py"
"""Markers without a finding get one for the list of the window, with the marker's own kind."""


@functools.cache
def trees():
    return {path: parse_source(path) for path in CORE.rglob("*.py") if path not in ELSEWHERE}


def calls(tree, name):
    return [
        one for one in ast.walk(tree) if isinstance(one, ast.Call) and getattr(one.func, "id", "") == name
    ]


def used(tree):
    return {
        one.attr
        for one in ast.walk(tree)
        if isinstance(one, ast.Attribute) and isinstance(one.value, ast.Name) and one.value.id == "Code"
    }


def test_every_finding_of_the_core_is_of_the_list():
    """That the first argument of report_finding is a Code is mypy's to see."""
    assert {path.name for path, tree in trees().items() if calls(tree, "Finding")} == {MARKERS.name}


def test_a_finding_beside_the_list_would_be_noticed():
    assert calls(ast.parse("found = Finding(severity, 'new', text)"), "Finding")


def test_every_code_of_the_list_is_used():
    assert set.union(*map(used, trees().values())) == {one.name for one in Code}


@pytest.mark.parametrize("code", Code, ids=str)
def test_a_code_is_a_word_that_stays_one_wherever_it_goes(code):
    assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", code.value) and code.name == code.value.upper().replace(
        "-", "_"
    )
    assert f"{code}" == str(code) == code == code.value and {code.value: 1}[code] == 1
    assert code.unit in ("", "1", "mm", "mm2", "deg", "deg/mm", "mm/min") and isinstance(
        code.severity, Severity
    )
    assert (
        code.meaning
        and code.meaning[0].islower() == code.meaning[:2].islower()
        and not code.meaning.endswith(".")
    )


def test_meanings_are_distinguished():
    assert len({one.meaning for one in Code}) == len(Code)


def test_severity_and_unit_are_those_of_the_code_unless_given():
    assert report_finding(Code.OVERCUT, "text", 0.5) == Finding(
        Severity.ERROR, "overcut", "text", 0.5, unit="mm"
    )
    assert report_finding(Code.OVERCUT, "text").unit == ""
    given = report_finding(Code.OVERCUT, "text", 0.5, severity=Severity.NOTE, unit="deg")
    assert (given.severity, given.unit) == (Severity.NOTE, "deg")


def test_the_page_is_the_list():
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "pages", "check"], capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (0, "")
    page = (ROOT / "docs" / "findings.md").read_text(encoding="utf-8")
    assert [one.value for one in codes.Code] == re.findall(r"^\| `([a-z0-9-]+)` \|", page, re.MULTILINE)
