# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine files: what is read, what is written, and the one clear line for everything that cannot be used."""

from __future__ import annotations

import copy
import json
import math
import re
from dataclasses import replace

import pytest

from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.machine import (
    FARTHEST,
    Axis,
    Machine,
    list_shipped_machines,
    load_machine,
    save_machine,
)
from freecad_fiveaxis.core.machine.machine_file import machine_folder


@pytest.fixture
def data():
    """A complete file as an object, to be spoilt."""
    return json.loads((machine_folder() / "trunnion_ac.fcm").read_text(encoding="utf-8"))


@pytest.fixture
def load(tmp_path):
    """Write an object (or bytes) to a file and load it as a machine."""

    def write_and_load(content):
        path = tmp_path / "machine.fcm"
        path.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
        return load_machine(path)

    return write_and_load


def at(data, key):
    """The object that holds a dotted key, and the last part of it."""
    *way, last = key.split(".")
    for part in way:
        data = data[part]
    return data, last


def refused(load, content, *words):
    """The one line with which a file is refused; it names the file and each of ``words``."""
    with pytest.raises(MachineError) as caught:
        load(content)
    message = str(caught.value)
    assert "\n" not in message and "machine.fcm" in message
    for word in words:
        assert word in message, message
    return message


# What is read.


def test_the_ten_machines_come_with_the_program():
    assert list_shipped_machines() == (
        "fork_head_bc",
        "head_b_table_c",
        "head_table_with_bodies",
        "linuxcnc_xyzac_trt",
        "linuxcnc_xyzbc_trt",
        "mikron_ucp710",
        "nutating_table_b45",
        "trunnion_ac",
        "trunnion_bc",
        "trunnion_with_bodies",
    )


def test_axes_come_in_the_order_from_work_to_tool():
    orders = {name: load_machine(name).letters for name in list_shipped_machines()}
    assert orders == {
        "fork_head_bc": "XYZCB",
        "head_b_table_c": "CXYZB",
        "head_table_with_bodies": "CXYZB",
        "linuxcnc_xyzac_trt": "CAXYZ",
        "linuxcnc_xyzbc_trt": "CBXYZ",
        "mikron_ucp710": "CAXYZ",
        "nutating_table_b45": "CBXYZ",
        "trunnion_ac": "CAXYZ",
        "trunnion_bc": "CBXYZ",
        "trunnion_with_bodies": "CAXYZ",
    }


def test_angles_become_radians_and_rates_stay_per_minute():
    first, second = load_machine("trunnion_bc").rotary
    assert (first.letter, second.letter) == ("C", "B")
    assert (first.low, first.high) == (math.radians(-720), math.radians(720))
    assert second.max_rate == math.radians(5400)
    assert load_machine("trunnion_bc").linear[0].max_rate == 30000


def test_a_limit_of_99999_is_none():
    axis = load_machine("trunnion_ac").rotary[0]
    assert (axis.low, axis.high) == (-math.inf, math.inf)


def test_the_sides_are_those_of_the_roles():
    assert [axis.side for axis in load_machine("head_b_table_c").axes] == [
        "table",
        "table",
        "head",
        "head",
        "head",
    ]
    assert load_machine("head_b_table_c").has_head and not load_machine("trunnion_ac").has_head


def test_descriptions_place_the_trunnion_where_the_file_does():
    named = 0
    for name in list_shipped_machines():
        machine = load_machine(name)
        stated = re.search(r"axis lies (\d+) mm (above|below) the table's face", machine.description)
        if stated:
            high = {"above": 1.0, "below": -1.0}[stated[2]] * float(stated[1])
            trunnion = next(axis for axis in machine.rotary if axis.letter in "AB")
            assert trunnion.point[2] - machine.table == high, name
            named += 1
    assert named == 2


def test_inches_are_converted_and_angles_are_not(data, load):
    data["machine"]["units"] = "imperial"
    data["fiveaxis"]["origin"] = [1, 2, 3]
    metric, imperial = load_machine("trunnion_ac"), load(data)
    assert imperial.origin == pytest.approx((25.4, 50.8, 76.2))
    for in_mm, in_inch in zip(metric.axes, imperial.axes, strict=True):
        factor = 1.0 if in_mm.rotary else 25.4
        assert in_inch.point == tuple(25.4 * value for value in in_mm.point)
        assert (in_inch.low, in_inch.high) == (in_mm.low * factor, in_mm.high * factor)
        assert in_inch.max_rate == in_mm.max_rate * factor
        assert in_inch.direction == in_mm.direction


