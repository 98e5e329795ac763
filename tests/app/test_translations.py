# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the property editor shows of our objects is translated: each property's name, its group and its
documentation."""

import sys
from pathlib import Path

import pytest

pytest.importorskip("FreeCAD")
from conftest import FAST

from freecad_fiveaxis import app

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "core"))
from translation_script import translations  # noqa: E402

FREECADS_OWN = {
    "ExpressionEngine",
    "Label",
    "Label2",
    "Visibility",
    "Proxy",
    "Placement",
    "Mesh",
    "Path",
    "_ElementMapVersion",
}
"""Properties that every object of that type has."""


GERMAN = translations.read_ts(
    (ROOT / "resources" / "translations" / "FiveAxis_de.ts").read_text(encoding="utf-8")
)


def shown_texts(obj):
    for name in set(obj.PropertiesList) - FREECADS_OWN:
        if "Hidden" not in obj.getEditorMode(name) and obj.getGroupOfProperty(name):
            yield translations.shown_name(name)
            yield translations.shown_name(obj.getGroupOfProperty(name))
            yield obj.getDocumentationOfProperty(name)


def test_every_property_of_every_object_is_translated(doc, ball, tmp_path):
    path = app.create_toolpath(doc, ball, **FAST)
    output = app.post_process(path, tmp_path / "ball.ngc")
    audit = app.audit(doc, tmp_path / "ball.ngc", "trunnion_ac", tolerance=50)
    objects = [
        path.Mesh,
        path,
        output,
        app.annotate(path),
        audit,
        app.setup_map(path, region=(5, 0, 0), grid=(2, 1, 1)),
    ]
    objects += [app.left_map(path), app.reach_map((ball, ["Face1"]), machine="trunnion_ac", cutter="ball:6")]
    for obj in objects:
        texts = set(shown_texts(obj))
        assert len(texts) > 5, obj.Name
        assert not sorted(text for text in texts if text and not GERMAN.get(("App::Property", text))), (
            obj.Name
        )


def test_a_property_without_translation_would_be_noticed(doc):
    obj = doc.addObject("App::FeaturePython", "Other")
    obj.addProperty("App::PropertyLength", "WingSpan", "Wings", "How wide the wings are")
    missing = {text for text in shown_texts(obj) if not GERMAN.get(("App::Property", text))}
    assert missing == {"Wing Span", "Wings", "How wide the wings are"}
