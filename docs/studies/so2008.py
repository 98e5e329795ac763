# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the table of the forms of So et al.'s eq. (8) in docs/deviation.md: ``python
docs/studies/so2008.py``.

Run from the project's folder, with that on PYTHONPATH.
"""

from __future__ import annotations

import numpy as np
from trials import DOCS, PLACE, heading, row

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, linear_words, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.deviation.so2008 import model_tip
from freecad_fiveaxis.core.motion.trajectory import tip_at

CHAINS = {
    "table-table": "trunnion_ac",
    "nutating table": "nutating_table_b45",
    "head-table": "head_b_table_c",
    "head-head": "fork_head_bc",
}
BLOCKS, SEED = 4000, 1
SAMPLES = 801
PERCENTILES = (50, 95, 100)


def kinematics_of(name: str) -> Chain:
    machine = load_machine(name)
    return chain(machine, Setup(machine.origin, 150.0 if machine.has_head else 0.0))


def near_pole(kinematics: Chain, level: bool, count: int = BLOCKS) -> tuple[Floats, Floats]:
    """Start and end words of blocks with chords of 1 mm, across U where ``level``, else in any direction; V
    within 1 deg of the pole and turning by up to 0.2 deg, U by 10 to 30 deg."""
    rng = np.random.default_rng(SEED)
    first = np.stack([rng.uniform(-180, 180, count), rng.uniform(-1.0, 1.0, count)], axis=1)
    last = first + np.stack(
        [rng.uniform(10, 30, count) * rng.choice((-1, 1), count), rng.uniform(-0.2, 0.2, count)], axis=1
    )
    tips, step = rng.uniform(-80, 80, (count, 3)), rng.normal(size=(count, 3))
    if level:
        step -= (step @ kinematics.direction[3])[:, None] * kinematics.direction[3]
    step /= np.linalg.norm(step, axis=1)[:, None]
    ends = [(tips, np.radians(first)), (tips + step, np.radians(last))]
    start, end = (np.concatenate([linear_words(kinematics, p, q), np.degrees(q)], axis=1) for p, q in ends)
    return start, end


def line_distance(kinematics: Chain, start: Floats, end: Floats, u: Floats) -> Floats:
    """Of the real tip at ``u`` (n,) from the line through the chord (n,) mm: eq. (6)."""
    p0, p1 = (forward(kinematics, words_to_q(words))[0] for words in (start, end))
    chord = (p1 - p0) / np.linalg.norm(p1 - p0, axis=1)[:, None]
    return np.linalg.norm(np.cross(tip_at(kinematics, start, end, u) - p0, chord), axis=1)


def solved(kinematics: Chain, start: Floats, end: Floats) -> Floats:
    """u (n,) that solves eq. (8) itself, without a polynomial: where the model's path, seen along U, is
    farthest; by samples."""
    u, found = np.linspace(0.0, 1.0, SAMPLES), np.empty(len(start))
    for first in range(0, len(start), 200):
        part = slice(first, first + 200)
        words = np.stack([start[part], end[part]], axis=1).reshape(-1, 5)
        path = model_tip(kinematics, words, u)[0::2]
        path = path - path[:, :1]
        path -= (path @ kinematics.direction[3])[..., None] * kinematics.direction[3]
        found[part] = u[np.linalg.norm(np.cross(path, path[:, -1:]), axis=2).argmax(axis=1)]
    return found


def shortfalls(kinematics: Chain, level: bool) -> dict[str, Floats]:
    """By how much of the exact line deviation each form falls short (n,)."""
    start, end = near_pole(kinematics, level)
    words = np.stack([start, end], axis=1).reshape(-1, 5)
    exact, one, two = (
        measure(kinematics, words, method).line[1::2] for method in ("exact", "so2008", "so2008-printed")
    )
    lines = {
        "`so2008`": one,
        "`so2008-printed`": two,
        "the larger of both": np.maximum(one, two),
        "eq. (8) without eq. (9)": line_distance(kinematics, start, end, solved(kinematics, start, end)),
    }
    return {name: (exact - line) / exact for name, line in lines.items()}


def table() -> list[str]:
    names = [
        f"{which}, {chord}"
        for chord in ("level", "any")
        for which in ("median, %", "95th percentile, %", "worst, %")
    ]
    lines = heading("chain", "form", *names)
    for kind, machine in CHAINS.items():
        level, steep = (shortfalls(kinematics_of(machine), flat) for flat in (True, False))
        for form in level:
            values = np.concatenate(
                [np.percentile(np.maximum(one[form], 0.0), PERCENTILES) for one in (level, steep)]
            )
            lines.append(
                row(kind, form, *(f"{100.0 * value:.2g}" if value > 5e-7 else "0" for value in values))
            )
    return lines


def main() -> None:
    page = DOCS / "deviation.md"
    text = page.read_text(encoding="utf-8")
    page.write_text(
        PLACE.sub(lambda found: found[1] + "\n".join([*table(), found[4]]), text), encoding="utf-8"
    )


if __name__ == "__main__":
    main()
