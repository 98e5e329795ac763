# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters as they are written: options, heads of NC files, and APT's CUTTER statement.

kind      the first word of an option: ``ball:10``, ``flat:10``, ``bull:10:2`` (corner radius),
          ``taperball:6:5deg`` (taper), ``taperbull:10:2:5deg`` (both), ``lollipop:10:6`` (diameter of the
          neck), ``barrel:10:85:2`` (radius of the flank, then that of the ball at the tip). The length of the
          edge may follow each; of a lollipop that up to the end of its neck.
APT       ``CUTTER/d,r,e,f,a,b,h``: d the diameter at which the bottom's and the flank's lines cross, r corner
          radius, e and f place of the corner circle's centre from axis and tip, a the bottom's angle, b the
          flank's (deg), h the height. It has no word for a neck, nor for a flank that is an arc: they are
          written behind it (see :mod:`~.toolpath.apt.writer`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.quantity import parse_angle, parse_length, show_given
from freecad_fiveaxis.core.base.sentences import say

from .cutter import FULL, Cutter

KINDS = {
    "ball": ("diameter",),
    "flat": ("diameter",),
    "bull": ("diameter", "corner"),
    "taperball": ("diameter", "taper"),
    "taperbull": ("diameter", "corner", "taper"),
    "lollipop": ("diameter", "neck"),
    "barrel": ("diameter", "flank", "corner"),
}
"""The cutter shapes on offer, with the sizes that each must have; the length may follow."""

SIZES = ("diameter", "corner", "taper", "neck", "flank", "length")
"""All sizes that cutters have."""

FORMS = (
    "ball:10",
    "flat:10",
    "bull:10:2",
    "taperball:6:5deg",
    "taperbull:10:1:5deg",
    "lollipop:10:6",
    "barrel:10:85:2",
)
"""An example of each."""

EQUAL_SIZE = 1e-4
"""mm and deg; sizes of a CL file that differ by less are the same: they have four decimals."""


def parse_cutter(text: str) -> Cutter:
    """Return the cutter written as its kind and sizes, as ``ball:10``, ``ball:0.5in:2in``, ``bull:10:2:60``
    (lengths in mm, else with their unit; angles in deg).

    Raises SettingsError that names the kinds on offer, or the quantity that cannot be read.
    """
    kind, sizes = cutter_sizes(text)
    given: dict[str, Any] = {**sizes, "corner": 0.0} if kind == "flat" else {**sizes}
    return Cutter(**given)


def cutter_sizes(text: str) -> tuple[str, dict[str, float]]:
    """Return the kind of a cutter's text and the sizes that it gives, by the names of ``Cutter`` (mm, rad);
    whether a cutter can have them is not looked at. Raises SettingsError as ``parse_cutter``."""
    kind, _, rest = str(text).strip().partition(":")
    kind = kind.strip().lower()
    names = KINDS.get(kind)
    if names is None:
        raise SettingsError(
            say(
                "cutter {text}: only {kinds} cutters are on offer; write it as {form}",
                text=show_given(text),
                kinds=", ".join(KINDS),
                form=FORMS[0],
            ),
            text,
        )
    parts = rest.split(":")
    if not rest.strip() or not len(names) <= len(parts) <= len(names) + 1:
        form, words = FORMS[list(KINDS).index(kind)], ":".join(names).upper()
        raise SettingsError(
            say(
                "cutter {text} needs {sizes} or {sizes}:LENGTH, as {form} or {form}:60",
                text=show_given(text),
                sizes=f"KIND:{words}",
                form=form,
            ),
            text,
        )
    readers = {"taper": parse_angle}
    named = zip((*names, "length"), parts, strict=False)
    return kind, {name: readers.get(name, parse_length)(part, f"cutter {name}") for name, part in named}


def kind_of(cutter: Cutter) -> str:
    """Return the kind under which the cutter is written."""
    if cutter.neck is not None:
        return "lollipop"
    if cutter.flank is not None:
        return "barrel"
    if cutter.taper > 0.0:
        return "taperbull" if cutter.ring > 0.0 else "taperball"
    if cutter.ring > 0.0:
        return "bull" if cutter.corner > 0.0 else "flat"
    return "ball"


def cutter_text(cutter: Cutter) -> str:
    """Return the cutter as an option that ``parse_cutter`` reads as the same one (mm, deg); its holder is not
    in it."""
    kind = kind_of(cutter)
    return sizes_text(
        kind, {name: getattr(cutter, name) for name in SIZES} | {"taper": math.degrees(cutter.taper)}
    )


def sizes_text(kind: str, sizes: Mapping[str, float]) -> str:
    """Return an option out of its kind and its sizes (SIZES), mm and **degrees**; those that the kind has not
    are left out. Whether there can be such a cutter is not looked at."""
    return ":".join([kind, *(_digits(name, sizes[name]) for name in (*KINDS[kind], "length"))])


def _digits(name: str, value: float) -> str:
    """As many digits as bring the number back; degrees only as many as anybody means."""
    return f"{value:.12g}deg" if name == "taper" else repr(value)


def cutter_name(cutter: Cutter) -> str:
    """Return the cutter as the machinist calls it, as ``ball 10 mm`` or ``taper bull 10 mm, corner 2 mm, 5
    deg``."""
    kind = kind_of(cutter)
    words = f"{kind.replace('taper', 'taper ')} {cutter.diameter:g} mm"
    words += f", corner {cutter.corner:g} mm" if "corner" in KINDS[kind] else ""
    words += f", neck {cutter.neck:g} mm" if cutter.neck is not None else ""
    words += f", flank {cutter.flank:g} mm" if cutter.flank is not None else ""
    return words + (f", {math.degrees(cutter.taper):.6g} deg" if "taper" in KINDS[kind] else "")


def apt_numbers(cutter: Cutter) -> tuple[float, ...]:
    """Return the numbers of the CUTTER statement, mm and deg: d and r where these say it all but for a neck
    or a flank, else all seven. Whoever does not know of a barrel's flank has a bull nose of its diameter and
    the radius of its tip, out of which nothing of it looks."""
    if cutter.taper == 0.0:
        return cutter.diameter, cutter.corner
    slope = math.degrees(cutter.taper)
    return _apt_diameter(cutter), cutter.corner, cutter.ring, cutter.corner, 0.0, slope, cutter.length


def _apt_diameter(cutter: Cutter) -> float:
    """Where the flank's line meets the bottom's: e + r (1 - sin b) / cos b from the axis."""
    return 2.0 * (cutter.ring + cutter.corner * (1.0 - math.sin(cutter.taper)) / math.cos(cutter.taper))


def neck_numbers(cutter: Cutter) -> tuple[float, ...]:
    """Return what the CUTTER statement has no word for, mm: diameter and upper end of a lollipop's neck; of
    others nothing."""
    return () if cutter.neck is None else (cutter.neck, cutter.length)


def flank_numbers(cutter: Cutter) -> tuple[float, ...]:
    """Return what it has no word for either, mm: radius of a barrel's flank, and its length; of others
    nothing."""
    return () if cutter.flank is None else (cutter.flank, cutter.length)


def cutter_from_apt(
    numbers: Sequence[float], scale: float = 1.0, neck: Sequence[float] = (), flank: Sequence[float] = ()
) -> Cutter | None:
    """Return the cutter of a CUTTER statement's numbers (d, or d and r, or more); ``scale`` mm of its unit,
    ``neck`` as of :func:`neck_numbers`, ``flank`` as of :func:`flank_numbers`, in that unit too.

    None where d is all that is said, for then the shape is not; and for shapes that are not on offer: a
    bottom that is no plane (a), a corner circle that does not touch it (f), a flank that narrows upwards (b),
    sizes that make no cutter.
    """
    if len(numbers) < 2:
        return None
    d, r, e, f, a, b, h = (*numbers[:7], *(math.nan,) * (7 - len(numbers)))
    d, r, e, f, h = (scale * size for size in (d, r, e, f, h))
    taper = 0.0 if math.isnan(b) else math.radians(b)
    if abs(f - r) > EQUAL_SIZE or abs(a) > EQUAL_SIZE or not 0.0 <= taper < math.pi / 2.0:
        return None
    ring = 0.5 * d - r * (1.0 - math.sin(taper)) / math.cos(taper) if math.isnan(e) else e
    if ring < -EQUAL_SIZE:
        return None
    corner = FULL if abs(ring) <= EQUAL_SIZE else r
    sizes: dict[str, Any] = {} if math.isnan(h) or h <= 0.0 else {"length": h}
    sizes |= {name: scale * size for name, size in zip(("neck", "length"), neck, strict=False)}
    sizes |= {name: scale * size for name, size in zip(("flank", "length"), flank, strict=False)}
    corner = r if flank else corner
    try:
        return Cutter(2.0 * (max(ring, 0.0) + r), corner=corner, taper=taper, **sizes)
    except SettingsError:
        return None
