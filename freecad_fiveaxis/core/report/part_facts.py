# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program does to the part, in numbers: where the tool enters it, and the rest material on it.

entry     a block in which cutter, shank or holder go into the part deeper than the tolerance: ``overcut``
          (the cutter, on a cut), ``rapid-collision`` (the cutter, between passes), ``holder-collision``
          (shank or holder, at any time).
rest      of a place of the machined surface: how far the cutter stays away from it, mm; below 0 it is cut too
          deep.
allowed   so much may be left, mm: scallops and tolerance.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.gouge import GOUGES, GougeCheck, RestMaterial, WayEntries, spots
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import PARTS

from .rest_material_map import HeightScale, height_scale, round_values, scale_marks

DEEPEST = 10
"""So many places are named."""

LABELS: Mapping[str, str] = {
    Code.OVERCUT: "deepest overcut",
    Code.RAPID_COLLISION: "deepest entry between passes",
    Code.HOLDER_COLLISION: "deepest entry of shank or holder",
}


def part_numbers(
    program: Program, gouge: GougeCheck | None, rest: RestMaterial | None, tolerance: float, allowed: float
) -> dict[str, Any]:
    """Return the numbers for the summary, mm, mm2 and mm3; only those that were looked for."""
    numbers_of: dict[str, Any] = {}
    if gouge is not None:
        cases = gouge.cases(program.motion[1:])
        for code, _, depth in cases:
            name, worst = code.replace("-", "_"), int(depth.argmax()) if depth.any() else None
            numbers_of[f"max_{name}"] = float(depth.max(initial=0.0))
            numbers_of[f"{name}_blocks"] = int((depth > 0.0).sum())
            numbers_of[f"{name}_places"] = len(spots(depth)[0])
            numbers_of[f"{name}_line"] = None if worst is None else int(program.line[worst + 1])
        numbers_of["cutter_bound"] = float(gouge.cutter.bound.max(initial=0.0))
        numbers_of["buried_blocks"] = int(gouge.buried.sum())
        numbers_of |= {} if gouge.ways is None else _rapid_numbers(program, gouge.ways)
    if rest is not None:
        numbers_of["max_left"] = float(rest.height.max())
        numbers_of["left_area"], numbers_of["left_volume"] = rest.uncut(allowed)
        numbers_of["max_too_deep"] = max(-float(rest.height.min()), 0.0)
        numbers_of["too_deep_area"], numbers_of["too_deep_volume"] = rest.sum_overcut(tolerance)
        numbers_of["machined_area"] = float(rest.area.sum())
    return numbers_of


def _rapid_numbers(program: Program, ways: WayEntries) -> dict[str, Any]:
    """Return the numbers of rapids whose axes may run independently."""
    worst = spots(ways.depth)[0]
    return {
        "max_independent_rapid": float(ways.depth.max(initial=0.0)),
        "independent_rapid_blocks": int((ways.depth > 0.0).sum()),
        "independent_rapid_places": len(worst),
        "independent_rapid_line": int(program.line[worst[0] + 1]) if len(worst) else None,
    }


def deepest_entries(program: Program, gouge: GougeCheck) -> list[dict[str, Any]]:
    """Return the deepest entries of all kinds as rows, deepest first; of a run of neighbouring blocks the
    deepest one."""
    found = []
    for code, entries, depth in gouge.cases(program.motion[1:]):
        for block in spots(depth)[0][:DEEPEST].tolist():
            found.append({
                "kind": code,
                "part": PARTS[int(entries.part[block])],
                "depth": float(depth[block]),
                "bound": float(entries.bound[block]),
                "block": block + 1,
                "line": int(program.line[block + 1]),
                "u": float(entries.u[block]),
                "place": entries.place[block].tolist(),
            })  # fmt: skip
    return sorted(found, key=lambda row: -row["depth"])[:DEEPEST]


def rest_report(program: Program, rest: RestMaterial, tolerance: float, allowed: float) -> dict[str, Any]:
    """Return the rest material as scripts want it: the two extremes with place, block and NC line; area and
    volume beyond what may be; the histogram by area."""
    return {
        "tolerance": tolerance,
        "allowed": allowed,
        "machined_area": float(rest.area.sum()),
        "most_left": _extreme(program, rest, int(rest.height.argmax())),
        "most_too_deep": _extreme(program, rest, int(rest.height.argmin())),
        "left": dict(zip(("area", "volume"), rest.uncut(allowed), strict=True)),
        "too_deep": dict(zip(("area", "volume"), rest.sum_overcut(tolerance), strict=True)),
        "histogram": histogram(rest, height_scale(rest, tolerance, allowed)),
    }


def _extreme(program: Program, rest: RestMaterial, row: int) -> dict[str, Any]:
    block = int(rest.block[row]) + 1
    return {
        "height": float(rest.height[row]), "place": rest.point[row].tolist(), "facet": int(rest.facet[row]),
        "block": block, "line": int(program.line[block]),
    }  # fmt: skip


