# SPDX-License-Identifier: LGPL-2.1-or-later
"""A folder of parts in, NC programs and reports out, without a window.

    freecadcmd examples/batch.py -- PARTS OUT machine=trunnion_ac cutter=ball:6 scallop=0.02
    FIVEAXIS_PARTS=parts FIVEAXIS_OUT=nc FIVEAXIS_MACHINE=trunnion_ac freecadcmd examples/batch.py

PARTS     a folder with FCStd and STEP files, or one such file.
OUT       the folder for the results, made if need be: for every part NAME.html, NAME.json and the program,
          NAME.ngc (or as the files of its controller end).
settings  as in job files (``fiveaxis mill --help`` lists them, with _ for -), besides linear_deflection,
          angular_deflection (of the tessellation), work_zero=X,Y,Z (in the document) and overwrite=yes. In
          the environment they begin with FIVEAXIS_. What stands after ``--`` wins.
part      of a STEP file: all that is in it. Of an FCStd file: its five-axis toolpaths with their own
          settings; without those the models of its CAM Jobs with the Job's tool; without those its solids
          (the visible ones, where any is visible).

A part that fails is told in one line and stops no other. No file is replaced unless overwrite=yes.
Exit code: 0 all well; 1 some parts failed or have findings of severity error; 2 nothing could be done.
"""

import os
import sys
import time
from collections import Counter
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

STEP, FCSTD = (".step", ".stp"), (".fcstd",)
OWN = ("parts", "out", "overwrite")
TESSELLATION = ("linear_deflection", "angular_deflection", "work_zero")
NOT_OURS = ("output", "cl", "report", "blocks", "rates")
"""Options of ``mill`` that name files; here the parts' names make the files' names."""
CHOICE = ("controller", "machine")
"""The options that decide how NC files end."""
PREFIX = "FIVEAXIS_"
YES = ("1", "yes", "true", "on")
EVERY = 2.0
"""Seconds between two lines of progress."""


@dataclass
class Order:
    """What is asked for."""

    parts: Path
    out: Path
    options: dict
    overwrite: bool = False
    written: set = field(default_factory=set)


@dataclass
class Row:
    """What came of one part: figures of the summary table, or the error."""

    name: str
    error: str = ""
    summary: dict = field(default_factory=dict)

    @property
    def spoiled(self):
        """Whether the part failed or would be spoiled if nobody looked."""
        return bool(self.error or self.summary["findings"]["error"])


def main(words, environment, say):
    """Do all parts and return the exit code."""
    from freecad_fiveaxis.core.base.errors import FiveAxisError

    try:
        order = read_order(words, environment, say)
        files = part_files(order.parts)
        order.out.mkdir(parents=True, exist_ok=True)
    except (FiveAxisError, OSError) as error:
        say(f"batch: {one_line(error)}")
        return 2
    rows, stopped = [], False
    try:
        for number, (file, stem) in enumerate(named(files), 1):
            say(f"[{number}/{len(files)}] {file.name}")
            rows += do_file(file, stem, order, say)
    except KeyboardInterrupt:
        stopped = True
        say("batch: stopped; what is done is done, and no file is half written")
    for line in table(rows):
        say(line)
    if all(row.error for row in rows):
        return 2
    return int(stopped or any(row.spoiled for row in rows))


def read_order(words, environment, say):
    """The order from the environment and the words after ``--``. Raises SettingsError that names what is
    wrong."""
    from freecad_fiveaxis.core.base.errors import SettingsError
    from freecad_fiveaxis.core.pipeline.settings import build_settings, option_fields

    known = {leaf.name for _, leaf in option_fields("mill")}.difference(NOT_OURS).union(OWN, TESSELLATION)
    given = from_environment(environment, known, say) | from_words(words)
    for name in given:
        if name not in known:
            raise SettingsError(f"{name} is no setting; known: {', '.join(sorted(known))}", name)
    if not given.get("parts") or not given.get("out"):
        raise SettingsError(
            "name the folder of the parts and the one for the results: ... -- PARTS OUT machine=NAME"
        )
    if not given.get("machine"):
        raise SettingsError(
            "no machine given; add machine=NAME, a shipped machine's name or a path to a .fcm", ""
        )
    options = {name: value for name, value in given.items() if name not in OWN}
    build_settings(
        "mill", "part.stl", {name: value for name, value in options.items() if name not in TESSELLATION}
    )
    if "work_zero" in options:
        options["work_zero"] = read_point(options["work_zero"])
    overwrite = given.get("overwrite", "no").lower() in YES
    return Order(Path(given["parts"]), Path(given["out"]), options, overwrite)


def from_environment(environment, known, say):
    """The settings in the environment; a name that is none is told, because it may be a slip of the pen."""
    found = {
        name[len(PREFIX) :].lower(): value
        for name, value in environment.items()
        if name.startswith(PREFIX) and value
    }
    for name in sorted(set(found) - known):
        say(f"batch: {PREFIX}{name.upper()} is no setting and is not used")
    return {name: value for name, value in found.items() if name in known}


