# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: a body of revolution about the tool axis.

contact   where the cutter touches the part (CC).       tip     the lowest point of the cutter, on its axis.
axis      unit vector from the tip to the holder.       ball    a cutter whose corner radius is its radius.
corner    radius of the rounding between bottom and flank: the centres of its circles make a ring about the
          axis.
ring      radius of that ring: diameter / 2 - corner. A ball has none (0); a flat has no corner (0).
hub       the middle of the ring, on the axis, one corner radius above the tip. Of a ball it is the ball's
          centre.
taper     angle of the flank with the axis: above the corner the cutter widens as a cone that touches the
          corner circles.
rim       the upper end of the flank, at the height ``length`` above the tip.
flank     of a barrel: an arc of large radius between the ball at its tip and its largest diameter
          (:mod:`.barrel`).
neck      of a lollipop: a cylinder thinner than the ball that rises from it to the height ``length``. It does
          not cut.
undercut  angle by which the axis may lean below the surface while the ball, and not its neck, is what touches
          it there.

The parameters are those of APT's ``CUTTER/d,r,e,f,a,b,h`` with a level bottom: r the corner radius, e the
ring, f = r, a = 0, b the taper, h the length. The diameter here is that of the rounded end, 2 (e + r), which
is APT's d only where there is no taper; of a barrel it is the largest one, and its hub is the centre of the
ball at its tip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Angle, Length, say

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.records import Floats

    from .barrel import Flank

LEAST, MOST = 1e-3, 1e4
"""mm; a cutter below a micrometre or above ten metres is a slip of the pen."""

MOST_TAPER = math.radians(60.0)
"""rad; a flank that leans further is the bottom of a countersink."""

FULL = math.inf
"""The corner radius of a ball, where it is not given: as large as it can be, half the diameter."""

LEAN = 1e-6
"""rad by which rounding may turn a normal that is square to the flank."""

ANY = (-2.0, 2.0)
"""Parts along the axis of all unit directions, whatever their rounding."""

CHORDS = 32
"""Of a barrel's flank where it is given as frusta: they leave 23 mm of an arc of 85 mm by less than 1
micrometre."""

Frustum = tuple[float, float, float, float]
"""A cone frustum about the axis: z0, r0, z1, r1: heights above the tip and the radii there, mm; z0 below
z1."""


class Profile(NamedTuple):
    """What the body is made of, mm. ``rounds`` (k, 3): all points within ``corner`` of a disc, rows of ring
    (the disc's radius), corner, height of the disc above the tip. ``flanks`` and ``holder`` (m, 4) rows of
    frusta z0, r0, z1, r1: what cuts, and what does not."""

    rounds: Floats
    flanks: Floats
    holder: Floats


