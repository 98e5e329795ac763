# SPDX-License-Identifier: LGPL-2.1-or-later
"""The HTML page: complete, well formed, self-contained, escaped, the same every time; and the thinning of its
plots."""

import base64
import dataclasses
import html.parser
import re
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from report_examples import TRUNNION, TRUNNION_BC, by_hand, dome, empty, figures_of, table2

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.pipeline.settings import build_settings, flat_options, name_units
from freecad_fiveaxis.core.report import as_html
from freecad_fiveaxis.core.report.plot_style import spans, thin
from freecad_fiveaxis.core.report.plots import plots
from freecad_fiveaxis.core.report.views import SAMPLES, _on_plane, _place_real_tip, _to_segment

VOID = {"meta", "img", "br"}
NASTY = "<script>alert('x')</script> & \"part\".stl"


class Page(html.parser.HTMLParser):
    """Every tag closed by its own end tag; the text and attributes collected."""

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.attributes, self.text = [], [], [], ""
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [(tag, name, value) for name, value in attrs]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


@pytest.fixture(scope="module")
def dome_page():
    pytest.importorskip("matplotlib")
    return as_html(dome(passes=8, points=20))


@pytest.fixture
def without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)


def test_the_page_is_well_formed_and_has_every_section(dome_page):
    page = Page(dome_page)
    headings = ["Figures", "Worst blocks", "Axes", "Findings", "Inputs", "The words used here"]
    assert all(title in page.text for title in headings)
    assert page.tags.count("img") == 5 and page.tags.count("h1") == 1 and "script" not in page.tags


def test_inputs_have_their_units_and_the_words_on_rapids_are_true(without_matplotlib):
    chosen = build_settings(
        "mill", "a.stl", {"machine": "trunnion_ac", "cutter": "ball:10", "lead": 5.0, "axis": "0,0,1"}
    )
    figures = dome(passes=2, points=3, inputs=flat_options(chosen), units=name_units(chosen))
    shown = dict(re.findall(r'<th scope="row">([^<]*)</th><td>([^<]*)</td>', as_html(figures)))
    wanted = {
        "feed": "1000 mm/min",
        "clearance": "5 mm",
        "lead": "5 deg",
        "tolerance": "0.01 mm",
        "cutter": "ball:10.0:50.0 (mm)",
        "from": "border",
        "origin": "-",
        "axis": "0, 0, 1",
    }
    assert {name: shown[name] for name in wanted} == wanted
    assert "not judged here" not in as_html(figures)
    assert "held against nothing" in as_html(figures)


def test_an_unclosed_tag_would_be_noticed(dome_page):
    with pytest.raises(AssertionError):
        Page(dome_page.replace("</section>", "", 1))


def test_the_page_fetches_nothing(dome_page):
    page = Page(dome_page)
    assert (
        "http:" not in dome_page
        and "https:" not in dome_page
        and "@import" not in dome_page
        and "url(" not in dome_page
    )
    sources = [value for _, name, value in page.attributes if name in ("src", "href")]
    assert sources and all(value.startswith("data:image/svg+xml;base64,") for value in sources)


def test_every_picture_is_whole_and_says_what_it_shows(dome_page):
    page = Page(dome_page)
    for source in re.findall(r"base64,([^\"]+)", dome_page):
        assert ET.fromstring(base64.b64decode(source)).tag.endswith("svg")
    message = [value for _, name, value in page.attributes if name == "alt"]
    assert len(message) == 5 and all(len(text) > 30 for text in message)


@pytest.mark.thorough
def test_the_same_input_gives_the_same_bytes(dome_page):
    assert as_html(dome(passes=8, points=20)) == dome_page


def test_another_input_gives_another_page(without_matplotlib):
    assert as_html(dome(passes=8, points=20)) != as_html(dome(passes=8, points=21))


def test_without_matplotlib_the_page_says_how_to_get_the_plots(without_matplotlib):
    text = as_html(table2())
    assert "pip install matplotlib" in Page(text).text and "<img" not in text
    assert plots(table2()) == ()


def test_with_matplotlib_it_says_nothing_of_the_kind(dome_page):
    assert "pip install" not in dome_page


def test_foreign_text_is_escaped(without_matplotlib):
    found = (
        Finding(Severity.ERROR, "limit", f"Bad {NASTY}."),
        Finding(Severity.ERROR, "limit", f"Single {NASTY}."),
    )
    machine = dataclasses.replace(TRUNNION, name=NASTY)
    figures = table2(title=NASTY, kind=NASTY, findings=found, inputs={NASTY: NASTY, "list": [NASTY]})
    text = as_html(dataclasses.replace(figures, machine=machine))
    page = Page(text)
    assert "<script" not in text and "script" not in page.tags
    assert page.text.count(NASTY) >= 9


