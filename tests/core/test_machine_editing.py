# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine as a draft: what is not changed is written as it stood, what is changed is read as it was given,
and what is wrong is named by its field."""

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest
from mesh_shapes import box, sphere

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import files
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, read_stl, write_stl
from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine, machine_path, save_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.editing import (
    AttachedMeshes,
    add_axis,
    attach_bodies,
    change_axis,
    check_draft,
    free_letters,
    move_axis,
    read_draft,
    remove_axis,
    save_draft,
)

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.fcm"))
ALL = [*list_shipped_machines(), *map(str, EXAMPLES)]
NC = "G21 G90 G94\nG1 X0 Y0 Z30 A0 C0 F1000\nG1 X10 Y5 Z20 A20 C30\nG1 X20 Y5 Z20 A40 C90\nM2\n"


def stem(name):
    return Path(name).stem


def imperial(path):
    """The shipped trunnion in inches, with keys of somebody else's, older spellings and numbers that no
    editor would write."""
    data = json.loads(machine_path("trunnion_ac").read_text(encoding="utf-8"))
    data["machine"] |= {"units": "imperial", "manufacturer": "home", "serial": {"made": [1, 2, 3]}}
    for letter, axis in data["machine"]["axes"].items():
        axis["max_acceleration"] = 12.5
        if letter in "XYZ":
            axis["joint"] = [axis["joint"]["axis"], [0, 0, 0]] if letter == "X" else axis["joint"]
            axis |= {"limits": {"min": -7.3, "max": 11.1, "soft": True}, "max_velocity": 333.3}
        else:
            axis |= {"type": "angular", "joint": [[0.1, 0.2, -1.3], axis["joint"]["axis"]]}
    data["fiveaxis"] |= {
        "gauge_point": [0, 0, 0.7],
        "table": -3.7,
        "no_motion": ["M317"],
        "rapids": "independent",
    }
    data["fiveaxis"]["bodies"] = [
        {"name": "bed", "carrier": "base", "box": {"low": [-3.1, -3, -9], "high": [3.3, 3, -8]}}
    ]
    path.write_text(json.dumps(data), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", ALL, ids=stem)
def test_what_is_not_changed_is_written_as_it_was(name, tmp_path):
    save_draft(read_draft(name), tmp_path / "again.fcm")
    assert load_machine(tmp_path / "again.fcm") == load_machine(name)
    assert json.loads((tmp_path / "again.fcm").read_bytes()) == json.loads(machine_path(name).read_bytes())


def test_keys_and_numbers_that_no_editor_knows_stay(tmp_path):
    given = imperial(tmp_path / "inches.fcm")
    save_draft(read_draft(given), tmp_path / "again.fcm")
    assert json.loads((tmp_path / "again.fcm").read_bytes()) == json.loads(given.read_bytes())


def test_the_same_program_is_written_for_it(tmp_path):
    part = tmp_path / "ball.stl"
    write_stl(from_triangles(sphere(10.0)), part)
    save_draft(read_draft("trunnion_ac"), tmp_path / "mine.fcm")
    save_draft(change_axis(read_draft("trunnion_ac"), 1, point=(0.0, 0.0, -49.0)), tmp_path / "other.fcm")
    programs = []
    for at, machine in enumerate(("trunnion_ac", tmp_path / "mine.fcm", tmp_path / "other.fcm")):
        out = tmp_path / f"{at}.ngc"
        given = [
            "mill",
            part,
            "--machine",
            machine,
            "--cutter",
            "ball:6",
            "--stepover",
            "8",
            "--max-axis-angle",
            "60",
            "-o",
            out,
        ]
        assert cli.main([str(word) for word in [*given, "--quiet"]]) < 2
        programs.append([line for line in out.read_text().splitlines() if not line.startswith("(")])
    assert programs[0] == programs[1]
    assert programs[0] != programs[2], "a point that is 1 mm lower would be noticed"


def write_part(path):
    write_stl(from_triangles(box((0, 0, 0), (30, 20, 10))), path)
    return path


def test_a_change_is_written_in_the_file_s_unit_and_nothing_else_is(tmp_path):
    given = imperial(tmp_path / "inches.fcm")
    draft = read_draft(given)
    at = draft.letters().index("X")
    save_draft(change_axis(draft, at, low=-254.0, max_rate=25.4 * 200), tmp_path / "new.fcm")
    old, new = json.loads(given.read_bytes()), json.loads((tmp_path / "new.fcm").read_bytes())
    assert new["machine"]["axes"]["X"]["limits"] == {"min": pytest.approx(-10.0), "max": 11.1, "soft": True}
    assert new["machine"]["axes"]["X"]["max_velocity"] == pytest.approx(200.0)
    for key in ("limits", "max_velocity"):
        new["machine"]["axes"]["X"][key] = old["machine"]["axes"]["X"][key]
    assert new == old


def test_an_acceleration_is_in_the_file_s_unit_and_may_be_taken_away(tmp_path):
    given = imperial(tmp_path / "inches.fcm")
    draft = read_draft(given)
    found = {axis.letter: axis.max_acceleration for axis in load_machine(given).axes}
    assert found["X"] == pytest.approx(12.5 * 25.4) and found["A"] == pytest.approx(math.radians(12.5))
    x, a = (draft.letters().index(letter) for letter in "XA")
    assert draft.axes[x].max_acceleration == pytest.approx(317.5) and draft.axes[a].max_acceleration == 12.5
    changed = change_axis(change_axis(draft, x, max_acceleration=25.4), a, max_acceleration=None)
    save_draft(changed, tmp_path / "new.fcm")
    old, new = (
        json.loads((tmp_path / name).read_bytes())["machine"]["axes"] for name in ("inches.fcm", "new.fcm")
    )
    assert new["X"].pop("max_acceleration") == pytest.approx(1.0) and "max_acceleration" not in new["A"]
    assert new == {
        letter: {key: value for key, value in axis.items() if letter not in "XA" or key != "max_acceleration"}
        for letter, axis in old.items()
    }
    assert load_machine(tmp_path / "new.fcm").axes[a].max_acceleration == math.inf


def test_every_value_that_can_be_edited_is_read_as_it_was_given(tmp_path):
    draft = read_draft("trunnion_ac")
    draft = replace(
        draft, name="mine", description="built at home", controller="grbl", gauge_point=(0.0, 0.0, 5.0), origin=(1.0, 2.0, 3.0),
        table=-90.0, bodies=(MachineBody("bed", "base", "box", ((-1.0, -1.0, -9.0), (1.0, 1.0, -8.0)), clearance=2.0),),
    )  # fmt: skip
    at = draft.letters().index("A")
    draft = change_axis(
        draft,
        at,
        direction=(-1.0, 0.0, 0.0),
        point=(0.0, 3.0, -40.0),
        low=-math.inf,
        high=90.0,
        max_rate=720.0,
        wrap="modulo",
        max_acceleration=1800.0,
    )
    save_draft(draft, tmp_path / "mine.fcm")
    machine = load_machine(tmp_path / "mine.fcm")
    axis = next(one for one in machine.axes if one.letter == "A")
    assert (machine.name, machine.description, machine.controller, machine.table) == (
        "mine",
        "built at home",
        "grbl",
        -90.0,
    )
    assert (machine.gauge_point, machine.origin) == ((0.0, 0.0, 5.0), (1.0, 2.0, 3.0))
    assert machine.bodies == draft.bodies
    assert (axis.direction, axis.point, axis.low, axis.wrap) == (
        (-1.0, 0.0, 0.0),
        (0.0, 3.0, -40.0),
        -math.inf,
        "modulo",
    )
    assert math.degrees(axis.high) == pytest.approx(90.0) and math.degrees(axis.max_rate) == pytest.approx(
        720.0
    )
    assert math.degrees(axis.max_acceleration) == pytest.approx(1800.0)
    data = json.loads((tmp_path / "mine.fcm").read_bytes())
    assert data["machine"]["axes"]["A"]["max_acceleration"] == 1800.0
    assert data["postprocessor"]["file_name"] == "grbl", "FreeCAD's post goes with the controller"
    assert read_draft(tmp_path / "mine.fcm") == draft


def test_the_order_and_side_of_axes_say_what_carries_what(tmp_path):
    draft = read_draft("trunnion_ac")
    assert draft.letters() == ("C", "A", "X", "Y", "Z")
    swapped = move_axis(draft, 0, 1)
    assert swapped.letters() == ("A", "C", "X", "Y", "Z")
    assert move_axis(draft, 1, 1) == draft, "no table axis stands beyond the base"
    _, problems = check_draft(swapped)
    assert "order" in problems[0].text and problems[0].field == "axes"
    under = change_axis(draft, draft.letters().index("Y"), side="table")
    assert under.letters() == ("C", "A", "Y", "X", "Z")
    save_draft(under, tmp_path / "under.fcm")
    machine = load_machine(tmp_path / "under.fcm")
    assert machine.letters == "CAYXZ" and [one.side for one in machine.axes] == ["table"] * 3 + ["head"] * 2
    axes = json.loads((tmp_path / "under.fcm").read_bytes())["machine"]["axes"]
    assert {letter: axis["parent"] for letter, axis in axes.items()} == {
        "A": "Y",
        "C": "A",
        "X": None,
        "Y": None,
        "Z": "X",
    }


def test_axes_are_added_removed_and_renamed(tmp_path):
    draft = read_draft(machine_path("trunnion_with_bodies"))
    assert free_letters(draft) == ()
    less = remove_axis(draft, draft.letters().index("C"))
    assert free_letters(less) == ("B", "C")
    _, problems = check_draft(less)
    assert any("platter" in one.text and one.field == "bodies.platter" for one in problems), (
        "what it carried has no carrier"
    )
    more = add_axis(less, "C")
    _, problems = check_draft(more)
    assert [one.field for one in problems if one.severity == Severity.ERROR] == [
        "axes.C"
    ] and "rate" in problems[0].text
    more = change_axis(more, 0, max_rate=9000.0)
    save_draft(more, tmp_path / "again.fcm")
    again = load_machine(tmp_path / "again.fcm")
    assert again == replace(load_machine("trunnion_with_bodies"), bodies=again.bodies)
    renamed = change_axis(draft, draft.letters().index("A"), letter="B", direction=(0.0, 1.0, 0.0))
    assert {body.carrier for body in renamed.bodies} == {"base", "B", "C", "spindle"}
    machine, problems = check_draft(renamed)
    assert machine is not None and machine.letters == "CBXYZ" and not problems


def wrong(letter, /, **changes):
    draft = read_draft("trunnion_ac")
    return change_axis(draft, draft.letters().index(letter), **changes)


@pytest.mark.parametrize(
    ("draft", "field", "words"),
    [
        (wrong("X", low=10.0, high=-10.0), "axes.X", "limits min 10 mm is not below max -10 mm"),
        (wrong("A", low=30.0, high=30.0), "axes.A", "limits min 30 deg"),
        (wrong("A", max_rate=0.0), "axes.A", "maximum rate 0 is not positive"),
        (wrong("A", max_rate=None), "axes.A", "axis A has no maximum rate"),
        (wrong("A", max_acceleration=-1.0), "axes.A", "maximum acceleration -0.0174533 is not positive"),
        (wrong("C", direction=(0.0, 0.0, 0.0)), "axes.C", "has no direction"),
        (wrong("C", point=(0.0, 0.0, 2e6)), "axes.C", "joint origin (0, 0, 2e+06) is not finite or beyond"),
        (wrong("C", point=(0.0, math.nan, 0.0)), "axes.C", "joint.origin"),
        (wrong("A", letter="C"), "axes.C", "two axes are called C"),
        (wrong("A", direction=(0.0, 0.0, 1.0)), "axes", "both rotary axes are parallel"),
        (wrong("Y", direction=(1.0, 0.0, 0.0)), "axes", "lie in one plane"),
        (remove_axis(read_draft("trunnion_ac"), 2), "machine", "2 linear"),
        (replace(read_draft("trunnion_ac"), name=" "), "machine", "machine.name: the name is empty"),
        (replace(read_draft("trunnion_ac"), table=1e9), "machine", "table"),
        (replace(read_draft("trunnion_ac"), gauge_point=(1e9, 0.0, 0.0)), "machine", "gauge_point"),
        (replace(read_draft("trunnion_ac"), bodies=(MachineBody("bed", "base", "sphere", ((0.0, 0.0, 0.0),), (0.0,)),)),
         "bodies.bed", "bodies.bed[0].sphere: radius (0.0,) is not above 0"),
        (replace(read_draft("trunnion_ac"), bodies=(MachineBody("bed", "W", "sphere", ((0.0, 0.0, 0.0),), (3.0,)),)),
         "bodies.bed", "W carries no body"),
        (replace(read_draft("trunnion_ac"), bodies=(MachineBody("bed", "base", "file", file="/nowhere.stl"),)),
         "bodies.bed", "/nowhere.stl"),
        (replace(read_draft("trunnion_ac"), bodies=2 * (MachineBody("bed", "base", "sphere", ((0.0, 0.0, 0.0),), (3.0,)),)),
         "machine", "two bodies are called bed"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_by_its_field_and_no_file_is_written(draft, field, words, tmp_path):
    machine, problems = check_draft(draft)
    assert machine is None and problems[0].severity == Severity.ERROR
    assert problems[0].field == field and words in problems[0].text
    with pytest.raises(MachineError, match=r".") as caught:
        save_draft(draft, tmp_path / "new.fcm")
    assert str(caught.value) == problems[0].text and not list(tmp_path.iterdir())


def test_every_wrong_axis_is_named_at_once_and_a_good_machine_has_no_problem():
    draft = change_axis(change_axis(read_draft("trunnion_ac"), 0, max_rate=None), 3, low=9.0, high=1.0)
    _, problems = check_draft(draft)
    assert [one.field for one in problems] == ["axes.C", "axes.Y"]
    machine, problems = check_draft(read_draft("trunnion_ac"))
    assert machine == load_machine("trunnion_ac") and not problems


def test_what_is_left_open_is_requested_and_does_not_keep_the_file_from_being_written(tmp_path):
    draft = replace(wrong("X", high=math.inf), table=None)
    draft = change_axis(draft, draft.letters().index("A"), low=10.0)
    machine, problems = check_draft(draft)
    assert machine is not None
    assert [(one.field, one.severity) for one in problems] == [
        ("axes.A", Severity.WARNING), ("axes.X", Severity.WARNING), ("machine", Severity.NOTE),
    ]  # fmt: skip
    save_draft(draft, tmp_path / "open.fcm")
    assert load_machine(tmp_path / "open.fcm").table is None


def test_a_file_that_is_there_is_never_replaced(tmp_path):
    (tmp_path / "mine.fcm").write_text("mine")
    with pytest.raises(FileError, match="exists already"):
        save_draft(read_draft("trunnion_ac"), tmp_path / "mine.fcm")
    with pytest.raises(FileError):
        save_draft(read_draft("trunnion_ac"), tmp_path / "no" / "mine.fcm")
    assert (tmp_path / "mine.fcm").read_text() == "mine" and len(list(tmp_path.iterdir())) == 1


def test_the_meshes_of_bodies_are_found_from_wherever_the_file_lies(tmp_path, monkeypatch):
    (tmp_path / "old" / "parts").mkdir(parents=True)
    (tmp_path / "new").mkdir()
    write_part(tmp_path / "old" / "parts" / "bed.stl")
    machine = replace(
        load_machine("trunnion_ac"), bodies=(MachineBody("bed", "base", "file", file="parts/bed.stl"),)
    )
    save_machine(machine, tmp_path / "old" / "mine.fcm")
    monkeypatch.chdir(tmp_path)
    draft = read_draft("old/mine.fcm")
    for folder, name in (("old", "parts/bed.stl"), ("new", str(tmp_path / "old" / "parts" / "bed.stl"))):
        save_draft(draft, Path(folder) / "again.fcm")
        data = json.loads((tmp_path / folder / "again.fcm").read_bytes())
        assert data["fiveaxis"]["bodies"] == [{"name": "bed", "carrier": "base", "file": name}]
        assert Path(load_machine(f"{folder}/again.fcm").bodies[0].file).samefile(
            tmp_path / "old" / "parts" / "bed.stl"
        )
    machine, _ = check_draft(draft)
    assert machine.bodies[0].file == str(tmp_path / "old" / "parts" / "bed.stl"), (
        "a picture can read it from anywhere"
    )


def test_what_is_no_machine_makes_no_draft(tmp_path):
    (tmp_path / "bad.fcm").write_text("{}")
    for name in ("trunion_ac", str(tmp_path / "bad.fcm")):
        with pytest.raises(MachineError):
            read_draft(name)
    with pytest.raises(FileError):
        read_draft(str(tmp_path / "none.fcm"))


@pytest.fixture
def attached():
    """The meshes of one session of editing."""
    result = AttachedMeshes()
    yield result
    result.close()


def with_attached(attached, *names):
    """The shipped trunnion with a mesh attached under each name."""
    mesh = from_triangles(box((0, 0, 0), (30, 20, 10)))
    return attach_bodies(read_draft("trunnion_ac"), [(name, mesh) for name in names], "A", attached)


def test_attached_meshes_are_written_beside_the_machine_s_file_and_over_none(attached, tmp_path, monkeypatch):
    (tmp_path / "mine vise.stl").write_text("somebody's")
    monkeypatch.chdir(tmp_path)
    draft = with_attached(attached, "vise", "a/b", "a:b", "A_b")
    assert check_draft(draft)[0] is not None
    save_draft(draft, "mine.fcm", attached)
    attached.close()
    bodies = json.loads((tmp_path / "mine.fcm").read_bytes())["fiveaxis"]["bodies"]
    assert [body["file"] for body in bodies] == [
        "mine vise-2.stl",
        "mine a_b.stl",
        "mine a_b-2.stl",
        "mine A_b-3.stl",
    ]
    assert (tmp_path / "mine vise.stl").read_text() == "somebody's"
    for body in load_machine("mine.fcm").bodies:
        assert [tuple(one) for one in read_stl(body.file).box] == [(0.0, 0.0, 0.0), (30.0, 20.0, 10.0)]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        ["mine.fcm", "mine vise.stl", *(body["file"] for body in bodies)]
    )


def test_where_the_machine_cannot_be_written_no_mesh_is_left(attached, tmp_path, monkeypatch):
    draft = with_attached(attached, "vise")
    (tmp_path / "mine.fcm").write_text("mine")
    with pytest.raises(FileError, match="exists already"):
        save_draft(draft, tmp_path / "mine.fcm", attached)
    with pytest.raises(MachineError, match="carries no body"):
        save_draft(remove_axis(draft, draft.letters().index("A")), tmp_path / "other.fcm", attached)
    place = files._Output.place

    def fail_at_the_machine(output):
        if output.path.endswith(".fcm"):
            raise OSError("no room")
        place(output)

    monkeypatch.setattr(files._Output, "place", fail_at_the_machine)
    with pytest.raises(FileError, match="no room"):
        save_draft(draft, tmp_path / "other.fcm", attached)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.fcm"]


def test_meshes_are_gone_with_the_session_and_others_are_not_taken_for_attached(attached, tmp_path):
    assert not attached.holds(str(write_part(tmp_path / "bed.stl"))) and not attached.holds("")
    body = with_attached(attached, "vise").bodies[0]
    assert attached.holds(body.file) and Path(body.file).exists()
    attached.close()
    attached.close()
    assert not Path(body.file).exists() and not attached.holds(body.file)


def test_what_is_attached_is_named_after_its_label_unlike_what_is_there(attached):
    draft = with_attached(attached, "vise", " vise", "", "vise", "vise 2")
    assert [one.name for one in draft.bodies] == ["vise", "vise 2", "body", "vise 3", "vise 2 2"]
    assert {(one.carrier, one.shape) for one in draft.bodies} == {("A", "file")} and len(
        {one.file for one in draft.bodies}
    ) == 5