def test_a_limit_is_judged_in_millimetres_in_both_units(data, load, tmp_path):
    data["machine"]["units"] = "imperial"
    data["machine"]["axes"]["X"]["limits"] = {"min": -3000, "max": 4000}
    machine = load(data)
    axis = machine.axes[machine.letters.index("X")]
    assert (axis.low, axis.high) == (-3000 * 25.4, math.inf)
    save_machine(machine, tmp_path / "metric.fcm")
    assert load_machine(tmp_path / "metric.fcm") == machine


def test_both_forms_of_a_joint_are_the_same(data, load):
    expected = load(data)
    for axis in data["machine"]["axes"].values():
        axis["joint"] = [axis["joint"]["origin"], axis["joint"]["axis"]]
    assert load(data) == expected
    for letter in "XYZ":  # older files: a linear axis's direction first
        data["machine"]["axes"][letter]["joint"].reverse()
    assert load(data) == expected


def test_angular_is_the_old_word_for_rotary(data, load):
    expected = load(data)
    data["machine"]["axes"]["A"]["type"] = "angular"
    assert load(data) == expected


def test_directions_are_built_unit(data, load):
    data["machine"]["axes"]["A"]["joint"]["axis"] = [3, 0, -4]
    assert load(data).rotary[1].direction == (0.6, 0.0, -0.8)


SPARE = ["output", "postprocessor", "processing", "freecad_version", "fiveaxis"]
SPARE += [f"fiveaxis.{key}" for key in ("origin", "gauge_point", "singular_cone", "controller")]
SPARE += [
    f"machine.{key}" for key in ("kinematics", "toolheads", "description", "manufacturer", "axes.X.sequence")
]
SPARE += [
    f"machine.axes.A.{key}" for key in ("wrap_strategy", "allow_flip", "solution_preference", "sequence")
]


@pytest.mark.parametrize("key", SPARE)
def test_what_is_not_needed_may_be_missing(data, load, key):
    holder, last = at(data, key)
    del holder[last]
    machine = load(data)
    assert machine.letters == "CAXYZ"
    assert (machine.origin, machine.gauge_point, machine.singular_cone) == (
        (0, 0, 0),
        (0, 0, 0),
        math.radians(5),
    )


def test_unlinked_linear_axes_stand_nearer_to_the_base(data, load):
    """FreeCAD's editor leaves the parents of linear axes empty."""
    axes = data["machine"]["axes"]
    for letter in "XYZ":
        axes[letter]["parent"] = None
        axes[letter]["role"] = "table_linear" if letter == "Y" else "head_linear"
    assert load(data).letters == "CAYXZ"
    axes["C"]["parent"], axes["A"]["parent"] = None, "C"  # and so does its own factory: C carries A
    assert load(data).letters == "ACYXZ"


def test_a_linear_axis_between_the_rotary_ones_is_kept_there(data, load):
    axes = data["machine"]["axes"]
    axes["Y"].update(role="table_linear", parent="A")
    axes["Z"]["parent"] = "X"
    axes["C"]["parent"] = "Y"
    assert load(data).letters == "CYAXZ"


def test_a_byte_order_mark_is_no_obstacle(data, load):
    assert load(b"\xef\xbb\xbf" + json.dumps(data).encode()) == load(data)


# What is written.


@pytest.mark.parametrize("name", list_shipped_machines())
def test_a_shipped_file_is_what_would_be_written(name, tmp_path):
    path = tmp_path / "copy.fcm"
    save_machine(load_machine(name), path)
    assert path.read_text(encoding="utf-8") == (machine_folder() / f"{name}.fcm").read_text(encoding="utf-8")


def test_a_written_file_has_what_freecad_asks_for(tmp_path):
    path = tmp_path / "copy.fcm"
    save_machine(load_machine("head_b_table_c"), path)
    data = json.loads(path.read_text(encoding="utf-8"))
    assert set(data) == {
        "freecad_version",
        "machine",
        "output",
        "postprocessor",
        "processing",
        "version",
        "fiveaxis",
    }
    assert data["machine"]["toolheads"][0]["name"]
    axes = data["machine"]["axes"]
    assert {letter: axis["parent"] for letter, axis in axes.items()} == {
        "X": None,
        "C": "X",
        "Y": None,
        "Z": "Y",
        "B": "Z",
    }
    assert axes["B"]["joint"] == {"origin": [0.0, 0.0, 120.0], "axis": [0.0, 1.0, 0.0]}
    assert axes["B"]["limits"] == {"min": -100.0, "max": 100.0}
    trees = {
        "table": ["X", "C"],
        "head": ["Y", "Z", "B"],
    }  # FreeCAD wants each tree's sequence numbers to differ
    for side, letters in trees.items():
        assert [axes[letter]["sequence"] for letter in letters] == list(range(len(letters)))
        assert all(axes[letter]["role"].startswith(side) for letter in letters)


