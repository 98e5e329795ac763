# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences that can be said again in another language and in other units.

template  English with places for values, as "The tool enters the part by {depth}."; what a translator
          translates.
sentence  a str: the template with its values in the core's units, as the command line and the reports say it.
          It remembers template and values, so that a window says it in its user's language and units
          (:func:`render`).
measure   a value with its unit: a length, an area, an angle, a feed, a time.
name      of a setting, of choices of one, of a task: in the words of the command line, which a window says by
          its own labels.

The templates are found in the source by ``scripts/translations``: the texts of :func:`say`, :func:`plural`
and :class:`Template` are therefore written out as literals.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, ClassVar

CONTEXT = "FiveAxisCore"
"""The context under which the templates are translated."""


IN_FULL = "in full"
"""The form of a number with seven digits and no exponent, however small: a bound that somebody has to keep
to."""


def format_number(value: float, form: str) -> str:
    """Return a number in a form as in ``format``, or :data:`IN_FULL`."""
    return f"{Decimal(f'{value:.7g}'):f}" if form == IN_FULL else f"{value:{form}}"


@dataclass(frozen=True)
class Number:
    """A plain number; ``form`` as in ``format``, or :data:`IN_FULL`."""

    value: float
    form: str = "g"

    def __str__(self) -> str:
        return format_number(self.value, self.form)


@dataclass(frozen=True)
class Measure:
    """A value, or several with one unit behind the last. ``bare``: the reports leave the unit out, a window
    never does."""

    value: float | tuple[float, ...]
    form: str = "g"
    bare: bool = False
    between: str = ", "
    unit: ClassVar[str] = ""

    @property
    def values(self) -> tuple[float, ...]:
        """The values, one or several."""
        return self.value if isinstance(self.value, tuple) else (self.value,)

    @property
    def numbers(self) -> str:
        """The values alone."""
        return self.between.join(format_number(value, self.form) for value in self.values)

    def __str__(self) -> str:
        return self.numbers if self.bare else f"{self.numbers} {self.unit}"


class Length(Measure):
    """mm."""

    unit = "mm"


@dataclass(frozen=True)
class Point(Length):
    """A place or direction of three lengths, in parentheses."""

    form: str = ".6g"

    def __str__(self) -> str:
        return f"({self.numbers})" if self.bare else f"({self.numbers}) {self.unit}"


class Area(Measure):
    """mm2."""

    unit = "mm2"


class Volume(Measure):
    """mm3."""

    unit = "mm3"


class Angle(Measure):
    """Degrees."""

    unit = "deg"


class Feed(Measure):
    """mm/min."""

    unit = "mm/min"


class TurnRate(Measure):
    """deg/min."""

    unit = "deg/min"


class Turn(Measure):
    """deg/mm: how far an axis turns along the path."""

    unit = "deg/mm"


class Time(Measure):
    """Seconds."""

    unit = "s"


MEASURES: dict[str, type[Measure]] = {
    kind.unit: kind for kind in (Length, Area, Volume, Angle, Feed, TurnRate, Turn, Time)
}
"""The kinds of measures by their unit."""


def measure(value: float, unit: str, form: str = "g", bare: bool = False) -> Measure | Number:
    """Return a value in ``unit``; a plain number where the unit is no measure's (``1`` or none)."""
    return MEASURES[unit](value, form, bare) if unit in MEASURES else Number(value, form)


@dataclass(frozen=True)
class Option:
    """A setting by its name in the core (``max_axis_angle``): ``--max-axis-angle`` on the command line, its
    label in a window.

    ``flag``: with the two dashes; ``given``: what stands for its value on the command line, as ``S``."""

    name: str
    flag: bool = True
    given: str = ""

    def __str__(self) -> str:
        return (
            ("--" if self.flag else "")
            + self.name.rstrip("_").replace("_", "-")
            + (f" {self.given}" if self.given else "")
        )


@dataclass(frozen=True)
class Choice:
    """Choices of a setting, by their names in the core: ``gouge lift, leave-out`` on the command line, label
    and choices in a window. ``flag``: with the two dashes; ``alone``: the choices without the setting."""

    option: str
    choices: tuple[str, ...]
    flag: bool = False
    alone: bool = False

    def __str__(self) -> str:
        choices = ", ".join(self.choices)
        return choices if self.alone else f"{Option(self.option, self.flag)} {choices}"


@dataclass(frozen=True)
class Task:
    """A task by its name in the core: as it is typed on the command line, a command's name in a window."""

    name: str

    def __str__(self) -> str:
        return f"`{self.name}`"


Translate = Callable[[str, str], str]
"""Context and English text -> the text in the user's language; the English one where there is no
translation."""
Units = Callable[[Measure], str]
"""A measure -> its text in the user's units."""
Names = Callable[[Option | Choice | Task], str]
"""A setting, choices or a task -> what the window calls it."""
Numbers = Callable[[Number], str]
"""A plain number -> its text."""


