# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unknowns of one layout by least squares that wrong rows do not disturb, and how certain each is.

trimmed   least trimmed squares (Rousseeuw 1984): the sum over the best three quarters of the rows is made
          least, found from many small random samples, each improved by fitting again to the rows that fit
          best (Rousseeuw & Van Driessen 2006). Up to a quarter of wrong rows has no influence at all.
scale     residuals in units of the rounding that the printed digits lead to expect: about 1 where the layout
          is right.
certainty half the width of the interval that holds the true value in 95 of 100 cases.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .layouts import Guess
from .model import LINEAR_ZERO, LINES, ROTARY_ZERO, UNKNOWNS, Layout, Rows, rows_of
from .pairs import Pairs

KEPT = 0.75
"""Share of the rows that a trimmed fit looks at."""
LEAST_TO_TRIM = 8
"""With fewer rows than this none can be told to be wrong."""
STARTS, SAMPLE, IMPROVEMENTS = 40, 5, 4
FREEDOMS = 5.0
"""Of one row: three of the tip, two of the axis."""
OUTLYING = 5.0
"""A row whose residual is over so many scales (root mean square over its freedoms) is wrong; of 1e6 good ones
none is."""
STEPS = 6
RANK = 1e-9
"""Singular values below this share of the largest (columns scaled to their effect at 100 mm or 1 rad) are
none."""
SEED = 2008


@dataclass(frozen=True)
class Freedom:
    """Which unknowns are fitted: always the lines, and the zeros of linear and of rotary words where they are
    not taken as 0."""

    linear_zero: bool
    rotary_zero: bool

    @property
    def columns(self) -> Ints:
        """Of the nine unknowns."""
        chosen = np.zeros(UNKNOWNS, bool)
        chosen[LINES], chosen[LINEAR_ZERO], chosen[ROTARY_ZERO] = True, self.linear_zero, self.rotary_zero
        return np.flatnonzero(chosen)

    @property
    def strange(self) -> float:
        """A word that is not counted from where it should be is less likely."""
        return 1.0 * self.linear_zero + 1.0 * self.rotary_zero


ALL_FREE = Freedom(True, True)


@dataclass(frozen=True, eq=False)
class Fit:
    """``unknown`` (9,) mm and rad; ``scale`` of the residuals of the rows kept; ``good`` (n,) the rows kept;
    ``row_scale`` (n,) of each row; ``miss`` (n,) mm, how far the tip is from where the fit puts it, and
    ``lean`` (n,) rad the tool axis; ``covariance`` (9, 9) of the fitted unknowns (others 0), ``free`` (9, 9)
    that if no zero were taken as known; infinite where the rows do not determine an unknown; ``factor``: half
    the 95 % interval in standard deviations."""

    layout: Layout
    freedom: Freedom
    unknown: Floats
    scale: float
    good: Bools
    row_scale: Floats
    miss: Floats
    lean: Floats
    covariance: Floats
    free: Floats
    factor: float

    @property
    def strange(self) -> float:
        """How far it is from the plainest explanation."""
        return self.layout.strange + self.freedom.strange

    @property
    def score(self) -> float:
        """Less is better: each unit of strangeness must pay by a third of the scale; below rounding nothing
        is gained."""
        return math.log(max(self.scale, 1.0)) + math.log(3.0) * self.strange


def screen_guess(guess: Guess, pairs: Pairs, base: Floats, linear_zero: bool) -> Fit:
    """Return a quick robust fit of the lines (and of the linear zero) at the guess's rotary zeros;
    certainties are left out."""
    freedom = Freedom(linear_zero, any(guess.zeros))
    unknown = np.zeros(UNKNOWNS)
    unknown[ROTARY_ZERO] = guess.zeros
    columns = Freedom(linear_zero, False).columns
    for _ in range(2):  # the second time with the noise of the arms that were found
        rows = rows_of(guess.layout, pairs, base, unknown)
        unknown[columns] += _solve_trimmed(rows, columns)
    return judge_fit(guess.layout, freedom, pairs, base, unknown)


def refine_fit(first: Fit, pairs: Pairs, base: Floats) -> Fit:
    """All unknowns of the fit's freedom together (Gauss-Newton) on the rows that are not wrong, with their
    certainty."""
    fit, columns = first, first.freedom.columns
    for _ in range(STEPS):
        rows = rows_of(fit.layout, pairs, base, fit.unknown)
        change, _ = _solve_change(rows, columns, np.flatnonzero(fit.good))
        unknown = fit.unknown.copy()
        unknown[columns] += change
        fit = judge_fit(fit.layout, fit.freedom, pairs, base, unknown)
    return _certain(fit, pairs, base)


def _normal(rows: Rows, columns: Ints) -> tuple[Floats, Floats, Floats]:
    """Of each row: matrix (n, p, p), right side (n, p), square (n,) of its whitened equations."""
    jacobian, residual = _whiten_rows(rows, columns)
    return (
        jacobian.transpose(0, 2, 1) @ jacobian,
        np.einsum("nij,ni->nj", jacobian, residual),
        (residual * residual).sum(axis=1),
    )


