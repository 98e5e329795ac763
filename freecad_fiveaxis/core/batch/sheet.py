# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report over all jobs: ``batch.csv`` for tables, ``batch.html`` to look at, ``batch.json`` to merge."""

from __future__ import annotations

import csv
import io
import json
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any
from urllib.parse import quote

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.files import check_writable, read_bytes, write_all
from freecad_fiveaxis.core.base.sentences import Sentence, plural, say
from freecad_fiveaxis.core.studies.setup_map.sheet import json_text, page, section

from .task import COLUMNS, FAILED, not_of_batch

VERSION = 1
"""Of batch.json."""
KIND = "fiveaxis-batch"
LOOK = {"red": "bad", "failed": "bad", "amber": "open", "green": "good"}
Row = Mapping[str, Any]


def report_files(out: str, shard: tuple[int, int] | None = None) -> tuple[str, str, str]:
    """Return the names of the report's files in the folder ``out``: CSV, page and JSON."""
    name = "batch" if shard is None else f"batch-{shard[0]}-of-{shard[1]}"
    csv_, html, json_ = (os.path.join(out, f"{name}.{kind}") for kind in ("csv", "html", "json"))
    return csv_, html, json_


def check_report(files: tuple[str, str, str], overwrite: bool) -> None:
    """Refuse to write over files of another origin. Raises FiveAxisError."""
    for path in files:
        check_writable(path)
    there = [path for path in files if os.path.lexists(path)]
    if there and not overwrite and _read(files[2]) is None:
        raise not_of_batch(there[0])


def write_report(files: tuple[str, str, str], rows: Sequence[Row]) -> None:
    """Write the three files, all or none; ``rows`` by COLUMNS, ranked, and with ``folder`` where they are
    merged. Raises FileError."""
    record = {"version": VERSION, "kind": KIND, "rows": rows}
    texts = dict(zip(files, (as_csv(rows), as_html(rows), json_text(record)), strict=True))
    write_all({path: text.encode("utf-8", "backslashreplace") for path, text in texts.items()})


def merge_reports(folders: Sequence[str], out: str) -> list[Row]:
    """Return the rows of the reports in several folders, the last one's where a job is in several; ``folder``
    says where its files are, seen from ``out``. Raises SettingsError for a folder without a report."""
    rows = dict[tuple[str, str], Row]()
    for folder in folders:
        found = [
            part
            for path in sorted(Path(folder).glob("batch*.json"))
            if (part := _read(str(path))) is not None
        ]
        if not found:
            raise SettingsError(
                say("no batch.json of a batch is in {folder}; name a folder that one wrote", folder=folder),
                folder,
            )
        for row in (row for part in found for row in part):
            where = _make_relative(os.path.join(folder, str(row.get("folder") or ".")), out)
            rows[where, str(row.get("name"))] = {**row, "folder": where}
    return list(rows.values())


def count_outcomes(rows: Sequence[Row], kept: int = 0) -> Sentence:
    """One sentence over all; ``kept``: so many were finished before."""
    failed = sum(row["verdict"] == FAILED for row in rows)
    errors = sum(bool(row["errors"]) for row in rows)
    text = plural(
        len(rows),
        "{count} job: {well} without errors, {errors} with errors, {failed} failed",
        "{count} jobs: {well} without errors, {errors} with errors, {failed} failed",
        well=len(rows) - failed - errors, errors=errors, failed=failed,
    )  # fmt: skip
    return text + say("; {kept} were finished before", kept=kept) if kept else text


def as_csv(rows: Sequence[Row]) -> str:
    """Return the table with one row a job, lengths in mm, times in minutes."""
    text = io.StringIO(newline="")
    table = csv.writer(text, lineterminator="\n")
    columns = (*COLUMNS, "folder") if any("folder" in row for row in rows) else COLUMNS
    table.writerow(columns)
    table.writerows([_cell(row.get(name)) for name in columns] for row in rows)
    return text.getvalue()


def as_html(rows: Sequence[Row]) -> str:
    """Return the page: a row a job, with a link to its own; ranks only where there are any."""
    columns = [name for name in COLUMNS[:-1] if name != "rank" or any(row["rank"] for row in rows)]
    head = "".join(f'<th scope="col">{escape(name.replace("_", " "))}</th>' for name in columns)
    lines = "".join(f"<tr>{''.join(_html_cells(row, columns))}</tr>\n" for row in rows)
    table = (
        '<div class="scroll"><table '
        f'class="numbers"><thead><tr>{head}</tr></thead>\n<tbody>{lines}</tbody></table></div>'
    )
    lights = Counter(LOOK[row["verdict"]] for row in rows)
    mood = next((one for one in ("bad", "open") if lights[one]), "good")
    return page("Batch", "every job by itself", count_outcomes(rows), mood, [section("The jobs", table)])


def _html_cells(row: Row, columns: Sequence[str]) -> list[str]:
    cells = [escape(_cell(row.get(name), 4)) for name in columns]
    says = columns.index("says")
    cells[says] = escape(str(row["error"] or row["says"] or ""))
    if row["verdict"] != FAILED:
        cells[0] = f'<a href="{escape(_link(row))}">{cells[0]}</a>'
    looks = {
        columns.index("verdict"): f' class="{LOOK[row["verdict"]]}"',
        says: ' style="white-space:normal;min-width:20rem"',
    }
    return [f"<td{looks.get(at, '')}>{cell}</td>" for at, cell in enumerate(cells)]


def _link(row: Row) -> str:
    folder = row.get("folder", ".")
    return ("" if folder == "." else quote(folder, "/:", errors="surrogateescape") + "/") + _quote_name(
        row["name"] + ".html"
    )


def _quote_name(name: str) -> str:
    return quote(name, "", errors="surrogateescape")


def _cell(value: Any, digits: int = 6) -> str:
    return "" if value is None else f"{value:.{digits}g}" if isinstance(value, float) else str(value)


def _make_relative(folder: str, out: str) -> str:
    try:
        return Path(os.path.relpath(folder, out)).as_posix()
    except ValueError:  # another drive of Windows
        return Path(folder).resolve().as_posix()


def _read(path: str) -> list[Row] | None:
    """Return the rows of a batch.json; None where it is none."""
    try:
        record = json.loads(read_bytes(path, "report"))
    except (OSError, ValueError, RecursionError):
        return None
    if not isinstance(record, dict) or record.get("kind") != KIND or not isinstance(record.get("rows"), list):
        return None
    rows = [row for row in record["rows"] if isinstance(row, dict) and row.get("verdict") in LOOK]
    return [dict.fromkeys(COLUMNS) | row for row in rows]