class Sentence(str):
    """English in the core's units; ``template`` and ``values`` are what it was made of. See :func:`say`."""

    template: str
    values: Mapping[str, Any]
    translated: bool

    def __new__(cls, template: str, values: Mapping[str, Any], translated: bool = True) -> Sentence:
        """Make the English text of it, and keep what it is made of."""
        sentence = super().__new__(
            cls, template.format_map({name: str(value) for name, value in values.items()})
        )
        sentence.template, sentence.values, sentence.translated = template, values, translated
        return sentence

    def __reduce__(self) -> tuple[Any, ...]:
        return Sentence, (self.template, self.values, self.translated)

    def __add__(self, other: str) -> Sentence:
        return join_sentences((self, other), "")

    def __radd__(self, other: str) -> Sentence:
        return join_sentences((other, self), "")


def say(template: str, **values: Any) -> Sentence:
    """Return the sentence of a template. A value is a Measure, a Number, a name of a setting or a task, a
    sentence, an error, a number or a text."""
    return Sentence(template, {name: _value(value) for name, value in values.items()})


def plural(count: int, one: str, many: str, **values: Any) -> Sentence:
    """Return the sentence of ``one`` for a count of 1, that of ``many`` for any other; both may name
    ``{count}``."""
    return say(one if count == 1 else many, count=int(count), **values)


def ask_for_near(given: str, names: Collection[str]) -> Sentence | str:
    """Return the question whether that name was meant which is nearest to the one ``given``, with a space
    behind it; empty where none of the ``names`` is near."""
    near = difflib.get_close_matches(given, names, n=1)
    return say("did you mean {near}? ", near=near[0]) if near else ""


class Template(str):
    """A template that stands in a table and gets its values later."""

    def say(self, **values: Any) -> Sentence:
        """Return the sentence of these values."""
        return say(str(self), **values)


def join_sentences(parts: Iterable[str], between: str = " ") -> Sentence:
    """Sentences one after the other, each of which is translated; empty ones are left out."""
    given = {f"part{at}": _value(part) for at, part in enumerate(part for part in parts if part)}
    glue = between.replace("{", "{{").replace("}", "}}")
    return Sentence(glue.join(f"{{{name}}}" for name in given), given, translated=False)


CONTROL = re.compile("[\x00-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069]")
"""What moves the cursor, ends the line or turns the way of writing; a file's name may hold it, a line that is
shown may not."""


def one_line(text: str) -> str:
    r"""Return a text from outside, as a name of a file, with its control characters written out (``\n``)."""
    return CONTROL.sub(lambda found: found[0].encode("unicode_escape").decode("ascii"), text)


class Part:
    """A value of a sentence that is a text of its own, shown in another form."""

    def render(self, render: Callable[[str], str], translate: Translate) -> str:
        """Give the part in another language; ``render`` does so with a text. Raises NotImplementedError where
        there is none."""
        raise NotImplementedError


def render(text: str, translate: Translate, units: Units, names: Names = str, numbers: Numbers = str) -> str:
    """Return a sentence in another language, other units, a window's names and its way to write numbers.
    A text that is no sentence comes back as it is."""
    if not isinstance(text, Sentence):
        return text
    template = translate(CONTEXT, text.template) if text.translated else text.template
    return template.format_map(
        {name: _render_value(value, translate, units, names, numbers) for name, value in text.values.items()}
    )


def _render_value(value: Any, translate: Translate, units: Units, names: Names, numbers: Numbers) -> str:
    if isinstance(value, Number):
        return numbers(value)
    if isinstance(value, Option | Choice | Task):
        return names(value)
    if isinstance(value, Part):
        return value.render(lambda text: render(text, translate, units, names, numbers), translate)
    if isinstance(value, Measure):
        return units(value)
    return render(value, translate, units, names, numbers) if isinstance(value, str) else str(value)


def _value(value: Any) -> Any:
    """Return what a sentence keeps: no arrays' numbers, of an error its text, and of what comes from outside
    one line."""
    if isinstance(value, Sentence | Measure | Number | Option | Choice | Task):
        return value
    if isinstance(value, BaseException) and value.args and isinstance(value.args[0], Sentence):
        return value.args[0]
    return Number(float(value)) if isinstance(value, float) else one_line(str(value))


@dataclass(frozen=True)
class Beginning(Part):
    """A text that begins a sentence: with a capital letter."""

    text: str

    def __str__(self) -> str:
        return str(self.text)[:1].upper() + str(self.text)[1:]

    def render(self, render: Callable[[str], str], translate: Translate) -> str:
        """Give the text in another language, with a capital letter."""
        return str(Beginning(render(self.text)))


def beginning(text: str) -> Sentence:
    """Return a text with a capital letter, as a sentence of its own."""
    return Sentence("{text}", {"text": Beginning(text)}, translated=False)
