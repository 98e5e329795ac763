# SPDX-License-Identifier: LGPL-2.1-or-later
"""numpy before 2.0 on Windows, as far as one can have it elsewhere: integers without a type of their own have
32 bits there.

Imported by a process of its own, it lets the functions of numpy that the core calls give such integers where
Windows does: those that make an array of Python's integers, and sums of what is narrower. FreeCAD up to 1.0
brings that numpy. Indices (flatnonzero, argsort, searchsorted, bincount) have 64 bits there too. Methods of
arrays stay as they are: nothing of C can be exchanged.
"""

import sys

import numpy as np

CORE = "freecad_fiveaxis"


def of_the_core():
    """Whether the caller's caller is ours: numpy's and scipy's own calls stay as they are."""
    return CORE in sys._getframe(2).f_code.co_filename


def narrow(array):
    """With 32 bits; what needs more has 64 there too."""
    return (
        array.astype(np.int32)
        if array.dtype == np.int64 and (array == array.astype(np.int32)).all()
        else array
    )


def typed(given):
    """Whether the values bring a type of their own."""
    return (
        any(map(typed, given))
        if isinstance(given, list | tuple)
        else isinstance(given, np.ndarray | np.generic)
    )


def of_values(function):
    def make_result(*given, **how):
        array, ours = function(*given, **how), of_the_core()
        wanted = how.get("dtype", given[1] if len(given) > 1 and function is not arange else None)
        values = given if function is arange else given[:1]
        return (
            narrow(array)
            if ours and (wanted is int or (wanted is None and not typed(list(values))))
            else array
        )

    return make_result


def filled(function, place):
    def make_result(*given, **how):
        array, ours = function(*given, **how), of_the_core()
        wanted = how.get("dtype", given[place] if len(given) > place else None)
        plain = wanted is None and function is full and type(given[1]) is int
        return narrow(array) if ours and (wanted is int or plain) else array

    return make_result


def summed(values, *given, **how):
    array = cumsum(values, *given, **how)
    slim = getattr(values, "dtype", None) in (np.bool_, np.int8, np.int32)
    return narrow(array) if of_the_core() and slim and "dtype" not in how else array


arange, cumsum, full = np.arange, np.cumsum, np.full
np.arange, np.array, np.asarray = (of_values(function) for function in (np.arange, np.array, np.asarray))
np.zeros, np.ones, np.empty, np.full = (
    filled(*one) for one in ((np.zeros, 1), (np.ones, 1), (np.empty, 1), (np.full, 2))
)
np.cumsum = summed
