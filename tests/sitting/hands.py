# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouse and keyboard. ``clicks`` and ``keys`` count what a user would do."""

from __future__ import annotations

import subprocess

from eyes import Thing

TOUCH = 0.15
"""s that a hand rests before it presses, so that the window knows where the mouse is."""


class Hands:
    """Does what hands do. ``counting``: whether it counts as the user's work."""

    def __init__(self) -> None:
        self.clicks, self.keys, self.counting = 0, 0, True

    def _do(self, *words: object) -> None:
        subprocess.run(["xdotool", *map(str, words)], check=True, timeout=60, stdout=subprocess.DEVNULL)

    def click(self, thing: Thing, at: tuple[float, float] = (0.5, 0.5), double: bool = False) -> None:
        """Click a thing, at these parts of its width and height."""
        left, top, width, height = thing.box
        self.click_at(left + at[0] * width, top + at[1] * height, double)

    def click_at(self, x: float, y: float, double: bool = False) -> None:
        """Click a place of the screen, pixels."""
        self.clicks += self.counting
        self.point(x, y)
        self._do("click", *(("--repeat", 2, "--delay", 60) if double else ()), 1)

    def point(self, x: float, y: float) -> None:
        """Put the mouse there."""
        self._do("mousemove", int(x), int(y), "sleep", TOUCH)

    def wheel(self, notches: int) -> None:
        """Turn the wheel where the mouse stands; downwards where positive."""
        self._do("click", "--repeat", abs(notches), "--delay", 40, 5 if notches > 0 else 4)

    def press(self, *keys: str) -> None:
        """Press keys one after the other: "Escape", "ctrl+s"."""
        self.keys += self.counting * len(keys)
        self._do("key", "--delay", 40, *keys)

    def write(self, text: str) -> None:
        """Type a text."""
        self.keys += self.counting * len(text)
        self._do("type", "--delay", 8, text)
