# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cross references in docstrings, and whether what they name is there; read from the source, nothing is
imported.

:role:`target`   the roles of ROLES. ``name`` is looked for in the class, the module and beside the module;
                 ``.name`` also anywhere in the package, as the end of an address, as Sphinx does; ``~`` only
                 shortens what is shown.
``a.b``          where ``a`` is a class or module in sight, and no parameter: its ``b``.
"""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path

from sources import parse_source

ROLES = "mod|class|func|meth|data|attr|exc|obj"
ROLE = re.compile(rf":(?:{ROLES}):(?!:)(?:`~?([^`]*)`)?")
DOTTED = re.compile(r"``([A-Za-z_]\w*(?:\.[A-Za-z_]\w*)+)(?:\(\))?``")
FILES = frozenset(["bin", "bms", "c", "comp", "csv", "fcstd", "html", "json", "nc", "py", "step", "stl"])
"""What ends the name of a file, not of a part of the package."""
FREECAD = frozenset(["FreeCAD", "FreeCADGui", "Mesh", "MeshPart", "Part", "Path"])
FUNCTIONS = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass
class Scope:
    """A module or a class. ``names``: what stands in it: a Scope, the address of what is imported (str), None
    for a value."""

    address: str
    names: "dict[str, Scope | str | None]" = field(default_factory=dict)
    bases: list[str] = field(default_factory=list)


Thing = Scope | str | None


@dataclass(frozen=True)
class Docstring:
    """A docstring, or the text below a constant or field. ``around``: the scopes that it stands in, the
    module first."""

    text: str
    where: str
    around: tuple[Scope, ...]
    parameters: frozenset[str]


class Package:
    """A package's scopes by module, and its docstrings."""

    def __init__(self, folder: Path) -> None:
        self.name, self.modules, self.docstrings = folder.name, dict[str, Scope](), list[Docstring]()
        for path in sorted(folder.rglob("*.py")):
            parts = path.relative_to(folder.parent).with_suffix("").parts
            address = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            home = address if parts[-1] == "__init__" else address.rpartition(".")[0]
            tree = parse_source(path)
            self.modules[address] = _scope(address, tree, home)
            self._collect(tree, (self.modules[address],), str(path.relative_to(folder.parent)), frozenset())

    def _collect(
        self, node: ast.AST, around: tuple[Scope, ...], path: str, parameters: frozenset[str]
    ) -> None:
        """Keep every docstring in a module, class or function."""
        parameters |= _parameters(node)
        before: ast.AST | None = None
        for inner in getattr(node, "body", []):
            text = (
                inner.value.value
                if isinstance(inner, ast.Expr) and isinstance(inner.value, ast.Constant)
                else None
            )
            if isinstance(text, str) and (before is None or isinstance(before, ast.Assign | ast.AnnAssign)):
                self.docstrings.append(Docstring(text, f"{path}:{inner.lineno}", around, parameters))
            if isinstance(inner, ast.ClassDef):
                scope = around[-1].names.get(inner.name)
                self._collect(
                    inner, (*around, scope) if isinstance(scope, Scope) else around, path, parameters
                )
            elif isinstance(inner, FUNCTIONS):
                self._collect(inner, around, path, parameters)
            before = inner

    def dead(self) -> Iterator[str]:
        """What is named and not there: file, line and reference."""
        for docstring in self.docstrings:
            for found in ROLE.finditer(docstring.text):
                if not found[1] or not self.has(docstring, found[1]):
                    yield f"{docstring.where}: {found[0]}"
            for found in DOTTED.finditer(docstring.text):
                if self.is_meant(docstring, found[1]) and not self.has(docstring, found[1]):
                    yield f"{docstring.where}: {found[0]}"

    def missing(self, source: str) -> Iterator[str]:
        """What a file outside takes from the package and that is not there, with its line: the names that it
        imports, and what it asks of modules that it imports."""
        tree = ast.parse(source)
        imported = dict(_imports(tree))
        taken = [(line, address) for _, (line, address) in _imports(tree)]
        hidden = _stored(tree) | {found.arg for found in ast.walk(tree) if isinstance(found, ast.arg)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                _, address = imported.get(node.value.id, (0, ""))
                if address in self.modules and node.value.id not in hidden and node.attr[:2] != "__":
                    taken.append((node.lineno, f"{address}.{node.attr}"))
        for line, address in taken:
            if address.partition(".")[0] == self.name and not self._leads_on(address, []):
                yield f"{line}: {address}"

    def is_meant(self, docstring: Docstring, dotted: str) -> bool:
        """Whether what stands before the first dot is a class or module of the package, and the whole no
        file."""
        first, *_, last = dotted.split(".")
        if first in docstring.parameters or last.lower() in FILES:
            return False
        return any(
            isinstance(self._walk(thing, []), Scope)
            for thing in self._in_sight(docstring, first) or self._anywhere(first)
        )

    def has(self, docstring: Docstring, target: str) -> bool:
        """Whether a target is there, seen from a docstring."""
        first, *rest = target.lstrip(".").split(".")
        things = self._in_sight(docstring, first) + (
            self._anywhere(first) if rest or target[0] == "." else []
        )
        if first == self.name:
            things.append(self.modules[first])
        elif rest and not things:
            return bool(find_spec(first)) or first in FREECAD
        return any(self._leads_on(thing, rest) for thing in things)

    def _in_sight(self, docstring: Docstring, name: str) -> list[Thing]:
        """What a name may mean in a docstring's class and module, and in the package beside them."""
        module = docstring.around[0].address
        scopes = (*reversed(docstring.around), self.modules[module.rpartition(".")[0] or module])
        return [
            scope.names[name] if name in scope.names else self.modules[f"{scope.address}.{name}"]
            for scope in scopes
            if name in scope.names or f"{scope.address}.{name}" in self.modules
        ]

    def _anywhere(self, name: str) -> list[Thing]:
        """What a name means in any module; modules of that name."""
        modules = [module for address, module in self.modules.items() if address.endswith(f".{name}")]
        return modules + [module.names[name] for module in self.modules.values() if name in module.names]

    def _leads_on(self, thing: Thing, parts: list[str]) -> bool:
        try:
            self._walk(thing, parts)
        except LookupError:
            return False
        return True

    def _walk(self, thing: Thing, parts: list[str]) -> Scope | None:
        """What stands at the end of a way from a thing; None for a value, and for what is not of the package.
        Raises LookupError."""
        if isinstance(thing, str):
            thing = self._at(thing) if thing.partition(".")[0] == self.name else None
        return self._walk(self._member(thing, parts[0]), parts[1:]) if parts and thing else thing

    def _at(self, address: str) -> Scope | None:
        module, rest = address, list[str]()
        while module not in self.modules:
            module, _, last = module.rpartition(".")
            rest.insert(0, last)
        return self._walk(self.modules[module], rest)

    def _member(self, scope: Scope, name: str) -> Thing:
        """A name of a class or module, or of the classes that it is made from."""
        if name in scope.names:
            return scope.names[name]
        if f"{scope.address}.{name}" in self.modules:
            return self.modules[f"{scope.address}.{name}"]
        for base in scope.bases:
            found = self._at(f"{scope.address.rpartition('.')[0]}.{base}")
            if found and self._leads_on(found, [name]):
                return self._member(found, name)
        raise LookupError(f"{scope.address}.{name}")


def _imports(tree: ast.AST) -> Iterator[tuple[str, tuple[int, str]]]:
    """What is imported anywhere in a file: its name there, the line and the address."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and not node.level:
            for one in node.names:
                yield one.asname or one.name, (node.lineno, f"{node.module}.{one.name}")
        elif isinstance(node, ast.Import):
            for one in node.names:
                yield one.asname or one.name, (node.lineno, one.name)


def _scope(address: str, node: ast.Module | ast.ClassDef, home: str) -> Scope:
    """What is defined, imported or assigned in a module or class. ``home``: the package that relative imports
    begin at."""
    scope = Scope(address, bases=[ast.unparse(base).partition("[")[0] for base in getattr(node, "bases", [])])
    for inner in _statements(node):
        if isinstance(inner, ast.ClassDef):
            scope.names[inner.name] = _scope(f"{address}.{inner.name}", inner, home)
        elif isinstance(inner, FUNCTIONS):
            scope.names[inner.name] = None
            if isinstance(node, ast.ClassDef):  # what it keeps: self.name = ...
                scope.names.update(dict.fromkeys(_kept(inner) - scope.names.keys()))
        elif isinstance(inner, ast.ImportFrom):
            above = home.split(".")[: home.count(".") + 2 - inner.level] if inner.level else []
            whence = ".".join([*above, *filter(None, [inner.module])])
            scope.names.update({name.asname or name.name: f"{whence}.{name.name}" for name in inner.names})
        elif isinstance(inner, ast.Import):
            scope.names.update(
                {name.asname or name.name.partition(".")[0]: name.name for name in inner.names}
            )
        else:
            scope.names.update(dict.fromkeys(_stored(inner) - scope.names.keys()))
    return scope


def _statements(node: ast.AST) -> Iterator[ast.stmt]:
    """The statements of a module or class, those under its `if`, `try` and `with` too."""
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, ast.stmt):
            yield inner
        if isinstance(inner, ast.If | ast.Try | ast.With | ast.ExceptHandler):
            yield from _statements(inner)


def _parameters(node: ast.AST) -> frozenset[str]:
    """The names of a function's parameters and variables, or of a class's fields."""
    if isinstance(node, FUNCTIONS):
        return frozenset(found.arg for found in ast.walk(node.args) if isinstance(found, ast.arg)) | _stored(
            node
        )
    fields = node.body if isinstance(node, ast.ClassDef) else []
    return frozenset().union(*(_stored(inner) for inner in fields if isinstance(inner, ast.AnnAssign)))


def _stored(node: ast.AST) -> frozenset[str]:
    """The names that are assigned anywhere in a statement."""
    return frozenset(
        found.id
        for found in ast.walk(node)
        if isinstance(found, ast.Name) and isinstance(found.ctx, ast.Store)
    )


def _kept(node: ast.AST) -> frozenset[str]:
    """The attributes that are assigned anywhere in a function."""
    return frozenset(
        found.attr
        for found in ast.walk(node)
        if isinstance(found, ast.Attribute) and isinstance(found.ctx, ast.Store)
    )