def from_words(words):
    """PARTS, OUT and name=value. Raises SettingsError for a word too many."""
    from freecad_fiveaxis.core.base.errors import SettingsError

    folders = [word for word in words if "=" not in word]
    if len(folders) > 2:
        raise SettingsError(f"{folders[2]!r} is one word too many; write settings as name=value", folders[2])
    pairs = [word.split("=", 1) for word in words if "=" in word]
    return dict(zip(OWN, folders, strict=False)) | {
        name.strip("-").replace("-", "_"): value for name, value in pairs
    }


def read_point(text):
    """X,Y,Z in mm."""
    from freecad_fiveaxis.core.base.quantity import LENGTHS, parse_triple

    return parse_triple(text, LENGTHS, "work_zero")


def part_files(parts):
    """The files of the parts, in the order of their names. Raises FileError where there is none."""
    from freecad_fiveaxis.core.base.errors import FileError

    found = [parts] if parts.is_file() else sorted(parts.iterdir()) if parts.is_dir() else []
    files = [file for file in found if file.suffix.lower() in STEP + FCSTD and file.is_file()]
    if not files:
        raise FileError(f"{parts} holds no FCStd and no STEP file; name the folder of the parts", parts)
    return files


def named(files):
    """Each file with the name of its results: its stem, and its ending where two files have the same stem."""
    stems = Counter(file.stem.casefold() for file in files)
    return [
        (file, file.stem if stems[file.stem.casefold()] == 1 else file.stem + "_" + file.suffix[1:].lower())
        for file in files
    ]


def do_file(file, stem, order, say):
    """All parts of one file; whatever is wrong with it is a row of the table."""
    import FreeCAD

    try:
        doc = opened(file)
    except Exception as error:  # whatever a reader of files may raise: it ends this file, not the batch
        return [failed(file.name, error, say)]
    try:
        return [do_part(*part, order, say) for part in parts_of(doc, stem, order)]
    except Exception as error:
        return [failed(file.name, error, say)]
    finally:
        FreeCAD.closeDocument(doc.Name)


def opened(file):
    """The document of a file; a STEP file becomes a new one with one object."""
    import FreeCAD
    import Part

    from freecad_fiveaxis.core.base.errors import FileError

    if file.suffix.lower() in FCSTD:
        return FreeCAD.openDocument(str(file))
    shape = Part.Shape()
    shape.read(str(file))
    if not shape.Solids:
        raise FileError(f"{file.name} holds no solid; export the part as a solid", str(file))
    doc = FreeCAD.newDocument("Part")
    doc.addObject("Part::Feature", "Part").Shape = shape
    return doc


def parts_of(doc, stem, order):
    """What of a document is to be done: (name of the results, base or toolpath, settings). Raises
    SelectionError for nothing."""
    from freecad_fiveaxis.app.selection import SelectionError

    found = (
        toolpaths_in(doc) or job_models_in(doc, order) or [(solid, order.options) for solid in solids_in(doc)]
    )
    if not found:
        raise SelectionError("there is no toolpath, no CAM Job and no solid in it; add a solid", doc.Label)
    labels = Counter(obj.Label for obj, _ in found)
    return [
        (stem if len(found) == 1 else f"{stem}-{file_name(obj, labels)}", obj, settings)
        for obj, settings in found
    ]


def file_name(obj, labels):
    """A name for files: the label, and where it is not the only one of its kind or no name for a file, the
    object's name."""
    plain = all(letter.isalnum() or letter in " ._-" for letter in obj.Label)
    return obj.Label if plain and labels[obj.Label] == 1 else obj.Name


def toolpaths_in(doc):
    """The five-axis toolpaths of a document, with nothing to set."""
    from freecad_fiveaxis.app.toolpath import Toolpath

    return [(obj, None) for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), Toolpath)]


def job_models_in(doc, order):
    """The models of the CAM Jobs, with the Job's tool; what the order says wins."""
    from freecad_fiveaxis.app.cam import jobs_of, settings_from_job

    found = []
    for job in jobs_of(doc):
        if "cutter" in order.options:
            found += [(model, order.options) for model in job.Model.Group]
        else:
            models, settings = settings_from_job(job)
            found += [(model, settings | order.options) for model in models]
    return found


def solids_in(doc):
    """The solids that nothing else is made from; of these the visible ones, where any is visible."""
    solids = [
        obj for obj in doc.Objects if has_solid(obj) and not any(has_solid(user) for user in obj.InList)
    ]
    return [obj for obj in solids if obj.Visibility] or solids


def has_solid(obj):
    """Whether it is a part, body or compound with a solid."""
    return obj.isDerivedFrom("Part::Feature") and bool(obj.Shape.Solids)