def test_findings_stand_by_severity_the_gravest_first(without_matplotlib):
    found = tuple(
        Finding(kind, code, f"A {kind.name.lower()} text.")
        for kind, code in zip(Severity, ("frames", "open-shell", "limit"), strict=True)
    )
    text = as_html(table2(findings=found))
    places = [text.index(f"A {word} text.") for word in ("error", "warning", "note")]
    assert places == sorted(places)


def test_long_groups_of_findings_are_cut(without_matplotlib):
    found = tuple(Finding(Severity.NOTE, "many", f"Number {i}.") for i in range(40))
    text = as_html(table2(findings=found))
    assert "and 29 more" in text and "Number 10." in text and "Number 11." not in text


def test_the_worst_block_stands_in_its_table(without_matplotlib):
    text = Page(as_html(table2())).text
    assert ("2.12641" in text and "0.93844" in text and "-27.4209" in text) or "-27.421" in text


def test_a_proven_program_is_reported_so(without_matplotlib):
    calm = figures_of(TRUNNION, np.array([[0, 0, 0, 0, 0], [1, 0, 0, 0, 0]], float))
    assert '<li class="good">' in as_html(calm) and 'class="verdict open">CHECK: not checked' in as_html(calm)
    assert 'class="verdict bad"' in as_html(table2())
    assert 'class="verdict open"' in as_html(by_hand(0.0301))


@pytest.mark.oldest
@pytest.mark.thorough
def test_pages_of_odd_programs_are_built_too():
    pytest.importorskip("matplotlib")
    still = figures_of(TRUNNION, np.zeros((3, 5)))
    spin = figures_of(TRUNNION, np.array([[5.0, 0, 0, 0, 30], [5, 0, 0, 360, 30]]))
    rapids = figures_of(TRUNNION, np.zeros((3, 5)), np.full(3, 3, np.int8))
    for figures, count in ((empty(), 0), (rapids, 0), (still, 3), (spin, 5), (dome(TRUNNION_BC, 2, 8), 5)):
        assert Page(as_html(figures)).tags.count("img") == count


# ---------------------------------------------------------------------------------------------- what is drawn


@given(st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=300), st.integers(1, 40))
@settings(deadline=None)
def test_thinning_keeps_the_extremes_the_ends_and_the_order(values, bins):
    values = np.array(values)
    rows = thin(values, bins)
    assert (np.diff(rows) > 0).all() and len(rows) <= max(
        2 * bins + 2, len(values) if len(values) <= 2 * bins else 0
    )
    assert rows[0] == 0 and rows[-1] == len(values) - 1
    assert values[rows].max() == values.max() and values[rows].min() == values.min()


def test_every_kth_row_would_lose_the_worst():
    values = np.zeros(100_001)
    values[77_777] = 1.0
    assert values[:: len(values) // 1200].max() == 0.0
    assert values[thin(values)].max() == values[thin(values, least=False)].max() == 1.0


def test_spans_cover_exactly_the_chosen_blocks():
    chosen = np.zeros(101, bool)
    chosen[[0, 10, 11, 12, 50]] = True
    x = np.arange(101.0) + 7
    assert spans(chosen, x, bins=1000) == [(7.0, 0.1), (16.0, 3.0), (56.0, 1.0)]
    assert spans(np.zeros(5, bool), x[:5]) == []


def test_near_spans_become_one():
    chosen = np.zeros(10_001, bool)
    chosen[100:400:2] = True
    ((start, width),) = spans(chosen, np.arange(10_001.0), bins=100)
    assert (start, start + width) == (99.0, 398.0)


def test_the_worst_block_is_drawn_to_its_true_distances():
    figures = table2()
    u = np.append(np.linspace(0, 1, SAMPLES), figures.deviation.u_segment[1])
    curve = _place_real_tip(figures.kinematics, figures.program.words[0], figures.program.words[1], u)
    flat, chord = _on_plane(curve)
    np.testing.assert_allclose(curve[[0, SAMPLES - 1]], figures.tip, atol=1e-9)
    assert chord == pytest.approx(1.122, abs=1e-3)
    np.testing.assert_allclose(flat[SAMPLES - 1], (chord, 0.0), atol=1e-9)
    off = _to_segment(curve, curve[0], curve[SAMPLES - 1])
    assert off.max() == pytest.approx(2.12642, abs=2e-5)
    in_plane = _to_segment(np.column_stack([flat, np.zeros(len(flat))]), np.zeros(3), np.array([chord, 0, 0]))
    assert (in_plane <= off + 1e-9).all() and in_plane[-1] > 0.999 * off[-1]