@dataclass(frozen=True)
class Cutter:
    """A cutter, mm and rad: ``diameter`` of its rounded end, ``length`` (cutting edge, tip upwards), each
    from LEAST to MOST; ``corner`` from 0 (flat) to half the diameter (ball, where it is not given); ``taper``
    of the flank, 0 to MOST_TAPER; ``holder``: shank and holder as frusta above the tip; ``neck``: diameter of
    a lollipop's neck, from LEAST to less than the ball's; None: there is no neck. ``flank``: radius of a
    barrel's flank, more than half the diameter; its ``corner`` is the radius of the ball at its tip. None: it
    is no barrel.

    Raises SettingsError for a cutter that cannot be.
    """

    diameter: float
    length: float = 50.0
    corner: float = FULL
    taper: float = 0.0
    holder: tuple[Frustum, ...] = ()
    neck: float | None = None
    flank: float | None = None

    def __post_init__(self) -> None:
        for name in ("diameter", "length"):
            value = getattr(self, name)
            if not LEAST <= value <= MOST:
                raise SettingsError(
                    say(
                        "cutter {name} is {value}; give {least} to {most}",
                        name=name,
                        value=Length(value),
                        least=Length(LEAST, bare=True),
                        most=Length(MOST),
                    ),
                    value,
                )
        if self.corner == FULL:
            object.__setattr__(self, "corner", self.radius)
        _check_corner(self)
        if self.flank is not None:
            from .barrel import check_flank

            check_flank(self.diameter, self.corner, self.flank, self.taper, self.length, LEAST)
        _check_neck(self)
        _check_taper(self)
        for row in self.holder:
            _check_frustum(row)

    @property
    def radius(self) -> float:
        """Radius of the rounded end, mm: from the hub no point of it lies farther. Of a barrel half its
        largest diameter."""
        return self.diameter / 2.0

    @property
    def ring(self) -> float:
        """Radius of the ring on which the corner circles' centres lie, mm; 0 for a ball, and for the ball at
        a barrel's tip."""
        return self.radius - self.corner if self.flank is None else 0.0

    @property
    def barrel(self) -> Flank | None:
        """The flank of a barrel; None of all others."""
        if self.flank is None:
            return None
        from .barrel import flank_of

        return flank_of(self.diameter, self.corner, self.flank)

    @property
    def touches_as_ball(self) -> bool:
        """Whether it touches with one ball about its hub however it leans, so that the hub does not depend on
        the axis."""
        return self.ring == 0.0 and self.flank is None

    @property
    def has_level_bottom(self) -> bool:
        """Whether it ends in a plane within its corner, as a flat or bull nose cutter."""
        return not self.touches_as_ball and self.barrel is None

    @property
    def contact_reach(self) -> float:
        """No contact is farther from the hub, mm."""
        return self.radius if (barrel := self.barrel) is None else math.hypot(self.radius, barrel.rise)

    @property
    def top_radius(self) -> float:
        """Radius of the rim, mm; of a lollipop that of its neck."""
        if self.neck is not None:
            return 0.5 * self.neck
        if self.flank is not None:
            return self.radius
        slope = math.tan(self.taper)
        return self.ring + self.corner / math.cos(self.taper) + (self.length - self.corner) * slope

    @property
    def undercut(self) -> float:
        """Undercut, rad: 0 for all that is as wide above its rounded end; of a lollipop less than a right
        angle."""
        return 0.0 if self.neck is None else math.acos(self.neck / self.diameter)

    @property
    def stem(self) -> tuple[Frustum, ...]:
        """What of the cutter itself does not cut, as frusta above the tip: a lollipop's neck, from where it
        leaves the ball."""
        return (
            ()
            if self.neck is None
            else ((_neck_begins(self), self.top_radius, self.length, self.top_radius),)
        )

    def scale(self, share: float) -> Cutter:
        """Return the cutter with its end, and its neck, ``share`` times as large, and as long as before."""
        neck, flank = (None if size is None else share * size for size in (self.neck, self.flank))
        return replace(
            self, diameter=share * self.diameter, corner=share * self.corner, neck=neck, flank=flank
        )

    def thicken_neck(self, margin: float) -> Cutter:
        """Return the cutter with its neck ``margin`` mm thicker all round, where there is one, and at most
        half as far from the ball."""
        if self.neck is None:
            return self
        return replace(self, neck=min(self.neck + 2.0 * margin, 0.5 * (self.neck + self.diameter)))

    def tip_at(self, hub: Floats, axis: Floats) -> Floats:
        """Return the tip (n, 3) mm where the hub (of a ball: its centre) (n, 3) mm stands and the unit
        ``axis`` (n,
        3) points."""
        return hub - self.corner * axis

    def hub_shift(self, normal: Floats, axis: Floats, feed: Floats) -> Floats | float:
        """How far (n, 3) mm the hub lies from the centre of the corner circle that would touch at the contact
        alone, ``contact + corner x normal``; 0.0 of a cutter that touches as a ball. Unit ``normal``,
        ``axis`` and ``feed`` (n, 3); the feed only counts where a level bottom lies on the surface."""
        from .contact import ring_direction

        if (barrel := self.barrel) is not None:
            return barrel.hub_shift(normal, axis)
        return 0.0 if self.ring == 0.0 else self.ring * ring_direction(normal, axis, feed, self.ring)

    def tip_from_contact(self, point: Floats, normal: Floats, axis: Floats, feed: Floats) -> Floats:
        """Return the tip (n, 3) mm of the cutter that touches the plane through ``point`` with unit
        ``normal``, both (n, 3), from above.

        ``axis`` and ``feed`` (n, 3) unit; the feed only chooses where the bottom of a flat or bull nose that
        stands square on the plane touches it (:func:`~.contact.ring_direction`). Where the axis leans further
        than the flank allows, which is no place to cut, the cutter touches with its rim. A lollipop that
        leans below the surface, within its undercut, touches with its ball: the plane must end before its
        neck.
        """
        import numpy as np

        from .contact import ring_direction

        tip = point + self.corner * normal + self.hub_shift(normal, axis, feed) - self.corner * axis
        lowest = math.sin(self.taper) - math.sin(self.undercut) - LEAN
        beyond = np.flatnonzero(np.einsum("ij,ij->i", normal, axis) < lowest)
        if len(beyond):
            out = ring_direction(normal[beyond], axis[beyond], feed[beyond], self.top_radius)
            tip[beyond] = point[beyond] + self.top_radius * out - self.length * axis[beyond]
        return np.asarray(tip)

    def effective_radius(self, normal: Floats, axis: Floats, direction: Floats) -> Floats:
        """Radius (n,) mm of what the cutter sweeps, across its way at the contact: infinite where a level
        bottom lies there.

        ``normal``, ``axis`` (n, 3) unit; ``direction`` (n, 3): across the way, any length, not along the
        normal."""
        import numpy as np

        from .silhouette import effective_radius

        radius = effective_radius(normal, axis, direction, self.ring, self.corner)
        if (barrel := self.barrel) is None:
            return radius
        by_flank = effective_radius(normal, axis, direction, barrel.ring, barrel.radius)
        return np.where(barrel.touches(normal, axis), by_flank, radius)

    def equivalent_radius(
        self, normal: Floats, axis: Floats, direction: Floats, height: float, bend: float = 0.0
    ) -> Floats:
        """Radius (n,) mm of the ball that is as wide as what the cutter sweeps, ``height`` mm above the
        contact.

        Up to there that ball lies within the sweep, so the ball's scallop is never below the cutter's. Other
        arguments as for the effective radius; a ``height`` above 0; ``bend`` 1/mm as in
        :func:`~.silhouette.width_at`.
        """
        import numpy as np

        from .silhouette import width_at

        width = width_at(normal, axis, direction, height, self.hub_discs(), bend)
        return np.asarray((0.25 * width * width + height * height) / (2.0 * height))

    def hub_discs(self) -> Floats:
        """Return the discs (k, 5) whose hull is what cuts: rows of radius, rounding, and height over the hub,
        mm; and least and largest part along the axis of the directions in which they support it. Of a
        barrel's flank the radius is negative."""
        import numpy as np

        tip, top = (
            (self.ring, self.corner, 0.0, *ANY),
            (self.top_radius, 0.0, max(self.length, self.corner) - self.corner, *ANY),
        )
        if self.stem:
            return np.array([tip])
        if (barrel := self.barrel) is not None:
            return np.array([tip, (barrel.ring, barrel.radius, barrel.rise, -barrel.cosine, 0.0), top])
        return np.array([tip, top])

    def profile(self) -> Profile:
        """Return the body in pieces, for whoever asks whether it enters the part."""
        import numpy as np

        low = self.corner * (1.0 - math.sin(self.taper))
        flank = [(low, self.ring + self.corner * math.cos(self.taper), self.length, self.top_radius)]
        if (barrel := self.barrel) is not None:
            flank = [*_chords(barrel), (self.corner + barrel.rise, self.radius, self.length, self.radius)]
            flank = flank[: -1 if flank[-1][0] >= self.length else None]
        return Profile(
            np.array([(self.ring, self.corner, self.corner)]),
            np.array(flank if self.length > low and not self.stem else []).reshape(-1, 4),
            np.array([*self.stem, *self.holder], float).reshape(-1, 4),
        )


