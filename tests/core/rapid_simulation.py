# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rapids simulated with axes that run independently, each at a rate of its own."""

import numpy as np

from freecad_fiveaxis.core.tool.body import depth_of


def simulated(words, body, there, points, seed, blocks=None, ways=12, steps=25):
    """The deepest entry (m,) mm over ways of random rates, and starts and stops, of each axis; ``blocks``:
    all."""
    rng, deepest = np.random.default_rng(seed), np.zeros(len(words) - 1)
    for block in range(len(words) - 1) if blocks is None else blocks:
        time = np.linspace(0.0, 1.0, steps)[None, :, None]
        rate = np.exp(rng.normal(0.0, 1.5, (ways, 1, 5)))
        u = np.clip(time * rate / rate.min(axis=2, keepdims=True), 0.0, 1.0).reshape(-1, 5)
        pose = there.poses(words[block] + u * (words[block + 1] - words[block]))
        for tip, axis in zip(pose.tip.T, pose.axis.T, strict=True):
            deepest[block] = max(deepest[block], depth_of(body, tip, axis, points).max())
    return deepest


def points_of(mesh, count=800, seed=5):
    rng, corner = np.random.default_rng(seed), mesh.vertex[mesh.face]
    which, share = rng.integers(len(corner), size=count), rng.dirichlet((1.0, 1.0, 1.0), count)
    return np.concatenate([(corner[which] * share[:, :, None]).sum(axis=1), mesh.vertex])
