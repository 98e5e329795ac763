# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that differ only in what comes after the field of tool axes find it once: it is most of what such a
run takes."""

import pickle

from freecad_fiveaxis.core.pipeline import mill_context


def keep_fields(monkeypatch, kept=None):
    """Let `mill` take the field found before for the same part, facets and tool. ``kept``: where fields of
    other tests are too."""
    found, kept = mill_context.find_axis_field, {} if kept is None else kept

    def find(mesh, facets, reacher, *more):
        wanted = pickle.dumps((mesh.vertex, mesh.face, facets, reacher))
        if wanted not in kept:
            kept[wanted] = found(mesh, facets, reacher, *more)
        return kept[wanted]

    monkeypatch.setattr(mill_context, "find_axis_field", find)
