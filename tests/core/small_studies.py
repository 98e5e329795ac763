# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three studies on a small roof, and what they tell."""

from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.studies import study

WAY = {"machine": "trunnion_ac", "passes": "planes", "tool_axis": "facet_mean", "stepover": 9}
SETUP = {"grid": "3,2,1", "turns": 2, "region": "40,30,0", "origin": "10,5,-20"}
STUDIES = {
    "setup": WAY | SETUP,
    "compare": WAY
    | {"stepover": 30, "machine": None, "machines": "mikron_ucp710,trunnion_ac", "max_axis_angle": 20},
    "reach": {"machine": "trunnion_ac", "cutter": "ball:20:12", "holder": "40x20", "face": None},
    "setup of little reach": WAY
    | SETUP
    | {"machine": "mikron_ucp710", "turns": 1, "region": "400,400,300", "grid": "2,2,2"},
}


def options_of(name):
    return {key: value for key, value in STUDIES[name].items() if value is not None}


def try_study(name, roof, executor=None, progress=lambda stage, fraction: None):
    return study.run(build_settings(name.split()[0], roof, options_of(name)), progress, executor)


def texts_of(trial):
    """All figures that were found."""
    return study.as_json(trial), study.as_text(trial)