def _chords(barrel: Flank) -> list[Frustum]:
    """Return the flank as frusta, each over a chord of its arc."""
    turn = [barrel.begins + k / CHORDS * (0.5 * math.pi - barrel.begins) for k in range(CHORDS + 1)]
    height = [barrel.corner + barrel.rise - barrel.radius * math.cos(angle) for angle in turn]
    radius = [barrel.ring + barrel.radius * math.sin(angle) for angle in turn]
    return list(zip(height[:-1], radius[:-1], height[1:], radius[1:], strict=True))


def _check_corner(cutter: Cutter) -> None:
    if not 0.0 <= cutter.corner <= cutter.radius:
        text = say(
            "cutter corner radius is {corner}; give 0 to {radius}, half the diameter",
            corner=Length(cutter.corner),
            radius=Length(cutter.radius),
        )
        raise SettingsError(text, cutter.corner)


def _check_neck(cutter: Cutter) -> None:
    """Refuse a neck as wide as the ball, which is a ball end mill, and one of a cutter that ends within its
    ball, which would never begin."""
    if cutter.neck is None:
        return
    if not LEAST <= cutter.neck < cutter.diameter:
        text = say(
            "cutter neck is {neck}; give {least} or more, and less than {diameter}, the diameter of the ball",
            neck=Length(cutter.neck),
            least=Length(LEAST),
            diameter=Length(cutter.diameter),
        )
        raise SettingsError(text, cutter.neck)
    if cutter.ring > 0.0 or cutter.taper != 0.0 or cutter.flank is not None:
        raise SettingsError(
            say("cutter neck: only a ball without a taper has one; leave corner radius and taper out"),
            cutter.neck,
        )
    if not cutter.length > (begins := _neck_begins(cutter)):
        text = say(
            "cutter length is {length}, the neck begins {begins} above the tip; give a longer cutter",
            length=Length(cutter.length),
            begins=Length(begins),
        )
        raise SettingsError(text, cutter.length)


