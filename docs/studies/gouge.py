# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the picture of docs/gouge.md and prints its numbers: ``.venv/bin/python docs/studies/gouge.py``, from
the project's folder."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import Figures, summary
from freecad_fiveaxis.core.report.raster import owners, view_from
from freecad_fiveaxis.core.report.rest_material_map import (
    HeightScale,
    height_colours,
    height_scale,
    level_colours,
    rest_material_patches,
    scale_marks,
)

HERE = Path(__file__).resolve().parents[1]
PICTURE = HERE / "images" / "gouge-left.png"
PARTS = HERE.parent / "resources" / "examples" / "make_parts.py"
OPTIONS = {
    "machine": "trunnion_ac",
    "cutter": "ball:20",
    "passes": "planes",
    "stepover": 3,
    "linearize": "on",
    "rest": "on",
}
FINE = 12.0
"""Pixels a mm."""
LIGHT = np.array([-0.35, 0.45, 0.82])


def milled(gouge: str) -> Figures:
    """The wavy patch of 233 facets under a ball of 20 mm."""
    mesh = from_faces(*runpy.run_path(str(PARTS))["freeform_233"]())
    settings = build_settings("mill", "freeform_233.stl", {**OPTIONS, "gouge": gouge})
    return job.figures(job.prove(job.make(settings, mesh=mesh)))


def seen(axes: Any, figures: Figures, scale: HeightScale, title: str) -> None:
    """The patch from above, coloured by the rest material."""
    assert figures.mesh is not None and figures.rest is not None
    corner, view = rest_material_patches(figures.mesh, figures.rest), view_from(-0.5 * np.pi, 0.5 * np.pi)
    low, high = corner.reshape(-1, 3).min(axis=0)[:2], corner.reshape(-1, 3).max(axis=0)[:2]
    wide, tall = np.ceil((high - low) * FINE).astype(int).tolist()
    owner = owners(corner, view, low, FINE, wide, tall)
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    lit = 0.75 + 0.25 * np.clip(
        normal @ LIGHT / np.linalg.norm(normal, axis=1) / np.linalg.norm(LIGHT), 0.0, 1.0
    )
    colour = np.append(height_colours(figures.rest.height, scale) * lit[:, None], [(1.0, 1.0, 1.0)], axis=0)
    axes.imshow(colour[owner], extent=(low[0], high[0], low[1], high[1]), interpolation="antialiased")
    axes.set_title(title, fontsize=9)
    axes.set(xlabel="X, mm", ylabel="Y, mm")


def legend(axes: Any, scale: HeightScale) -> None:
    """The scale of colours; its middle is what is as it should be."""
    ramp = np.linspace(-1.0, 1.0, 400)
    axes.imshow(level_colours(ramp)[None], extent=(-1, 1, 0, 1), aspect="auto")
    marks = [(level, height) for level, height in scale_marks(scale) if level != 0.0]
    axes.set_xticks([level for level, _ in marks], [f"{height:+.3g}" for _, height in marks], fontsize=8)
    axes.set_yticks([])
    message = f"too deep  <  {-scale.tolerance:g} to {scale.allowed:+.3g} mm is as it should be  <  left, mm"
    axes.set_xlabel(message, fontsize=8)


def main() -> None:
    """Mill it with and without the cure, and draw what each leaves."""
    before, after = milled("report"), milled("lift")
    assert before.rest is not None and after.rest is not None
    scales = [
        height_scale(one.rest, one.tolerance, one.allowed) for one in (before, after) if one.rest is not None
    ]
    scale = scales[0]._replace(
        deepest=max(one.deepest for one in scales), highest=max(one.highest for one in scales)
    )
    figure = plt.figure(figsize=(10.5, 4.3), layout="constrained")
    panels = figure.subplot_mosaic([["before", "after"], ["legend", "legend"]], height_ratios=(14, 1))
    for name, one in (("before", before), ("after", after)):
        reported = summary(one)
        overcut = (
            f"overcut up to {reported['max_overcut']:.3f} mm" if reported["overcut_blocks"] else "no overcut"
        )
        rest = f"at most {reported['max_left']:.3f} mm left"
        seen(
            panels[name], one, scale, f"{'As it is' if one is before else '--gouge lift'}: {overcut}, {rest}"
        )
        print(
            name,
            {
                key: reported[key]
                for key in (
                    "max_overcut",
                    "overcut_blocks",
                    "max_left",
                    "left_area",
                    "too_deep_area",
                    "max_too_deep",
                )
            },
        )
    legend(panels["legend"], scale)
    figure.savefig(PICTURE, dpi=97)


if __name__ == "__main__":
    main()
