# SPDX-License-Identifier: LGPL-2.1-or-later
"""A vismach model of LinuxCNC: a Python script that draws a machine. It is read, never run.

plain    numbers, texts, lists, + - * / of numbers, names for these, vismach's parts, ``hal.component`` and
         ``main(model, tool, work)``, as statements of the script itself.
unread   all else: loops, functions, classes, calls of anybody's own. What they give is :class:`Unread`, and
         parts that they may have changed are ``spoilt``: whoever meets one in the model tells its line.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

from .vismach_parts import PARTS, Component, Listing, Part, Unread, make_part, unread

LONGEST = 1_000_000
"""Bytes; no model is as long."""
LARGEST = 1e9
"""No number of a model is as large."""
MODULES = ("vismach", "qt_vismach")
"""The last part of the names of the modules that have the parts."""
AT_WILL = {"exec", "eval", "globals", "locals", "vars", "setattr", "compile", "__import__"}
"""Whoever calls these may change any name."""
KNOWN = {"OpenGL", "math", "numpy", "hal", "linuxcnc", "rs274"}
"""Packages of which it is known that they have none of vismach's names, whoever imports all of theirs."""
HARMLESS = {"set_volume", "newpin", "newparam", "ready"}
"""Methods that move no part."""


@dataclass(frozen=True, eq=False)
class Model:
    """What ``main`` was given: the whole, and the captures at the tip of the tool and at the work."""

    root: Any
    tip: Any
    work: Any


def read_model(path: Path, settings: Sequence[str] = ()) -> Model:
    """Read a model; ``settings``: ``name=number`` that HAL gives it. Raises MachineError for what is no
    Python, or has no ``main(model, tool, work)``, FileError."""
    script = _Script(dict(one.split("=", 1) for one in settings if "=" in one))
    try:
        script.run(_parse(path).body)
    except RecursionError as error:
        raise wrong(path, say("it is nested too deep; give the script of a vismach model")) from error
    if script.model is None:
        text = say("it has no main(model, tool, work) that can be read; give the script of a vismach model")
        raise wrong(path, text)
    script.spoil_by_functions()
    return script.model


def wrong(path: Path, problem: str) -> MachineError:
    """Return what to raise of a ``problem`` with the model."""
    return MachineError(say("{path}: {problem}", path=path, problem=problem), str(path))


def _parse(path: Path) -> ast.Module:
    content = read_bytes(path, "vismach model")
    if b"\0" in content or len(content) > LONGEST:
        raise wrong(path, say("it is no script; give the script of a vismach model"))
    try:
        return ast.parse(content.decode("utf-8-sig", "replace"))
    except (SyntaxError, ValueError, MemoryError) as error:
        line, what = getattr(error, "lineno", None) or 1, getattr(error, "msg", "") or str(error)
        text = say("line {line} is no Python 3 ({what}); correct it", line=line, what=what)
        raise wrong(path, text) from error