def histogram(rest: RestMaterial, scale: HeightScale) -> list[dict[str, float]]:
    """Return the area (mm2) between each two borders, ``from`` and ``to`` mm, deepest first; every sample is
    in one."""
    edge = borders(scale)
    area, _ = np.histogram(np.clip(rest.height, edge[0], edge[-1]), edge, weights=rest.area)
    return [
        {"from": a, "to": b, "area": c}
        for a, b, c in zip(edge[:-1].tolist(), edge[1:].tolist(), area.tolist(), strict=True)
    ]


def borders(scale: HeightScale) -> Floats:
    """Heights, mm, ascending: ends and neutral borders of the scale, and 1, 2, 5 times powers of ten between
    them."""
    ends = [height for _, height in scale_marks(scale)]
    sides = ((scale.tolerance, scale.deepest, -1.0), (scale.allowed, scale.highest, 1.0))
    between = [sign * value for low, high, sign in sides for value in round_values(low, high, 1.05)]
    neutral = [0.0, scale.tolerance, *round_values(scale.tolerance, scale.allowed, 1.05)]
    return np.unique([*ends, *between, *(value for value in neutral if value <= scale.allowed)])


def part_verdict(numbers: Mapping[str, Any], tolerance: float) -> tuple[tuple[str, str], ...]:
    """One plain sentence for each thing that was looked for, and whether it is good, bad or open."""
    sentences = []
    if "overcut_blocks" in numbers:
        entered = [code for code in GOUGES if numbers[f"{code.replace('-', '_')}_blocks"]]
        if entered:
            parts = "; ".join(" ".join(_entry_fact(numbers, code)) for code in entered)
            sentences.append((f"The tool enters the part by more than {tolerance:g} mm: {parts}.", "bad"))
        elif not numbers["buried_blocks"] and not numbers.get("independent_rapid_blocks"):
            sentences.append(
                (f"Gouge-free: nowhere does the tool enter the part by more than {tolerance:g} mm.", "good")
            )
        if hit := numbers.get("independent_rapid_blocks"):
            text = f"In {hit} rapids the tool enters the part unless the axes are interpolated; deepest "
            sentences.append(
                (
                    f"{text}{numbers['max_independent_rapid']:.4g} mm (NC line "
                    f"{numbers['independent_rapid_line']}).",
                    "bad",
                )
            )
        if numbers["buried_blocks"]:
            sentences.append(
                (f"In {numbers['buried_blocks']} blocks the whole cutter is inside the part.", "bad")
            )
    if "max_left" in numbers:
        if numbers["left_area"]:
            share = f"{numbers['left_area']:.4g} of {numbers['machined_area']:.4g} mm2"
            sentences.append(
                (f"More is left than may be on {share}, at most {numbers['max_left']:.4g} mm.", "open")
            )
        else:
            sentences.append((f"Nothing is left but scallops, at most {numbers['max_left']:.3g} mm.", "good"))
    return tuple(sentences)


def part_facts(numbers: Mapping[str, Any], tolerance: float) -> list[tuple[str, str]]:
    """Return the numbers as pairs of name and value with unit; none where nothing was looked for. An entry
    within the tolerance, mm, is not measured, and so no 0."""
    facts = []
    if "overcut_blocks" in numbers:
        none = f"none above {tolerance:g} mm"
        entered = {code: numbers[f"{code.replace('-', '_')}_blocks"] for code in GOUGES}
        facts = [_entry_fact(numbers, code) if entered[code] else (LABELS[code], none) for code in GOUGES]
        facts.append(("nowhere the cutter goes deeper than", f"{numbers['cutter_bound']:.6f} mm (proven)"))
    if "max_left" in numbers:
        facts += [
            ("most that is left on the surface", f"{numbers['max_left']:.4f} mm"),
            ("area with more left than may be", _area(numbers, "left")),
            ("deepest below the surface", f"{numbers['max_too_deep']:.4f} mm"),
            ("area cut too deep", _area(numbers, "too_deep")),
        ]
    return facts


def _entry_fact(numbers: Mapping[str, Any], code: str) -> tuple[str, str]:
    name = code.replace("-", "_")
    blocks = numbers[f"{name}_blocks"]
    where = f" in {blocks} blocks (deepest: NC line {numbers[f'{name}_line']})" if blocks else ""
    return LABELS[code], f"{numbers[f'max_{name}']:.4f} mm{where}"


def _area(numbers: Mapping[str, Any], name: str) -> str:
    area, whole, volume = numbers[f"{name}_area"], numbers["machined_area"], numbers[f"{name}_volume"]
    return f"{area:.4g} mm2 of {whole:.4g} mm2; {volume:.3g} mm3" if area else "none"
