# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arguments of a wrong type in macros: an error of ours that says what is meant, and a document as it was."""

import pytest
from conftest import FAST, UNCURED

import freecad_fiveaxis.app as app
from freecad_fiveaxis.core.base.errors import FiveAxisError

CALLS = {
    "tessellate": [(None,), (3,), ("Box",), ([],), ("part", 5), ("part", b"\xff/x.stl"), ("part", ["a.stl"])],
    "create_setup": [(None,), ("Doc",), (3,), ("doc", 5), ("doc", "Job")],
    "create_toolpath": [(None, "part"), ("doc", None), ("doc", 5), ("doc", "Box"), ("doc", ()), ("doc", ("part",)), ("doc", ("part", 3)),
                        ("doc", ("part", [3])), (7, "part"), ("Doc", "part")],
    "post_process": [(None, "o.ngc"), ("path", None), ("path", 5), ("path", b"o.ngc"), (3, "o.ngc"), ("part", "o.ngc"), ("path", "o.ngc", False, 5),
                     ("path", "o.ngc", False, {"x.txt": 3})],
    "preview_passes": [(None,), (3,), ("Box",), ((),), (("part", 3),), (("part", [3]),)],
    "annotate": [(None,), (3,), ("part",), ("Toolpath",)],
    "left_map": [(None,), (3,), ("part",), ("Toolpath",)],
    "audit": [(None, "a.ngc", "trunnion_ac"), ("doc", None, "trunnion_ac"), ("doc", 5, "trunnion_ac"), ("doc", "a.ngc", None), ("doc", "a.ngc", 5),
              ("doc", ["a.ngc"], "trunnion_ac"), (3, "a.ngc", "trunnion_ac")],
    "setup_map": [(None,), (3,), ("part",), ("Toolpath",)],
    "apply_setup": [(None,), (3,), ("part",), ("path",)],
    "compare": [(None, ["trunnion_ac"]), ("part", ["trunnion_ac"]), ("path", None), ("path", 5), ("path", [5]), ("path", "trunnion_ac", 5),
                ("path", ["trunnion_ac"], [5]), ("path", ["trunnion_ac"], (), "long")],
    "recover": [(None, None), (5, "a.ngc"), ("a.apt", 5), ("a.apt", ["b"]), ("a.apt", "a.ngc", 5)],
    "prove_signs": [(None, "trunnion_ac"), (5, "trunnion_ac"), ("o.ngc", None), ("o.ngc", 5), ("o.ngc", "trunnion_ac", 5), (["o.ngc"], "trunnion_ac")],
    "import_machine": [(None,), (5,), (["a.ini"],), ("a.ini", 5), ("a.ini", None, 5)],
}  # fmt: skip


@pytest.fixture
def given(doc, tmp_path, monkeypatch):
    """What stands for the words of CALLS."""
    monkeypatch.chdir(tmp_path)
    for name in ("a.ngc", "a.apt", "a.ini"):
        (tmp_path / name).write_text("G0 X0\n")
    part = doc.addObject("Part::Box", "Part")
    part.Height = 4
    doc.recompute()
    path = app.create_toolpath(doc, part, **FAST, **UNCURED)
    return {"doc": doc, "part": part, "path": path}


@pytest.mark.parametrize("name", CALLS)
def test_an_argument_of_a_wrong_type_is_refused_and_the_document_is_as_it_was(name, given, tmp_path):
    before, files = [one.Name for one in given["doc"].Objects], sorted(tmp_path.iterdir())
    wrong = []
    for call in CALLS[name]:
        arguments = [_filled(one, given) for one in call]
        try:
            getattr(app, name)(*arguments)
        except FiveAxisError as error:
            if len(str(error).splitlines()) != 1:
                wrong.append((call, str(error)))
        except Exception as error:
            wrong.append((call, repr(error)))
        else:
            wrong.append((call, "taken"))
    assert not wrong, "\n".join(map(str, wrong))
    assert [one.Name for one in given["doc"].Objects] == before and sorted(tmp_path.iterdir()) == files


def _filled(one, given):
    if isinstance(one, tuple):
        return tuple(_filled(part, given) for part in one)
    return given.get(one, one) if isinstance(one, str) else one
