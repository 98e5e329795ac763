# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``batch``: which jobs a folder or a table means, their names, the report over all, and what is
refused."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from roofs import WAY, write_roof

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import chunks
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.batch import crews, plan, sheet

ROOT = Path(__file__).parents[2]

WORDS = [word for name, value in WAY.items() for word in (f"--{name.replace('_', '-')}", str(value))]


def run(*words):
    return cli.main([str(word) for word in words])


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture
def parts(tmp_path):
    """Two parts in a folder."""
    folder = tmp_path / "parts"
    folder.mkdir()
    write_roof(folder / "a.stl")
    write_roof(folder / "b.STL", 18.0)
    return folder


def write_table(tmp_path, **table):
    path = tmp_path / "jobs.json"
    path.write_text(json.dumps(table))
    return path


@pytest.fixture
def without_work(monkeypatch):
    """Jobs whose work is only counted: their names."""
    from freecad_fiveaxis.core.batch import work
    from freecad_fiveaxis.core.batch.task import JobOutcome

    done = []

    def work_on(job, progress):
        done.append(os.path.basename(job.stem))
        row = work.fail_job(job, "").row | {"verdict": "green", "errors": 0, "says": "SAFE"}
        return JobOutcome(job.stem, row)

    monkeypatch.setattr(work, "run_one", work_on)
    return done


def test_one_job_is_one_and_two_are_jobs():
    row = {"verdict": "green", "errors": 0}
    assert str(sheet.count_outcomes([row])) == "1 job: 1 without errors, 0 with errors, 0 failed"
    assert str(sheet.count_outcomes([row, {**row, "errors": 1}])).startswith(
        "2 jobs: 1 without errors, 1 with"
    )


def test_a_folder_is_milled_and_what_is_finished_is_not_milled_again(parts, tmp_path, capsys, monkeypatch):
    out = tmp_path / "out"
    (parts / "c.stl").write_text("nothing")
    assert run("batch", parts, "--out", out, "--executor", "serial", *WORDS) == cli.DONE_WITH_ERRORS
    names = sorted(os.listdir(out))
    assert names == sorted(
        [f"{name}.{kind}" for name in "ab" for kind in ("ngc", "html", "json")]
        + ["batch.csv", "batch.html", "batch.json"]
    )
    reported = capsys.readouterr()
    assert (
        "3 jobs: 2 without errors, 0 with errors, 1 failed" in reported.out
        and "batch.csv" in reported.out
        and not reported.err
    )
    a, _, c = rows_of(out / "batch.csv")
    assert (
        (a["name"], a["verdict"], c["verdict"]) == ("a", "amber", "failed")
        and "c.stl" in c["error"]
        and not a["error"]
    )
    assert (
        0 < float(a["deviation_mm"]) <= float(a["bound_mm"])
        and float(a["cut_mm"]) > 50
        and float(a["minutes"]) > 0
    )
    page = (out / "batch.html").read_text(encoding="utf-8")
    assert page.count('<a href="') == 2 and 'href="a.html"' in page and "c.stl" in page
    before = {name: (out / name).read_bytes() for name in names}
    monkeypatch.setattr(
        "freecad_fiveaxis.core.batch.work.pipeline.run", None
    )  # only c, which fails before it comes to that
    (parts / "c.stl").unlink()
    assert run("batch", parts, "--out", out, "--executor", "serial", *WORDS) == cli.DONE
    assert "2 were finished before" in capsys.readouterr().out
    assert {name: data for name, data in before.items() if name[0] in "ab" and "batch" not in name} == {
        name: (out / name).read_bytes() for name in names if "batch" not in name
    }


def test_a_table_is_parts_times_options_under_readable_names(parts, tmp_path):
    (tmp_path / "shop.fcm").write_bytes((plan_machine()).read_bytes())
    options = {
        **WAY,
        "machine": ["trunnion_ac", "shop.fcm"],
        "cutter": ["ball:6", "ball:0.5in"],
        "origin": [1, 2, 3],
    }
    jobs = plan.read_jobs(
        str(write_table(tmp_path, parts=["parts/a.stl", "parts/b.STL"], options=options)),
        {"feed": 700},
        "out",
    )
    assert [os.path.basename(job.stem) for job in jobs[:5]] == [
        "a.machine=trunnion_ac.cutter=ball-6", "a.machine=trunnion_ac.cutter=ball-0.5in",
        "a.machine=shop.cutter=ball-6", "a.machine=shop.cutter=ball-0.5in", "b.machine=trunnion_ac.cutter=ball-6",
    ]  # fmt: skip
    assert len(jobs) == 8 and len({job.stem for job in jobs}) == 8
    assert jobs[2].options["machine"] == str(tmp_path / "shop.fcm") and jobs[0].options["origin"] == [1, 2, 3]
    assert jobs[0].part == str(tmp_path / "parts" / "a.stl") and jobs[7].options["feed"] == 700