def _whiten_rows(rows: Rows, columns: Ints) -> tuple[Floats, Floats]:
    return rows.whitener @ rows.jacobian[:, :, columns], np.einsum("nij,nj->ni", rows.whitener, rows.residual)


def _solve_trimmed(rows: Rows, columns: Ints) -> Floats:
    """Return the least-trimmed-squares change of the unknowns ``columns``, linear in them."""
    matrix, right, square = _normal(rows, columns)
    count = len(square)
    if count < LEAST_TO_TRIM:
        return _pinv_solved(matrix.sum(axis=0)[None], right.sum(axis=0)[None]).reshape(-1)
    kept, rng = math.ceil(KEPT * count), np.random.default_rng(SEED)
    chosen = np.argsort(rng.random((STARTS, count)), axis=1)[:, :SAMPLE]
    for _ in range(IMPROVEMENTS):
        change = _pinv_solved(matrix[chosen].sum(axis=1), right[chosen].sum(axis=1))
        off = (
            square
            - 2.0 * change @ right.T
            + np.einsum("sp,npq,sq->sn", change, matrix, change, optimize=True)
        )
        chosen = np.argpartition(off, kept - 1, axis=1)[:, :kept]
    total = np.take_along_axis(off, chosen, axis=1).sum(axis=1)
    best = chosen[int(np.argmin(total))]
    return _pinv_solved(matrix[best].sum(axis=0)[None], right[best].sum(axis=0)[None]).reshape(-1)


def _pinv_solved(matrix: Floats, right: Floats) -> Floats:
    """Least changes (s, p) that solve the normal equations, whatever their rank."""
    return np.asarray(np.einsum("spq,sq->sp", np.linalg.pinv(matrix, rcond=1e-13, hermitian=True), right))


def judge_fit(layout: Layout, freedom: Freedom, pairs: Pairs, base: Floats, unknown: Floats) -> Fit:
    """Return the fit that has these unknowns, on these pairs: scale, wrong rows; certainties are left out."""
    rows = rows_of(layout, pairs, base, unknown)
    white = np.einsum("nij,nj->ni", rows.whitener, rows.residual)
    row_scale = np.sqrt((white * white).sum(axis=1) / FREEDOMS)
    count = len(row_scale)
    kept = math.ceil(KEPT * count) if count >= LEAST_TO_TRIM else count
    typical = math.sqrt(float(np.mean(np.sort(row_scale)[:kept] ** 2)))
    good = row_scale <= OUTLYING * max(typical, 1.0) if count >= LEAST_TO_TRIM else np.ones(count, bool)
    equations = FREEDOMS * int(good.sum())
    spare = max(equations - len(freedom.columns), 1.0)
    scale = math.sqrt(float((row_scale[good] ** 2).sum()) * FREEDOMS / spare)
    if not good.sum() >= KEPT * count:  # what explains less than that explains nothing
        scale = max(scale, typical)
    miss, lean = (np.linalg.norm(part, axis=1) for part in (rows.residual[:, :3], rows.residual[:, 3:]))
    nothing = np.zeros((UNKNOWNS, UNKNOWNS))
    return Fit(layout, freedom, unknown, scale, good, row_scale, miss, lean, nothing, nothing, 1.96)


def _solve_change(rows: Rows, columns: Ints, chosen: Ints) -> tuple[Floats, Floats]:
    """Change (p,) of the unknowns ``columns`` and its covariance (p, p), infinite on the diagonal where
    undetermined."""
    jacobian, residual = _whiten_rows(
        Rows(*(getattr(rows, name)[chosen] for name in ("residual", "jacobian", "whitener"))), columns
    )
    units = np.where(columns >= ROTARY_ZERO.start, 1e-2, 1.0)  # a radian moves the tip by 100 mm and more
    table = jacobian.reshape(-1, len(columns)) * units
    u, values, v = np.linalg.svd(table, full_matrices=False)
    real = values > RANK * values[0]
    change = units * (v[real].T @ ((u[:, real].T @ residual.reshape(-1)) / values[real]))
    covariance = units[:, None] * ((v[real].T / values[real] ** 2) @ v[real]) * units
    lost = (v[~real] ** 2).sum(axis=0) > 1e-6
    covariance[lost, lost] = math.inf
    return change, covariance


def _certain(fit: Fit, pairs: Pairs, base: Floats) -> Fit:
    rows, chosen = rows_of(fit.layout, pairs, base, fit.unknown), np.flatnonzero(fit.good)
    columns = fit.freedom.columns
    covariance = np.zeros((UNKNOWNS, UNKNOWNS))
    covariance[np.ix_(columns, columns)] = _solve_change(rows, columns, chosen)[1]
    free = _solve_change(rows, ALL_FREE.columns, chosen)[1]
    spare = max(FREEDOMS * len(chosen) - len(columns), 1.0)
    factor = 1.96 if fit.scale <= 1.0 else fit.scale * float(scipy.special.stdtrit(spare, 0.975))
    return Fit(**{**vars(fit), "covariance": covariance, "free": free, "factor": factor})
