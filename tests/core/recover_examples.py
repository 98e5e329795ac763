# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL rows with the words of a known machine, rounded as they are printed, for the tests of recover."""

import numpy as np

from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, inverse
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

SETUP = Setup((10.0, -5.0, 20.0), 80.0)
TABLE_2 = (
    np.array([[75.2110, -51.4295, 228.6808], [74.5130, -50.5510, 228.6857]]),
    np.array([[0.0095944, 0.0159479, 0.9998268], [0.0175393, 0.0107682, 0.9997882]]),
    np.array(
        [[-90.9595, 7.3103, 227.6341, 148.9685, 1.0664], [-82.0656, -34.8175, 228.3975, 121.5477, 1.1793]]
    ),
)
"""So et al. 2008, Table 2: tips, axes, words X Y Z C A."""


def cl_path(tip, axis):
    """A path of cutting rows."""
    axis = axis / np.linalg.norm(axis, axis=1)[:, None]
    nothing = np.full(len(tip), -1)
    return CLPath(
        tip, axis, np.zeros(len(tip), np.int8), np.full(len(tip), 100.0), tip, axis, nothing, nothing, nothing
    )


def program(letters, words):
    """A program of feed blocks; block i stands in line 10 + i."""
    count = len(words)
    return Program(
        letters, words, np.full(count, 100.0), np.zeros(count, bool), np.zeros(count, np.int8), np.zeros(count),
        np.full(count, -1), np.arange(count) + 10,
    )  # fmt: skip


def poses(count, seed, lean=0.8, span=80.0):
    """Tips with 4 decimals and exact unit axes, leaning by at most ``lean`` rad."""
    rng = np.random.default_rng(seed)
    tilt, turn = rng.uniform(0.0, lean, count), rng.uniform(-np.pi, np.pi, count)
    axis = np.column_stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)])
    return np.round(rng.uniform(-span, span, (count, 3)), 4), axis


def posted(machine, count=50, seed=1, wrong=0.0, shift=(0.0,) * 5, setup=SETUP, **options):
    """Path, program and the rows that are wrong; everything with 4 decimals. ``shift`` of the words, mm and
    deg."""
    kinematics = chain(load_machine(machine) if isinstance(machine, str) else machine, setup)
    tip, axis = poses(count, seed, **options)
    words = inverse(kinematics, tip, axis)[0][0].copy()
    words[:, 3:] = np.degrees(words[:, 3:])
    words = np.round(words + shift, 4)
    rng = np.random.default_rng(seed + 1000)
    bad = np.sort(rng.choice(count, int(np.ceil(wrong * count)), replace=False))
    words[bad] += rng.uniform(-30.0, 30.0, (len(bad), 5))
    return cl_path(tip, np.round(axis, 4)), program(kinematics.letters, np.round(words, 4)), bad


def line_errors(machine, truth, setup=SETUP):
    """Distances (2,) mm of both rotary lines from the true ones; the machines must have the same signs and
    letters."""
    one, two = chain(machine, setup), chain(truth, setup)
    assert (one.letters, one.slot) == (two.letters, two.slot)
    np.testing.assert_allclose(one.direction, two.direction, rtol=0, atol=1e-9)
    pairs = ((one.point1, two.point1, two.direction[3]), (one.point2, two.point2, two.direction[4]))
    return np.array([np.linalg.norm(np.cross(a - b, way)) for a, b, way in pairs])