def test_degrees_come_back_to_the_last_bit(tmp_path):
    machine = load_machine("trunnion_ac")
    for thousandths in range(1, 90000, 997):
        low = math.radians(-thousandths / 1000)
        tilted = replace(
            machine, axes=(machine.axes[0], replace(machine.axes[1], low=low), *machine.axes[2:])
        )
        save_machine(tilted, tmp_path / "tilted.fcm", overwrite=True)
        assert load_machine(tmp_path / "tilted.fcm") == tilted


def test_nothing_is_written_over_unless_reported(tmp_path):
    path = tmp_path / "mine.fcm"
    path.write_text("mine", encoding="utf-8")
    with pytest.raises(FileError, match="exists already"):
        save_machine(load_machine("trunnion_ac"), path)
    assert path.read_text(encoding="utf-8") == "mine"
    save_machine(load_machine("trunnion_ac"), path, overwrite=True)
    assert load_machine(path) == load_machine("trunnion_ac")
    assert [entry.name for entry in tmp_path.iterdir()] == ["mine.fcm"]


def test_a_folder_that_cannot_be_written_leaves_nothing(tmp_path):
    with pytest.raises(FileError, match="cannot be written"):
        save_machine(load_machine("trunnion_ac"), tmp_path / "no_such_folder" / "m.fcm")
    (tmp_path / "m.fcm").mkdir()
    with pytest.raises(FileError):
        save_machine(load_machine("trunnion_ac"), tmp_path / "m.fcm", overwrite=True)
    assert [entry.name for entry in tmp_path.iterdir()] == ["m.fcm"]


def test_an_axis_without_a_rate_cannot_be_written(tmp_path):
    machine = load_machine("trunnion_ac")
    unknown = replace(machine, axes=(replace(machine.axes[0], max_rate=math.inf), *machine.axes[1:]))
    with pytest.raises(MachineError, match="axis C has no maximum rate"):
        save_machine(unknown, tmp_path / "m.fcm")
    assert not (tmp_path / "m.fcm").exists()


def test_a_name_that_is_none_cannot_be_written():
    with pytest.raises(FileError, match="null character"):
        save_machine(load_machine("trunnion_ac"), "nul\0byte.fcm")


# What is refused.


def test_an_unknown_name_lists_the_known_ones():
    with pytest.raises(MachineError, match="did you mean trunnion_ac") as caught:
        load_machine("Trunion-AC")
    assert all(name in str(caught.value) for name in list_shipped_machines())
    with pytest.raises(MachineError, match="known: fork_head_bc"):
        load_machine("")


def test_a_name_without_the_ending_of_a_file_beside_names_that_file(tmp_path, monkeypatch):
    save_machine(load_machine("trunnion_ac"), tmp_path / "mine.fcm")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(MachineError, match=r"'mine'; did you mean mine\.fcm\? known: "):
        load_machine("mine")


def written(folder, change):
    """A copy of trunnion_ac whose objects ``change`` has changed."""
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text())
    change(data)
    (folder / "m.fcm").write_text(json.dumps(data))
    return folder / "m.fcm"


@pytest.mark.parametrize(
    ("key", "near"), [("tables", "table"), ("safestart", "safe_start"), ("Gauge_Point", "gauge_point")]
)
def test_a_misspelt_key_under_fiveaxis_is_refused_and_a_foreign_one_is_not(key, near, tmp_path):
    def misspell(data):
        data["fiveaxis"][key] = data["fiveaxis"].pop(near)

    with pytest.raises(MachineError, match=rf"fiveaxis\.{key}: no such key; did you mean {near}\?"):
        load_machine(written(tmp_path, misspell))
    foreign = written(tmp_path, lambda data: data["fiveaxis"].update(colour="red", comment="mine"))
    assert load_machine(foreign).axes == load_machine("trunnion_ac").axes


