# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command has a help page; what the pages call a field is what the window calls it; no link leads
nowhere."""

import re

import pytest
from translation_script import ROOT, translations

pytestmark = pytest.mark.texts

PAGES = sorted((ROOT / "docs" / "commands").glob("*.md"))
SHOWN = {"Fields", "Properties", "Properties of the NC output", "Properties of the view"}


@pytest.fixture(scope="module")
def texts():
    """Every text of the window."""
    return {text for _, text in translations.texts()}


def named_fields(page):
    """The first cells of the tables in the sections that list what the window shows."""
    for section in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        title, _, body = section.partition("\n")
        rows = (
            [line.split("|")[1].strip() for line in body.splitlines() if line.startswith("|")]
            if title in SHOWN
            else []
        )
        yield from (
            name.strip()
            for row in rows
            if row not in ("field", "property", "---")
            for name in re.split(r", (?=Colour)", row)
        )


def test_every_command_has_its_page():
    commands = (ROOT / "freecad_fiveaxis" / "gui" / "commands").glob("*.py")
    names = [
        found
        for path in commands
        for found in re.findall(r'NAME = "(\w+)"', path.read_text(encoding="utf-8"))
    ]
    assert len(names) >= 6
    assert sorted(names) == [path.stem for path in PAGES]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_pages_name_the_fields_as_the_window_does(page, texts):
    content = page.read_text(encoding="utf-8")
    assert {"Use", "Messages"} <= set(re.findall(r"^## (.+)$", content, re.MULTILINE))
    assert re.match(r"# (.+)", content).group(1) in texts
    unknown = [name for name in named_fields(content) if name not in texts]
    assert not unknown, f"{page.name}: the window has no {unknown}"


def test_a_field_that_is_gone_would_be_noticed(texts):
    assert list(
        named_fields("# X\n## Fields\n\n| field | what |\n|---|---|\n| Number of wings | none |\n")
    ) == ["Number of wings"]
    assert "Number of wings" not in texts


@pytest.mark.parametrize("page", [*PAGES, ROOT / "docs" / "workbench.md"], ids=lambda path: path.stem)
def test_links_lead_somewhere(page):
    links = re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8"))
    assert page.stem != "workbench" or len(links) > 6
    assert not [link for link in links if "://" not in link and not (page.parent / link).exists()]