def test_an_option_of_the_command_line_stands_in_place_of_the_tables_under_its_former_name(parts, tmp_path):
    table = write_table(
        tmp_path, parts=["parts/a.stl"], options={**WAY, "machine": "trunnion_ac", "left": "on"}
    )
    assert [job.options["rest"] for job in plan.read_jobs(str(table), {}, "out")] == ["on"]
    assert [job.options["rest"] for job in plan.read_jobs(str(table), {"rest": "off"}, "out")] == ["off"]


def plan_machine():
    from freecad_fiveaxis.core.machine import machine_path

    return Path(machine_path("trunnion_bc"))


@pytest.mark.parametrize(
    ("controller", "ending"), [("siemens840d", ".mpf"), ("heidenhain", ".h"), ("linuxcnc", ".ngc")]
)
def test_programs_end_as_their_controller_wants_it(controller, ending, parts):
    (one, _) = plan.read_jobs(str(parts), WAY | {"controller": controller}, "out")
    assert one.nc == os.path.join("out", "a" + ending)


def test_names_are_unique_in_whatever_letters_and_never_the_reports(tmp_path):
    names = ["one/a.stl", "two/a.stl", "x/B.stl", "batch.stl", "batch-1-of-2.stl"]
    for name in names:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        write_roof(tmp_path / name)
    table = write_table(tmp_path, parts=[*names, "x/B.stl"], options=WAY)
    stems = [os.path.basename(job.stem) for job in plan.read_jobs(str(table), {}, "out")]
    assert stems == ["one-a", "two-a", "x-B", "batch~2", "batch-1-of-2~2", "x-B~2"]
    assert plan._unique_names(["a", "A", "a~2"]) == ["a", "A~2", "a~2~2"]


@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_shards_share_the_jobs_out(n):
    jobs = list(range(7))
    shards = [plan.of_shard(jobs, (i, n)) for i in range(1, n + 1)]
    assert (
        sorted(job for shard in shards for job in shard) == jobs
        and max(map(len, shards)) - min(map(len, shards)) <= 1
    )


def test_shards_in_one_folder_or_several_merge_to_the_whole(parts, tmp_path, without_work):
    for shard, out in (("1/2", "x"), ("2/2", "y")):
        assert (
            run("batch", parts, "--out", tmp_path / out, "--shard", shard, "--executor", "serial", *WORDS)
            == cli.DONE
        )
    assert without_work == ["a", "b"]
    assert run("batch", "--merge", tmp_path / "x", tmp_path / "y", "--out", tmp_path / "all") == cli.DONE
    assert [(row["name"], row["folder"]) for row in rows_of(tmp_path / "all" / "batch.csv")] == [
        ("a", "../x"),
        ("b", "../y"),
    ]
    assert 'href="../y/b.html"' in (tmp_path / "all" / "batch.html").read_text(encoding="utf-8")
    assert (
        run("batch", "--merge", tmp_path / "all", "--out", tmp_path / "all") == cli.DONE
    )  # once more changes nothing
    assert [(row["name"], row["folder"]) for row in rows_of(tmp_path / "all" / "batch.csv")] == [
        ("a", "../x"),
        ("b", "../y"),
    ]
    for shard in ("1/2", "2/2"):
        assert (
            run("batch", parts, "--out", tmp_path / "one", "--shard", shard, "--executor", "serial", *WORDS)
            == cli.DONE
        )
    assert sheet.merge_reports([str(tmp_path / "one")], str(tmp_path / "one"))[1]["name"] == "b"


def test_files_of_others_are_never_replaced_unless_requested(parts, tmp_path, capsys, without_work):
    out = tmp_path / "out"
    out.mkdir()
    for name in ("b.ngc", "batch.csv"):
        (out / name).write_text("mine")
        assert run("batch", parts, "--out", out, "--executor", "serial", *WORDS) == cli.UNUSABLE
        assert (
            name in (reported := capsys.readouterr().err)
            and "--overwrite" in reported
            and reported.count("\n") == 1
        )
        assert os.listdir(out) == [name] and not without_work
        (out / name).unlink()
    (out / "batch.csv").write_text("mine")
    assert run("batch", parts, "--out", out, "--executor", "serial", "--overwrite", *WORDS) == cli.DONE
    assert "mine" not in (out / "batch.csv").read_text()