def test_an_axis_without_limits_says_what_to_write(tmp_path):
    with pytest.raises(
        MachineError, match=r'C\.limits: .*add "limits": \{"min": -30, "max": 110\}.* -99999 and'
    ):
        load_machine(written(tmp_path, lambda data: data["machine"]["axes"]["C"].pop("limits")))
    with pytest.raises(MachineError, match=r'X\.limits: .*add "limits": .*own limits$'):
        load_machine(written(tmp_path, lambda data: data["machine"]["axes"]["X"].pop("limits")))


def test_a_slip_in_the_json_is_corrected_where_it_stands(tmp_path):
    path = written(tmp_path, lambda data: None)
    path.write_text(path.read_text().replace('"version": 1', '"version": 1,'))
    with pytest.raises(
        MachineError, match=r"not JSON \(.*line 1 column .*correct that place in a text editor"
    ):
        load_machine(path)


@pytest.mark.parametrize(
    "name", ["missing.fcm", "no/such/folder/m.fcm", "nul\0byte.fcm", "x" * 5000 + ".fcm"]
)
def test_a_missing_file_is_a_file_error(name, tmp_path):
    with pytest.raises(FileError, match=r"cannot be read|null character") as caught:
        load_machine(str(tmp_path / name))
    assert "\n" not in str(caught.value)


def test_a_folder_is_no_machine(tmp_path):
    (tmp_path / "folder.fcm").mkdir()
    with pytest.raises(FileError, match="is a folder"):
        load_machine(tmp_path / "folder.fcm")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", ["is empty"]),
        (b" \n", ["is empty"]),
        (b"\x00\xff\xfe\x80 solid", ["not JSON"]),
        (b"solid part\n", ["not JSON"]),
        (b'{"version": 1', ["not JSON"]),
        (b"[" * 100000, ["not JSON"]),
        (b"[1, 2]", ["instead of an object"]),
        (b"null", ["instead of an object"]),
        (b'{"version": 1, "version": 1}', ["'version'", "twice"]),
        (b'{"version": NaN}', ["NaN"]),
        (b'{"version": -Infinity}', ["Infinity"]),
        (b'{"version": 2}', ["version", "only version 1"]),
        (b'{"version": true}', ["version"]),
        (b'{"version": 1}', ["machine", "missing"]),
        (b'{"version": 1, "machine": []}', ["machine", "not an object"]),
        (b'{"version": ' + b"9" * 6000 + b"}", []),
    ],
)
def test_what_is_no_machine_file_is_refused(load, content, words):
    refused(load, content, *words)


NEEDED = ["version", "machine", "machine.name", "machine.units", "machine.axes"]
AXIS_KEYS = [
    "type",
    "role",
    "parent",
    "joint",
    "joint.origin",
    "joint.axis",
    "limits",
    "limits.min",
    "limits.max",
    "max_velocity",
]
NEEDED += [f"machine.axes.{letter}.{key}" for letter in "XA" for key in AXIS_KEYS]
USED = [*NEEDED, "machine.axes.A.wrap_strategy", "machine.description", "fiveaxis"]
USED += [f"fiveaxis.{key}" for key in ("origin", "gauge_point", "singular_cone", "controller")]


@pytest.mark.parametrize("key", NEEDED)
def test_each_missing_key_is_named_with_its_remedy(data, load, key):
    holder, last = at(data, key)
    del holder[last]
    refused(load, data, key, "missing", f'add "{last}"')


NONSENSE = [True, "nonsense\0", 1.5e400, -1e300, {}, [], [1, 2], [[0, 0, 0]], [0, 0, "1"]]