def _neck_begins(cutter: Cutter) -> float:
    """Return the height above the tip, mm, at which the neck leaves the ball."""
    return cutter.radius * (1.0 + math.sin(cutter.undercut))


def _check_taper(cutter: Cutter) -> None:
    """Refuse a taper that narrows upwards, which would end in nothing, and one of a cutter shorter than its
    corner, which would never begin."""
    taper = math.degrees(cutter.taper)
    if not 0.0 <= cutter.taper <= MOST_TAPER:
        least = math.degrees(MOST_TAPER)
        raise SettingsError(
            say(
                "cutter taper is {taper}; give 0 to {least}, from the axis to the flank",
                taper=Angle(taper),
                least=Angle(least),
            ),
            cutter.taper,
        )
    begins = cutter.corner * (1.0 - math.sin(cutter.taper))
    if cutter.taper > 0.0 and not cutter.length > begins:
        text = say(
            "cutter length is {length}, the taper begins {begins} above the tip; give a longer cutter",
            length=Length(cutter.length),
            begins=Length(begins),
        )
        raise SettingsError(text, cutter.length)
    if not cutter.top_radius <= MOST:
        text = say(
            "cutter taper {taper} makes it {width} wide; give a smaller taper or length",
            taper=Angle(taper),
            width=Length(2 * cutter.top_radius),
        )
        raise SettingsError(text, cutter.taper)


def _check_frustum(row: Frustum) -> None:
    if len(row) != 4 or not (
        0.0 <= row[0] < row[2] <= MOST and 0.0 <= row[1] <= MOST and 0.0 <= row[3] <= MOST
    ):
        text = say(
            "holder {sizes} is no cone; give z0, r0, z1, r1 in mm with 0 <= z0 < z1 and radii of at least 0",
            sizes=tuple(row),
        )
        raise SettingsError(text, row)