BAD_TABLES = {
    "no parts": ({"options": WAY}, "parts"),
    "empty": ({"parts": [], "options": WAY}, "parts"),
    "more": ({"parts": ["a.stl"], "option": {}}, "nothing else"),
    "unknown option": ({"parts": ["a.stl"], "options": {**WAY, "stepovr": 3}}, "stepover"),
    "out of range": ({"parts": ["a.stl"], "options": {**WAY, "stepover": [3, -1]}}, "stepover -1"),
    "no values": ({"parts": ["a.stl"], "options": {**WAY, "stepover": []}}, "empty list"),
    "own output": ({"parts": ["a.stl"], "options": {**WAY, "report": "a.html"}}, "report"),
    "unknown machine": ({"parts": ["a.stl"], "options": {**WAY, "machine": ["trunnion_ac", "nope"]}}, "nope"),
    "list": ([], "parts"),
}


@pytest.mark.parametrize("name", BAD_TABLES)
def test_a_table_that_cannot_be_used_is_refused_before_anything_is_written(
    name, tmp_path, capsys, without_work
):
    table, message = BAD_TABLES[name]
    path = tmp_path / "jobs.json"
    path.write_text(json.dumps(table))
    assert run("batch", path, "--out", tmp_path / "out", "--executor", "serial") == cli.UNUSABLE
    assert message in (reported := capsys.readouterr().err) and reported.count("\n") == 1
    assert os.listdir(tmp_path) == ["jobs.json"] and not without_work


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nowhere"], "does not exist"),
        (["."], "no part"),
        (["parts", "--shard", "3/2"], "1/4"),
        (["parts", "--workers", "none"], "whole number"),
        (["parts", "--executor", "gnomes"], "processes, threads, serial"),
        (["parts", "--executor", "dask://localhost:1"], 'pip install "dask[distributed]"'),
        (["parts", "--executor", "mpi"], "pip install mpi4py"),
        (["parts", "--merge", "parts"], "leave parts out"),
        (["--merge", "parts"], "no batch.json"),
        ([], "no jobs given"),
    ],
)
def test_what_cannot_be_done_is_named_with_its_remedy(
    words, message, parts, tmp_path, capsys, monkeypatch, without_work
):
    for module in ("distributed", "mpi4py", "mpi4py.futures"):
        monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.chdir(tmp_path)
    assert run("batch", *words, "--out", "out", *WORDS) == cli.UNUSABLE
    assert message in (reported := capsys.readouterr().err) and reported.count("\n") == 1
    assert os.listdir(tmp_path) == ["parts"] and not without_work


def test_jobs_json_that_is_no_json_is_named(tmp_path, capsys):
    (tmp_path / "jobs.json").write_text('{"parts": ["a.stl"], "parts": []}')
    assert run("batch", tmp_path / "jobs.json", "--out", tmp_path / "out") == cli.UNUSABLE
    assert "stands twice" in capsys.readouterr().err


def test_a_shard_says_which_jobs():
    assert plan.read_shard("2/3") == (2, 3)
    for bad in ("", "0/3", "4/3", "a/b", "1/2/3"):
        with pytest.raises(SettingsError):
            plan.read_shard(bad)


@pytest.mark.parametrize(("words", "workers"), [([], 3), (["--workers", "2"], 2)])
def test_a_batch_begins_as_many_workers_as_there_are_processors_unless_reported(
    words, workers, parts, tmp_path, monkeypatch, without_work
):
    """Those that this process may use, which ``chunks`` counts once."""
    wanted = []
    monkeypatch.setattr(chunks, "PROCESSORS", 3)
    monkeypatch.setattr(crews, "find_crew", lambda name, count: wanted.append((name, count)))
    assert run("batch", parts, "--out", tmp_path / "out", "--quiet", *words, *WORDS) == cli.DONE
    assert wanted == [("processes", workers)] and without_work == ["a", "b"]


COUNT = "import os; os.sched_getaffinity = lambda pid: {1, 5, 7}; os.cpu_count = lambda: 64\n"
"""A computer of which this process may use three processors."""


def test_the_processors_are_those_that_this_process_may_use():
    code = "from freecad_fiveaxis.core.base.chunks import PROCESSORS\nprint(PROCESSORS)"
    elsewhere = COUNT + "del os.sched_getaffinity\n"
    counted = [
        subprocess.run(
            [sys.executable, "-c", before + code], capture_output=True, text=True, timeout=60, cwd=ROOT
        ).stdout.strip()
        for before in (COUNT, elsewhere)
    ]
    assert counted == ["3", "64"]


@pytest.mark.parametrize(
    "crew", [pytest.param("threads", marks=(pytest.mark.thorough, pytest.mark.oldest)), "processes"]
)
def test_the_command_with_workers_makes_what_it_makes_without(crew, parts, tmp_path):
    for out, words in (("serial", ["--executor", "serial"]), (crew, ["--executor", crew, "--workers", "2"])):
        assert run("batch", parts, "--out", tmp_path / out, "--quiet", *words, *WORDS) == cli.DONE
    one, other = (
        {path.name: path.read_bytes() for path in (tmp_path / out).iterdir()} for out in ("serial", crew)
    )
    assert one == other and len(one) == 9
