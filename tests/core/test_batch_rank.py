# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of several ways of milling a part leaves least, soonest: the order, what shares a place, and what has
none."""

import csv
import json

import pytest
from roofs import WAY, write_roof

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.batch import plan, rank, sheet
from freecad_fiveaxis.core.batch.task import COLUMNS, JobOutcome


def row_of(name, unfinished=0.0, minutes=1.0, verdict="green", part="a.stl", **more):
    known = {
        "name": name,
        "part": part,
        "unfinished_percent": unfinished,
        "minutes": minutes,
        "verdict": verdict,
    }
    return dict.fromkeys(COLUMNS) | {"errors": int(verdict == "red"), "says": "", "error": ""} | known | more


def places(rows):
    return [(row["name"], row["rank"]) for row in rank.rank_rows(rows)]


BEST_FIRST = [
    row_of("quick", 0.0, 10.0),
    row_of("slow", 0.0, 20.0, "amber"),
    row_of("leaves more", 0.5, 1.0),
    row_of("leaves most", 30.0, 0.5),
    row_of("time not known", 30.0, None),
    row_of("share not known", None, 0.1),
    row_of("not safe", 0.0, 0.1, "red"),
    row_of("failed", None, None, "failed", error="no cutter"),
]
RANKS = [1, 2, 3, 4, 5, 6, None, None]
EXPECTED = [(row["name"], place) for row, place in zip(BEST_FIRST, RANKS, strict=True)]


@pytest.mark.parametrize("turn", range(len(BEST_FIRST)))
def test_what_leaves_least_comes_first_then_what_is_done_soonest(turn):
    """In whatever order the jobs were; and what is not safe, or failed, has no rank and is last."""
    given = [*BEST_FIRST[turn:], *BEST_FIRST[:turn]]
    assert places(given) == EXPECTED and places(given[::-1]) == EXPECTED


RIGHT = rank._merit
WRONG = {
    "minutes first": lambda row: (RIGHT(row)[0], RIGHT(row)[2], RIGHT(row)[1]),
    "what is not safe among the others": lambda row: (0, *RIGHT(row)[1:]),
    "minutes left out": lambda row: (*RIGHT(row)[:2], 0.0),
    "the longest first": lambda row: (*RIGHT(row)[:2], -RIGHT(row)[2]),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_order_would_be_noticed(name, monkeypatch):
    monkeypatch.setattr(rank, "_merit", WRONG[name])
    with pytest.raises(AssertionError):
        test_what_leaves_least_comes_first_then_what_is_done_soonest(0)


def test_what_is_the_same_shares_a_rank_and_stays_in_its_order():
    rows = [row_of("x", 2.0, 9.0), row_of("b", 0.04, 5.0), row_of("a", 0.0, 5.0), row_of("c", 0.0, 5.5)]
    assert places(rows) == [("b", 1), ("a", 1), ("c", 3), ("x", 4)]  # 0.04 % is no reason to mill longer
    assert [str(line) for line in rank.best_lines(rank.rank_rows(rows))] == [
        "a.stl: best of 4: b, a, 0.0 % unfinished, 5 min"
    ]


def test_each_part_has_its_own_ranks_and_a_single_job_none():
    rows = [row_of("a1", 1.0), row_of("b", part="b.stl"), row_of("a2", 0.0), row_of("c1", verdict="failed", part="c.stl"),
            row_of("c2", verdict="red", part="c.stl")]  # fmt: skip
    assert places(rows) == [("a2", 1), ("a1", 2), ("b", None), ("c2", None), ("c1", None)]
    a, c = rank.best_lines(rank.rank_rows(rows))
    assert a == "a.stl: best of 2: a2, 0.0 % unfinished, 1 min"
    assert c == "c.stl: none of 2 ways makes a program that is safe"


def test_each_finish_has_its_own_ranks():
    """The coarser the scallop, the less counts as unfinished."""
    rows = [row_of("coarse", 1.0, scallop_mm=0.5), row_of("fine", 9.0, scallop_mm=0.05), row_of("broken", None, None, "failed"),
            row_of("coarse too", 2.0, scallop_mm=0.5), row_of("steps", 0.0, stepover_mm=2.0)]  # fmt: skip
    ranks = dict(places(rows))
    assert ranks == {"coarse": 1, "coarse too": 2, "broken": None, "fine": None, "steps": None}
    (line,) = rank.best_lines(rank.rank_rows(rows))
    assert line == "a.stl with scallop 0.5 mm: best of 3: coarse, 1.0 % unfinished, 1 min"


def test_ranks_are_in_every_report_and_those_of_a_merge_are_counted_anew(tmp_path):
    for folder, rows in (("x", [row_of("one", 3.0), row_of("two", 2.0)]), ("y", [row_of("one", 1.0)])):
        (tmp_path / folder).mkdir()
        sheet.write_report(sheet.report_files(str(tmp_path / folder)), rank.rank_rows(rows))
    alone = (tmp_path / "y" / "batch.html").read_text(encoding="utf-8")
    page = (tmp_path / "x" / "batch.html").read_text(encoding="utf-8")
    assert ">rank<" in page and page.index(">two<") < page.index(">one<") and ">rank<" not in alone
    with open(tmp_path / "x" / "batch.csv", newline="", encoding="utf-8") as stream:
        assert [(row["name"], row["rank"]) for row in csv.DictReader(stream)] == [("two", "1"), ("one", "2")]
    rows = rank.rank_rows(sheet.merge_reports([str(tmp_path / "x"), str(tmp_path / "y")], str(tmp_path)))
    assert [(row["folder"], row["name"], row["rank"]) for row in rows] == [
        ("y", "one", 1),
        ("x", "two", 2),
        ("x", "one", 3),
    ]
    assert [str(line) for line in rank.best_lines(rows)] == [
        "a.stl: best of 3: y/one, 1.0 % unfinished, 1 min"
    ]


def test_parts_of_one_name_are_distinguished(tmp_path):
    for folder in ("one", "two/in"):
        (tmp_path / folder).mkdir(parents=True)
        write_roof(tmp_path / folder / "a.stl")
    write_roof(tmp_path / "b.stl")
    table = tmp_path / "jobs.json"
    table.write_text(json.dumps({"parts": ["one/a.stl", "two/in/a.stl", "b.stl", "b.stl"], "options": WAY}))
    assert [job.label for job in plan.read_jobs(str(table), {}, "out")] == [
        "one/a.stl",
        "two/in/a.stl",
        "",
        "",
    ]


def test_the_command_names_the_best_cutter_of_each_part(tmp_path, capsys, monkeypatch):
    from freecad_fiveaxis.core.batch import work

    unfinished = {"ball:6": 2.5, "ball:10": 1.25, "ball:12": None}

    def work_on(job, progress):
        left = unfinished[job.options["cutter"]]
        row = work.fail_job(job, "" if left else "too large").row
        return JobOutcome(job.stem, row | (row_of(row["name"], left, 31.0, part=row["part"]) if left else {}))

    monkeypatch.setattr(work, "run_one", work_on)
    write_roof(tmp_path / "a.stl")
    table = tmp_path / "jobs.json"
    table.write_text(json.dumps({"parts": ["a.stl"], "options": WAY | {"cutter": list(unfinished)}}))
    words = ["batch", str(table), "--out", str(tmp_path / "out"), "--executor", "serial"]
    assert cli.main(words) == cli.DONE_WITH_ERRORS
    reported = capsys.readouterr().out.splitlines()
    assert "a.stl: best of 3: a.cutter=ball-10, 1.2 % unfinished, 31 min" in reported
    jobs = [line.split(":")[0] for line in reported if line.startswith("a.cutter=")]
    assert jobs == ["a.cutter=ball-10", "a.cutter=ball-6", "a.cutter=ball-12"]
