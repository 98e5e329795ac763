# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixed-point tables against Python's own ``%``."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core.base import number_text
from freecad_fiveaxis.core.base.number_text import (
    EXACT,
    Choice,
    Column,
    Units,
    nearest_whole,
    round_as_printed,
    table,
    table_parts,
)


def by_percent(columns: list[Column], end: bytes = b"\n") -> bytes:
    rows = []
    for i in range(len(columns[0].values)):
        for column in columns:
            if column.show is None or column.show[i]:
                form = b"%%.%df" % column.decimals if column.values.dtype.kind == "f" else b"%d"
                rows.append(column.prefix + form % column.values[i])
        rows.append(end)
    return b"".join(rows)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.floats(width=64), min_size=1, max_size=20),
    st.integers(0, 9),
    st.sampled_from([b"", b"X", b" Y", b"GOTO/"]),
)
def test_any_double_is_printed_as_percent_prints_it(
    values: list[float], decimals: int, prefix: bytes
) -> None:
    columns = [Column(prefix, np.array(values), decimals)]
    assert table(columns) == by_percent(columns)


@pytest.mark.parametrize("decimals", range(10))
@pytest.mark.parametrize("size", [1e-9, 1e-4, 1.0, 1e3, 9999.99999, 1e5, 1e9, 1e14, 1e18])
def test_every_size_and_number_of_decimals_is_printed_as_percent_prints_it(
    decimals: int, size: float
) -> None:
    random = np.random.default_rng(int(size) % 1000 + decimals)
    values = random.uniform(-size, size, 200)
    values[:40] = np.floor(values[:40]) + random.choice(
        [0.5, 0.25, 0.125, 0.005, 0.05, 0.00005], 40
    )  # ties and near-ties
    values[40:44] = 0.0, -0.0, 9999.99996, 99999999.5
    show = random.random(200) < 0.7
    whole = np.arange(200) * int(size + 1) - 5
    for prefix in (b"", b" X", b"LONG/"):
        columns = [
            Column(prefix, values, decimals),
            Column(prefix, values[::-1], decimals, show),
            Column(b" N", whole),
        ]
        assert table(columns) == by_percent(columns)


def test_a_tie_goes_to_the_even_digit_only_where_the_double_is_exactly_a_tie() -> None:
    values = np.array(
        [0.125, 0.375, 0.145, 2.675, 1.005, -0.125]
    )  # 2.675 and 1.005 lie below the tie, 0.145 below too
    assert table([Column(b"", values, 2)]) == b"0.12\n0.38\n0.14\n2.67\n1.00\n-0.12\n"


def test_what_is_not_finite_or_huge_is_printed_as_percent_prints_it() -> None:
    columns = [
        Column(b"X", np.array([np.nan, np.inf, -np.inf, 1e300, 5e-324, -0.0]), 4),
        Column(b" ", np.arange(6)),
    ]
    assert table(columns) == by_percent(columns)


def test_integers_up_to_the_ends_of_int64_are_printed() -> None:
    ends = np.array(
        [np.iinfo(np.int64).min, np.iinfo(np.int64).max, 0, -1, 10**15, 10**15 - 1, 9999, 10000, -10000]
    )
    assert table([Column(b"", ends)]) == b"".join(b"%d\n" % value for value in ends)


def test_columns_longer_than_a_chunk_are_whole() -> None:
    values = np.random.default_rng(1).normal(0, 100, 2 * number_text.CHUNK + 3)
    columns = [Column(b"X", values, 4), Column(b" Y", -values, 3)]
    assert table(columns) == by_percent(columns)
    assert len(list(table_parts(columns))) == 3


def test_choices_and_constants_stand_between_the_numbers() -> None:
    parts = [
        Choice(np.array([1, 0, 2]), (b"", b"G0", b"G1")),
        Column(b" X", np.array([1.0, -2.0, 0.0]), 1),
        b";",
    ]
    assert table(parts, b"\r\n") == b"G0 X1.0;\r\n X-2.0;\r\nG1 X0.0;\r\n"


def test_an_empty_table_is_empty_text() -> None:
    assert table([Column(b"X", np.empty(0), 4)]) == b""


def test_rounded_values_never_read_minus_zero() -> None:
    values = round_as_printed(np.array([-0.00004, -0.0, 0.00006, -1.23456]), 4)
    assert table([Column(b"", values, 4)]) == b"0.0000\n0.0000\n0.0001\n-1.2346\n"
    assert round_as_printed(np.array([0.1 + 0.2]), 4)[0] == 0.3


@pytest.mark.parametrize(
    "parts",
    [
        [Column(b"X", np.zeros(2), 4), Column(b"Y", np.zeros(3), 4)],
        [Column(b"X", np.zeros(2), 10)],
        [Column(b"X", np.zeros(2), -1)],
        [Column(b"X", np.zeros(2, int), 1)],
        [Column(b"\0", np.zeros(2), 1)],
        [Choice(np.zeros(2, int), (b"a\0",))],
        [b"only a constant"],
    ],
)
def test_unusable_columns_are_refused(parts: list[Column]) -> None:
    with pytest.raises(ValueError):
        table(parts)


def test_the_comparison_sees_one_wrong_digit() -> None:
    columns = [Column(b"X", np.array([1.00004999]), 4)]
    assert table(columns) != by_percent([Column(b"X", np.array([1.0001]), 4)])


@pytest.mark.parametrize("decimals", [0, 1, 4, 6, 9])
@pytest.mark.parametrize("size", [3, 10**5, 10**8, 10**13])
def test_units_are_printed_as_the_number_they_count(decimals: int, size: int) -> None:
    random = np.random.default_rng(size % 1000 + decimals)
    units = random.integers(-size, size, 300)
    units[:4] = 0, -1, 10**decimals, -(10**decimals) + 1
    show = random.random(300) < 0.6
    rows = []
    for unit, shown in zip(units.tolist(), show.tolist(), strict=True):
        whole, fraction = divmod(abs(unit), 10**decimals)
        number = f"{'-' if unit < 0 else ''}{whole}" + (f".{fraction:0{decimals}d}" if decimals else "")
        rows.append(f" X{number}" + (f"LONG{number}" if shown else "") + "\n")
    text = table([Units(b" X", units, decimals), Units(b"LONG", units, decimals, show)])
    assert text == "".join(rows).encode()
    beside_a_nan = table(
        [
            Units(b" X", units, decimals),
            Units(b"LONG", units, decimals, show),
            Column(b"", np.full(300, np.nan)),
        ]
    )
    assert beside_a_nan == text.replace(b"\n", b"nan\n")


def test_the_nearest_whole_number_is_that_of_rint() -> None:
    random = np.random.default_rng(5)
    values = np.concatenate([random.uniform(-size, size, 1000) for size in (2.0, 1e6, 0.99 * EXACT)])
    values = np.concatenate([values, [0.5, 1.5, -0.5, -1.5, 2.5, -0.0, EXACT - 0.5, 0.5 - EXACT]])
    np.testing.assert_array_equal(nearest_whole(values.copy()), np.rint(values).astype(np.int64))
    beyond = np.array([2.0**52 + 1.0])
    assert nearest_whole(beyond.copy())[0] != int(beyond[0])