@dataclass
class _Script:
    """The names of a script as its statements go by."""

    settings: dict[str, str]
    model: Model | None = None
    names: dict[str, Any] = field(default_factory=dict)
    of_vismach: dict[str, str] = field(default_factory=dict)
    """Names of parts, as the script calls them."""
    modules: set[str] = field(default_factory=set)
    in_functions: dict[str, int] = field(default_factory=dict)
    """Names that functions use, and their lines: whoever calls one may change what any of them ever was."""
    set_by_functions: dict[str, Unread] = field(default_factory=dict)
    """Names that functions set for the whole script."""

    def run(self, body: Sequence[ast.stmt]) -> None:
        """Take statements one after the other."""
        for one in body:
            self._take(one)
            for node in ast.walk(one):
                if isinstance(node, ast.NamedExpr):
                    self.names[node.target.id] = unread(node)

    def _take(self, one: ast.stmt) -> None:
        match one:
            case ast.Assign(targets=targets, value=value):
                found = self._value(value)
                for target in targets:
                    self._assign(target, found)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                self._assign(target, self._value(value))
            case ast.AugAssign(target=ast.Name(id=name), op=op, value=value) if name not in (
                self.set_by_functions
            ) and isinstance(self.names.get(name), float):
                self.names[name] = _arithmetic(one, op, self.names[name], self._value(value))
            case ast.Import() | ast.ImportFrom():
                self._import(one)
            case ast.Expr(value=ast.Call() as call):
                self._call_alone(call)
            case ast.If(test=ast.Compare() as test) if ast.unparse(test) == "__name__ == '__main__'":
                self.run(one.body)
            case _:
                self._take_other(one)

    def _take_other(self, one: ast.stmt) -> None:
        """Take what builds no part."""
        if isinstance(one, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            self._define(one)
        elif isinstance(one, ast.For) and _is_settings(one):
            self._set(one)
        elif not (isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant)):
            self._spoil(one)

    # ------------------------------------------------------------------------------------------ statements

    def _assign(self, target: ast.expr, found: Any) -> None:
        match target:
            case ast.Name(id=name):
                self.names[name] = found
                if isinstance(found, Part) and not found.label:
                    found.label = name
                if name in self.in_functions:
                    _mark(found, self.in_functions[name])
            case ast.Tuple(elts=places) | ast.List(elts=places) if (
                isinstance(found, Listing)
                and len(found.items) == len(places)
                and not any(isinstance(place, ast.Starred) for place in places)
            ):
                for place, item in zip(places, found.items, strict=True):
                    self._assign(place, item)
            case _:
                self._spoil(target)

    def _import(self, one: ast.Import | ast.ImportFrom) -> None:
        if isinstance(one, ast.Import):
            for alias in one.names:
                called = alias.asname or alias.name
                if alias.name.rpartition(".")[2] in MODULES:
                    self.modules.add(called)
                self.names[called.partition(".")[0]] = unread(one)
        elif (one.module or "").rpartition(".")[2] in MODULES:
            for alias in one.names:
                known = {name: name for name in (*PARTS, "main")}
                found = known if alias.name == "*" else {alias.asname or alias.name: alias.name}
                self.of_vismach |= found
                for name in found:
                    self.names.pop(name, None)
        elif any(alias.name == "*" for alias in one.names) and (one.module or "").split(".")[0] not in KNOWN:
            self.names, self.of_vismach = dict.fromkeys(self.names, unread(one)), {}
        else:
            self.names |= {alias.asname or alias.name: unread(one) for alias in one.names}

    def _call_alone(self, call: ast.Call) -> None:
        if self._callee(call.func) == "main":
            given = dict(zip(("model", "tool", "work"), call.args, strict=False))
            given |= {word.arg: word.value for word in call.keywords if word.arg}
            if self.model is None and {"model", "tool", "work"} <= set(given):
                self.model = Model(*(self._value(given[name]) for name in ("model", "tool", "work")))
        elif not (isinstance(call.func, ast.Attribute) and call.func.attr in HARMLESS):
            self._spoil(call)

    def _set(self, loop: ast.For) -> None:
        """Take what HAL gives the script on its line, where the script takes it; what is no number there may
        be anything."""
        for name, text in self.settings.items():
            try:
                self.names[name.strip()] = _finite(loop, float(text))
            except ValueError:
                self.names[name.strip()] = unread(loop)

    def _define(self, one: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) -> None:
        self.names[one.name] = unread(one)
        for node in ast.walk(one):
            if isinstance(node, ast.Name):
                self.in_functions.setdefault(node.id, one.lineno)
                _mark(self.names.get(node.id), one.lineno)
            elif isinstance(node, ast.Global):
                self.set_by_functions |= dict.fromkeys(node.names, unread(one))

    def spoil_by_functions(self) -> None:
        """Spoil the parts whose names functions use: they may have been called, and change them."""
        for name, line in self.in_functions.items():
            _mark(self.names.get(name), line)

    def _spoil(self, one: ast.AST) -> None:
        """Take a statement that is not plain: names that it sets are unread, parts that it names spoilt."""
        line, gone = getattr(one, "lineno", 1), unread(one)
        for node in ast.walk(one):
            if isinstance(node, ast.Name) and node.id in AT_WILL:
                self.names = dict.fromkeys(self.names, gone)
            elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
                _mark(self.names.get(node.target.id), line)
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                _mark(self.names.get(node.id), line)
            elif isinstance(node, ast.Name):
                self.names[node.id] = gone
            elif isinstance(node, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and node.name:
                self.names[node.name] = gone
            elif isinstance(node, ast.MatchMapping) and node.rest:
                self.names[node.rest] = gone
            elif isinstance(node, ast.FunctionDef | ast.ClassDef):
                self._define(node)
            elif isinstance(node, ast.Import | ast.ImportFrom):
                self._import(node)

    # ---------------------------------------------------------------------------------------------- values

    def _value(self, node: ast.expr) -> Any:
        match node:
            case ast.Constant(value=bool()):
                return unread(node)
            case ast.Constant(value=int() | float() as number):
                return _finite(node, number)
            case ast.Constant(value=str() | None as text):
                return text
            case ast.Name(id=name):
                return self._read_name(node, name)
            case ast.Attribute(value=ast.Name(id="math"), attr="pi"):
                return math.pi
            case ast.UnaryOp(op=ast.USub() | ast.UAdd() as op, operand=operand):
                sign = ast.Sub() if isinstance(op, ast.USub) else ast.Add()
                return _arithmetic(node, sign, 0.0, self._value(operand))
            case ast.BinOp(left=left, op=op, right=right):
                return _arithmetic(node, op, self._value(left), self._value(right))
            case ast.List(elts=items) | ast.Tuple(elts=items) if not any(
                isinstance(item, ast.Starred) for item in items
            ):
                return Listing([self._value(item) for item in items])
            case ast.Call():
                return self._call_part(node)
        self._spoil(node)
        return unread(node)

    def _read_name(self, node: ast.expr, name: str) -> Any:
        if name in self.set_by_functions:
            return self.set_by_functions[name]
        if name in self.names:
            return self.names[name]
        return math.pi if name == "pi" and self.of_vismach else unread(node)

    def _callee(self, func: ast.expr) -> str:
        """Return vismach's name of what is called, ``hal.component``, or nothing."""
        if isinstance(func, ast.Name):
            set_otherwise = func.id in self.names or func.id in self.set_by_functions
            return "" if set_otherwise else self.of_vismach.get(func.id, "")
        if isinstance(func, ast.Attribute):
            module = ast.unparse(func.value)
            return func.attr if module in self.modules else f"{module}.{func.attr}"
        return ""

    def _call_part(self, call: ast.Call) -> Any:
        name = self._callee(call.func)
        if name == "hal.component" and call.args and not call.keywords:
            prefix = self._value(call.args[-1])
            return Component(prefix) if isinstance(prefix, str) and len(call.args) < 3 else unread(call)
        if name not in PARTS:
            self._spoil(call)
            return unread(call)
        values = [self._value(one) for one in call.args]
        by_word = {word.arg or "**": self._value(word.value) for word in call.keywords}
        return make_part(call, name, values, by_word)


def _arithmetic(node: ast.AST, op: ast.operator, one: Any, other: Any) -> Any:
    if not isinstance(one, float) or not isinstance(other, float):
        return next((value for value in (one, other) if isinstance(value, Unread)), unread(node))
    match op:
        case ast.Add():
            return _finite(node, one + other)
        case ast.Sub():
            return _finite(node, one - other)
        case ast.Mult():
            return _finite(node, one * other)
        case ast.Div() if other:
            return _finite(node, one / other)
    return unread(node)


def _finite(node: ast.AST, number: float) -> Any:
    try:
        found = float(number) + 0.0
    except OverflowError:
        return unread(node)
    return found if abs(found) < LARGEST else unread(node)


def _is_settings(loop: ast.For) -> bool:
    """Tell whether a loop does no more than take ``name=number`` from the command line."""
    body = [one.value for one in loop.body if isinstance(one, ast.Expr) and isinstance(one.value, ast.Call)]
    called = [ast.unparse(one.func) for one in body]
    return (
        ast.unparse(loop.iter) == "sys.argv[1:]"
        and len(body) == len(loop.body)
        and "exec" in called
        and set(called) <= {"exec", "print"}
        and not loop.orelse
    )


def _mark(value: Any, line: int) -> None:
    """Spoil a part or a list, and all that is in it."""
    left, seen = [value], set[int]()
    while left:
        one = left.pop()
        if id(one) in seen or not isinstance(one, Listing | Part):
            continue
        seen.add(id(one))
        if isinstance(one, Listing) or one.kind != "Capture":
            one.spoilt = one.spoilt or line
        inner = one.items if isinstance(one, Listing) else one.given.values()
        left.extend(inner)
