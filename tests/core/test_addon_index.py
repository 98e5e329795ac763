# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's Addon Manager shows before anyone installs: package.xml, the page it names, and the pictures
there.

The rules are those of FreeCAD's Addon Academy (Manifest, Metadata & discoverability, Overview page).
"""

import re
import struct
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
PACKAGE = ET.parse(ROOT / "package.xml").getroot()
HOST = "https://github.com/freecad-fiveaxis/freecad-fiveaxis"
RAW = "https://raw.githubusercontent.com/freecad-fiveaxis/freecad-fiveaxis/main/"
WIDEST = 1024
"""Pixels: the Addon Manager's page is 400 to 600 wide, and wider pictures scroll sideways."""
KNOWN_TO_ALL = {"part", "mesh", "draft", "fem", "partdesign", "sketcher", "spreadsheet", "techdraw"}
"""FreeCAD's own workbenches that the Addon Managers of 0.20 to 1.1 know; 0.20 takes any other name for a
Python package."""
PAGES = [ROOT / name for name in ("README.md", "Overview.md", "CONTRIBUTING.md", "SECURITY.md")] + sorted(
    (ROOT / "docs").rglob("*.md")
)
PICTURE, LINK = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)"), re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)")


def all_of(tag, inside=PACKAGE):
    return inside.findall(SPACE + tag)


def test_every_url_has_a_known_type_and_a_secure_address():
    urls = {url.get("type"): url for url in all_of("url")}
    assert set(urls) == {"repository", "bugtracker", "documentation", "readme"}
    assert all(url.text.startswith("https://") for url in urls.values())
    assert urls["repository"].get("branch") == "main" and urls["repository"].text == HOST


def test_the_readme_is_raw_and_is_a_page_of_this_folder():
    [address] = [url.text for url in all_of("url") if url.get("type") == "readme"]
    assert address.startswith(f"{HOST}/raw/main/")
    assert (ROOT / address.removeprefix(f"{HOST}/raw/main/")).is_file()


def test_versions_and_dates_have_the_form_that_is_compared():
    assert re.fullmatch(r"\d+\.\d+\.\d+", PACKAGE.findtext(SPACE + "version"))
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", PACKAGE.findtext(SPACE + "date"))
    assert (
        re.fullmatch(r"\d+\.\d+\.\d+", PACKAGE.findtext(SPACE + "freecadmin"))
        and PACKAGE.find(SPACE + "freecadmax") is None
    )
    python = re.search(r'requires-python = ">=([\d.]+)"', (ROOT / "pyproject.toml").read_text())[1]
    assert PACKAGE.findtext(SPACE + "pythonmin") == python


def test_dependencies_say_what_they_are():
    kinds = {depend.text: depend.get("type") for depend in all_of("depend")}
    assert {"numpy", "scipy", "part", "mesh"} <= set(kinds)
    assert set(kinds.values()) == {"internal", "python"}
    assert {name for name, kind in kinds.items() if kind == "internal"} <= KNOWN_TO_ALL


def test_people_and_licence_are_named():
    assert all("@" in person.get("email") for person in all_of("maintainer") + all_of("author"))
    [licence] = all_of("license")
    assert (ROOT / licence.get("file")).is_file() and licence.text == "LGPL-2.1-or-later"


def test_the_workbench_has_few_tags_in_small_letters_and_its_own_class():
    bench = PACKAGE.find(f"{SPACE}content/{SPACE}workbench")
    tags = [tag.text for tag in all_of("tag", bench)]
    assert 3 <= len(tags) <= 7 and all(tag == tag.lower() and " " not in tag for tag in tags)
    assert f"class {bench.findtext(SPACE + 'classname')}(" in (
        ROOT / "freecad_fiveaxis/gui/workbench.py"
    ).read_text(encoding="utf-8")
    assert (ROOT / bench.findtext(SPACE + "subdirectory") / bench.findtext(SPACE + "icon")).is_file()


def test_the_machines_are_offered_to_cam():
    machines = PACKAGE.find(f"{SPACE}content/{SPACE}machine")
    assert list((ROOT / machines.findtext(SPACE + "subdirectory")).glob("*.fcm"))


def test_the_overview_needs_nothing_but_itself():
    """The Addon Manager resolves no relative address and renders little HTML."""
    page = (ROOT / "Overview.md").read_text(encoding="utf-8")
    addresses = PICTURE.findall(page) + LINK.findall(page)
    assert len(PICTURE.findall(page)) >= 2
    assert all(address.startswith("https://") for address in addresses)
    assert not re.search(r"<\w|- \[ \]|~~|\[\^", page)


def test_pictures_of_the_overview_are_found_by_whoever_reads_it_elsewhere():
    pictures = PICTURE.findall((ROOT / "Overview.md").read_text(encoding="utf-8"))
    assert pictures and all(address.startswith(RAW) for address in pictures)
    assert not [address for address in pictures if not (ROOT / address.removeprefix(RAW)).is_file()]


def test_pictures_of_the_readme_show_in_every_clone():
    pictures = PICTURE.findall((ROOT / "README.md").read_text(encoding="utf-8"))
    assert pictures and not [address for address in pictures if not (ROOT / address).is_file()]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_no_link_to_this_project_leads_nowhere(page):
    content = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    addresses = [address.partition("#")[0] for address in PICTURE.findall(content) + LINK.findall(content)]
    inside = [
        address.removeprefix(f"{HOST}/blob/main/")
        for address in addresses
        if address.startswith(f"{HOST}/blob/main/")
    ]
    beside = [
        address
        for address in addresses
        if address and "://" not in address and not address.startswith("mailto:")
    ]
    assert not [address for address in inside if not (ROOT / address).exists()]
    assert not [address for address in beside if not (page.parent / address).exists()]


@pytest.mark.parametrize("picture", sorted((ROOT / "docs" / "images").iterdir()), ids=lambda path: path.name)
def test_pictures_fit_the_page(picture):
    assert picture.stat().st_size < (2_500_000 if picture.name == "film.png" else 250_000)
    head = picture.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n", "PNG is sharp, and FreeCAD's Qt can always read it"
    assert struct.unpack(">I", head[16:20])[0] <= WIDEST
    assert picture.name == picture.name.lower() and "_" not in picture.name


def test_what_is_tested_elsewhere_is_what_the_package_promises():
    """Every Python of the classifiers on three systems, and the oldest numpy and scipy."""
    promised, tried = (
        (ROOT / name).read_text(encoding="utf-8") for name in ("pyproject.toml", ".github/workflows/core.yml")
    )
    pythons = re.findall(r"Python :: (3\.\d+)", promised)
    assert re.findall(r'"(3\.\d+)"', re.search(r"^ +python: \[(.+)\]$", tried, re.MULTILINE)[1]) == pythons
    assert (
        re.search(r"^ +os: \[(.+)\]$", tried, re.MULTILINE)[1]
        == "ubuntu-latest, windows-latest, macos-latest"
    )
    oldest = [f"{name}=={version}.*" for name, version in re.findall(r'"(numpy|scipy)>=([\d.]+)"', promised)]
    assert len(oldest) == 2 and tried.count(" ".join(oldest)) == 3


def test_no_system_changes_the_line_ends():
    assert "* -text" in (ROOT / ".gitattributes").read_text().splitlines()
    scripts = [path for folder in ("scripts", ".ci") for path in (ROOT / folder).iterdir() if path.is_file()]
    assert len(scripts) > 4 and not [path for path in scripts if b"\r" in path.read_bytes()]