@pytest.mark.parametrize("key", USED)
@pytest.mark.parametrize("value", NONSENSE, ids=repr)
def test_each_key_with_a_value_that_makes_no_sense_is_named(data, load, key, value):
    holder, last = at(data, key)
    holder[last] = value
    if (key.endswith(".limits.min") and value == -1e300) or (key == "fiveaxis" and value == {}):
        load(data)  # no limit; nothing but defaults
        return
    content = json.dumps(data).replace("Infinity", "1.5e400").encode()
    empty_object = value == {} and last in (
        "machine",
        "axes",
        "joint",
        "limits",
    )  # then it is the first key in it that is missed
    refused(
        load,
        content,
        "missing" if empty_object and last != "axes" else "" if empty_object else last.split("_")[0],
    )


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("machine.units", "furlong", ["machine.units", "metric, imperial"]),
        ("machine.name", " ", ["machine.name", "empty"]),
        ("machine.axes.A.type", "bent", ["machine.axes.A.type", "linear, rotary"]),
        ("machine.axes.A.type", "linear", ["machine.axes.A.role", "contradicts"]),
        ("machine.axes.A.role", "table", ["machine.axes.A.role", "table_rotary"]),
        ("machine.axes.A.parent", "Q", ["machine.axes.A.parent", "'Q'", "null for the base"]),
        ("machine.axes.A.parent", "C", ["A, C", "circle"]),
        ("machine.axes.A.parent", "A", ["circle"]),
        ("machine.axes.C.parent", "X", ["machine.axes.C.parent", "head axis X"]),
        ("machine.axes.C.parent", None, ["A and C both stand on the base", "parent"]),
        ("machine.axes.A.joint.axis", [0, 0, 0], ["axis A", "no direction"]),
        ("machine.axes.A.joint.axis", [0, 1], ["machine.axes.A.joint.axis", "[x, y, z]"]),
        ("machine.axes.A.joint.origin", [0, 0, 2 * FARTHEST], ["axis A", "beyond"]),
        (
            "machine.axes.A.joint.origin",
            [0, 0, 10**400],
            ["machine.axes.A.joint.origin", "not a finite number"],
        ),
        ("machine.axes.A.joint", [[0, 0, 0], [1, 0, 0], 3], ["machine.axes.A.joint", "[[origin], [axis]]"]),
        ("machine.axes.A.joint", 7, ["machine.axes.A.joint"]),
        ("machine.axes.A.limits.min", 130, ["axis A", "min", "max"]),
        ("machine.axes.A.limits.min", 120, ["axis A", "min", "max"]),
        ("machine.axes.X.limits.min", 99999, ["axis X", "min", "max"]),
        ("machine.axes.A.max_velocity", 0, ["axis A", "rate", "positive"]),
        ("machine.axes.A.max_velocity", -5, ["axis A", "rate", "positive"]),
        ("machine.axes.A.wrap_strategy", "spiral", ["axis A", "unwound, modulo, rezero"]),
        ("fiveaxis.singular_cone", -1, ["singular_cone", "0 and 90"]),
        ("fiveaxis.singular_cone", 91, ["singular_cone", "0 and 90"]),
        ("fiveaxis.origin", [0, 0, 3e6], ["origin", "beyond"]),
    ],
)
def test_contradictions_are_named(data, load, key, value, words):
    holder, last = at(data, key)
    holder[last] = value
    refused(load, data, *words)


def test_axes_must_be_three_to_five_with_letters_of_their_own(data, load):
    axes = data["machine"]["axes"]
    without = copy.deepcopy(data)
    del without["machine"]["axes"]["Z"]
    refused(load, without, "2 linear and 2 rotary", "3 and at most 2")
    axes["B"] = {**axes["A"], "parent": None}
    axes["A"]["parent"] = "B"
    refused(load, data, "3 linear and 3 rotary")
    refused(load, json.dumps(data).replace('"B":', '"A":').encode(), "'A'", "twice")
    axes["tilt"] = axes.pop("B")
    refused(load, data, "'tilt'")


# The types themselves.


def test_machine_keeps_the_order_from_table_to_head():
    axes = load_machine("head_b_table_c").axes
    with pytest.raises(MachineError, match="table's axes before the head's"):
        Machine("wrong", (axes[4], *axes[:4]))
    with pytest.raises(MachineError, match="same letter"):
        Machine("wrong", (axes[0], axes[0], *axes[1:4]))


def test_an_axis_checks_its_letter_and_side():
    with pytest.raises(MachineError, match="rotary axis is called one of A B C"):
        Axis("X", True, "table", (0, 0, 1))
    with pytest.raises(MachineError, match="neither table nor head"):
        Axis("C", True, "wall", (0, 0, 1))
    with pytest.raises(MachineError, match="not finite"):
        Axis("C", True, "table", (0, 0, math.nan))


def test_errors_are_builtins_too():
    with pytest.raises(ValueError):
        load_machine("none such")
    with pytest.raises(OSError):
        load_machine("none_such.fcm")


def test_a_file_is_understood_once_and_counts_as_it_is_now(data, load):
    first = load(data)
    assert load(data) is first
    data["machine"]["name"] = "Another"
    assert load(data).name == "Another"