def do_part(name, base, settings, order, say):
    """One part from solid to files: a row of the table, whatever happens."""
    from freecad_fiveaxis.app.long_work import reporting

    try:
        with reporting(telling(name, say)):
            figures = mill(name, base, settings, order)
    except Exception as error:
        return failed(name, error, say)
    from freecad_fiveaxis.core.report import summary

    return Row(name, summary=summary(figures))


def mill(name, base, settings, order):
    """Compute the toolpath, write NC and reports; returns the figures. All that can be checked is checked
    first."""
    from freecad_fiveaxis import app
    from freecad_fiveaxis.app.controllers import suffix_of, suffix_of_path
    from freecad_fiveaxis.app.nc_output import check_replaceable
    from freecad_fiveaxis.app.results import figures_of
    from freecad_fiveaxis.core.base.files import write_whole
    from freecad_fiveaxis.core.report import as_html, as_json

    doc, target = base.Document, {kind: order.out / f"{name}.{kind}" for kind in ("html", "json")}
    target["nc"] = order.out / (
        name + (suffix_of_path(base) if settings is None else suffix_of(*map(settings.get, CHOICE)))
    )
    overwrite = order.overwrite and not order.written.intersection(
        target.values()
    )  # two parts of one name: both are wanted
    for path in target.values():
        check_replaceable(doc, path, overwrite)
    toolpath = base if settings is None else app.create_toolpath(doc, base, **settings)
    figures = figures_of(toolpath)
    app.post_process(toolpath, target["nc"], overwrite=overwrite)
    for kind, made in (("html", as_html), ("json", as_json)):
        write_whole(target[kind], made(figures).encode("utf-8", "backslashreplace"))
    order.written.update(target.values())
    return figures


def telling(name, say):
    """A listener that prints a line when a stage takes its time."""
    told = time.monotonic()

    def listener(stage, fraction):
        nonlocal told
        if time.monotonic() - told >= EVERY:
            told = time.monotonic()
            say(f"    {name}: {stage} {fraction:.0%}")

    return listener


def failed(name, error, say):
    """The row of a part that failed, and its line."""
    row = Row(name, one_line(error))
    say(f"    {name}: FAILED: {row.error}")
    return row


def one_line(error):
    """The error in one line; one that is not ours with its kind, because its text alone may say little."""
    from freecad_fiveaxis.core.base.errors import FiveAxisError

    said = error.args[0] if error.args else ""
    said = (
        said.get("sErrMsg", said) if isinstance(said, dict) else error
    )  # FreeCAD's own errors carry a dictionary
    text = " ".join(str(said).split()) or "no message"
    return text if isinstance(error, FiveAxisError) else f"{type(error).__name__}: {text}"


def table(rows):
    """The summary: one line a part."""
    head = ("part", "blocks", "minutes", "surface mm", "tip mm", "over", "singular", "errors", "result")
    lines = [head, *(cells(row) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    for line in lines:
        part, *numbers, result = line
        yield "  ".join([part.ljust(widths[0]), *map(str.rjust, numbers, widths[1:-1]), result])
    failed_, spoiled = failures(rows), sum(row.spoiled for row in rows)
    yield (
        f"{len(rows)} parts: {len(rows) - spoiled} well, {spoiled - failed_} with errors in the "
        f"findings, {failed_} failed"
    )


def failures(rows):
    """How many parts failed."""
    return sum(bool(row.error) for row in rows)


def cells(row):
    """A row of the table as texts."""
    if row.error:
        return (row.name, *("-",) * 7, "failed")
    one = row.summary
    surface = (
        one["max_segment_deviation"] if one["max_surface_deviation"] is None else one["max_surface_deviation"]
    )
    numbers = (
        str(one["blocks"]),
        f"{one['time_s'] / 60:.1f}",
        f"{surface:.4f}",
        f"{one['max_segment_deviation']:.4f}",
    )
    counts = (str(one["over_tolerance"]), str(one["singular_blocks"]), str(one["findings"]["error"]))
    return (
        row.name,
        *numbers,
        *counts,
        "proven" if one["proven"] else "look at it" if row.spoiled else "not proven",
    )


@contextmanager
def quiet():
    """FreeCAD's own bars and banners go nowhere; yields a function that prints a line all the same."""
    sys.stdout.flush()
    mine = os.fdopen(os.dup(1), "w", encoding="utf-8", errors="backslashreplace", buffering=1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield lambda line: print(line, file=mine, flush=True)
    finally:
        sys.stdout.flush()
        os.dup2(mine.fileno(), 1)


def run():
    """The whole script. FreeCAD would exit with 0 after an error and run the file twice, so this ends the
    process itself."""
    code = 2
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    with quiet() as say:
        try:
            sys.path.append(str(Path(__file__).resolve().parents[1]))  # where the add-on is not installed
            code = main(words, os.environ, say)
        except (
            BaseException
        ):  # FreeCAD's abort is no Exception, and whatever comes out of here would make FreeCAD exit with 0
            import traceback

            say(traceback.format_exc())
    os._exit(code)


run()
