# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lin & Ye's radius of curvature (eq. 8) beside the curvature by which passes are spaced, on meshes whose
curvature is known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial import ConvexHull

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces
from freecad_fiveaxis.core.passes import compute_turn, facet_curvature, pass_curvature, slice_mesh

RADIUS, TUBE, HEIGHT = 60.0, 20.0, 40.0
STEPOVER, ANGLE = 1.7, 0.3
Exact = Callable[[Floats, Floats], Floats]


def grid(x: Floats, y: Floats, z: Floats) -> Mesh:
    """Two facets for each cell of a grid of points (m, n), open at its border."""
    row = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    face = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return from_faces(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), face)


def ball() -> tuple[Mesh, Exact]:
    """A sphere through points at random: facets of all sizes."""
    point = np.random.default_rng(3).normal(size=(3000, 3))
    point *= RADIUS / np.linalg.norm(point, axis=1)[:, None]
    face = ConvexHull(point).simplices
    a, b, c = (point[face[:, k]] for k in range(3))
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    face[inward] = face[inward][:, ::-1]
    return from_faces(point, face), lambda place, way: np.full(len(place), 1.0 / RADIUS)


def barrel() -> tuple[Mesh, Exact]:
    """The upper part of a cylinder about x, in strips as CAD systems write them: each of two long facets."""
    turn, along = np.meshgrid(np.linspace(-1.2, 1.2, 61), np.array([0.0, HEIGHT]), indexing="ij")
    mesh = grid(along, -RADIUS * np.sin(turn), RADIUS * np.cos(turn))
    return mesh, lambda place, way: (1.0 - way[:, 0] ** 2) / RADIUS


def ring() -> tuple[Mesh, Exact]:
    """The upper half of a torus about z: convex outside, a saddle inside."""
    around, over = np.meshgrid(
        np.linspace(0.0, 2.0 * np.pi, 181), np.linspace(0.1, np.pi - 0.1, 41), indexing="ij"
    )
    out = RADIUS + TUBE * np.cos(over)
    mesh = grid(out * np.cos(around), out * np.sin(around), TUBE * np.sin(over))

    def exact(place: Floats, way: Floats) -> Floats:
        flat = np.hypot(place[:, 0], place[:, 1])
        about = np.column_stack([-place[:, 1], place[:, 0], 0.0 * flat]) / flat[:, None]
        cosine = (flat - RADIUS) / np.hypot(flat - RADIUS, place[:, 2])
        share = (way * about).sum(axis=1) ** 2
        return share * cosine / flat + (1.0 - share) / TUBE

    return mesh, exact


SURFACES = {"sphere, facets at random": ball, "cylinder, strips": barrel, "torus, even cells": ring}


def curvatures(result: tuple[Mesh, Exact]) -> tuple[Floats, Floats, Floats, Floats]:
    """Along the segments (s,) of passes over the surface: by eq. (8), by the mean over neighbours, exact,
    1/mm; and their length, mm."""
    mesh, exact = result
    across = np.array((-np.sin(ANGLE), np.cos(ANGLE), 0.0))
    offset = mesh.vertex @ across
    contact = slice_mesh(mesh, np.arange(offset.min() + 0.3, offset.max(), STEPOVER), ANGLE)
    start, end = contact.point[::2], contact.point[1::2]
    length = np.linalg.norm(end - start, axis=1)
    way = (end - start) / np.maximum(length, 1e-9)[:, None]
    face: Ints = contact.face[::2]
    mean = (compute_turn(facet_curvature(mesh)[:, face], way) * way).sum(axis=1)
    found = pass_curvature(contact)
    good = np.isfinite(found)
    return found[good], mean[good], exact(0.5 * (start + end), way)[good], length[good]


def _share(value: float) -> str:
    return f"{value:,.0f}" if value >= 10.0 else f"{value:.2g}"


def table(row: Callable[..., str], heading: Callable[..., list[str]]) -> list[str]:
    """The mean of each over the length of the passes, as a share of the exact one's; and their errors step by
    step, as a share of the surface's largest curvature; for all steps and for those that are no slivers."""
    lines = heading(
        "surface", "steps", "eq. (8): mean", "median error", "95 of 100 below", "worst",
        "neighbourhood: mean", "median error",
        "95 of 100 below", "worst",
    )  # fmt: skip
    for name, surface in SURFACES.items():
        by_arc, by_mean, exact, length = curvatures(surface())
        for which, chosen in (
            ("all", length > 0.0),
            ("longer than half the median", length > 0.5 * np.median(length)),
        ):
            cells = []
            for found in (by_arc, by_mean):
                off = np.abs(found - exact)[chosen] / np.abs(exact).max()
                whole = (found * length)[chosen].sum() / (exact * length)[chosen].sum()
                cells += [f"{whole:.3f}", *(_share(value) for value in np.percentile(off, (50, 95, 100)))]
            lines.append(row(name, f"{which}: {chosen.sum()}", *cells))
    return lines
