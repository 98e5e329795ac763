# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tree of a URDF file as a machine: which joints move the table, and which move the tool.

place    4x4, from a link's frame into that of the root, every joint at zero; lengths in m.
group    the links that move together: a joint that moves, or the root, and all that is fixed to it.
tool     the link whose name has one of the words TOOLS, table: one of TABLES; the first of
         the words that any link has counts.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say

from .urdf_file import Joint, Robot, wrong

TOOLS = ("gauge", "tool0", "tool", "tcp", "spindle", "flange", "nose")
TABLES = ("table", "platter", "workpiece", "work", "pallet", "chuck", "faceplate")


@dataclass(frozen=True, eq=False)
class Tree:
    """``place`` of each link; ``chain`` of each link: the joints that move it, from the root on."""

    root: str
    place: dict[str, Floats]
    chain: dict[str, tuple[Joint, ...]]
    parents: dict[str, str]

    def group(self, link: str) -> str:
        """Return the joint that carries a link last; empty for what stands with the root."""
        joints = self.chain[link]
        return joints[-1].name if joints else ""

    def is_under(self, link: str, other: str) -> bool:
        """Whether a link is another one or hangs from it."""
        while link != other and link in self.parents:
            link = self.parents[link]
        return link == other


def grow(robot: Robot, path: Path) -> Tree:
    """Put every link in its place. Raises MachineError for links that make no tree."""
    joints = {joint.child: joint for joint in robot.joints}
    for joint in robot.joints:
        for link in (joint.parent, joint.child):
            if link not in robot.links:
                raise wrong(
                    path,
                    say(
                        "joint {joint} names the link {link}, which is not there; add it",
                        joint=joint.name,
                        link=link,
                    ),
                )
        if joints[joint.child] is not joint:
            raise wrong(path, say("two joints carry the link {link}; leave one of them", link=joint.child))
    roots = [link for link in robot.links if link not in joints]
    if len(roots) != 1:
        listed = ", ".join(roots) or say("none")
        raise wrong(
            path,
            say(
                "one link must carry all others and hang from none; of it hang from none: {roots}",
                roots=listed,
            ),
        )
    tree = Tree(
        roots[0],
        {roots[0]: np.eye(4)},
        {roots[0]: ()},
        {child: joint.parent for child, joint in joints.items()},
    )
    _hang(tree, robot.joints)
    if lost := [link for link in robot.links if link not in tree.place]:
        raise wrong(
            path, say("{links} carry one another in a circle; hang one from the root", links=", ".join(lost))
        )
    return tree


def _hang(tree: Tree, joints: Sequence[Joint]) -> None:
    children: dict[str, list[Joint]] = {}
    for joint in joints:
        children.setdefault(joint.parent, []).append(joint)
    waiting = [tree.root]
    while waiting:
        link = waiting.pop()
        for joint in children.get(link, ()):
            tree.place[joint.child] = tree.place[link] @ joint.place
            tree.chain[joint.child] = (*tree.chain[link], *((joint,) if joint.moves else ()))
            waiting.append(joint.child)


def find_ends(tree: Tree, path: Path) -> tuple[str, str]:
    """Name the link of the table and that of the tool. Raises MachineError where names do not say which these
    are."""
    table, tool = (_find_named_link(tree, words, path) for words in (TABLES, TOOLS))
    if tree.group(table) == tree.group(tool):
        raise wrong(
            path,
            say(
                "no joint moves {table} and {tool} against each other; they make no machine",
                table=table,
                tool=tool,
            ),
        )
    return table, tool


def _find_named_link(tree: Tree, words: Sequence[str], path: Path) -> str:
    for word in words:
        found = [link for link in tree.place if word in re.split(r"[^a-z0-9]+", link.lower())]
        found = found or [link for link in tree.place if word in link.lower()]
        ends = [link for link in found if not any(one != link and tree.is_under(one, link) for one in found)]
        if len(ends) > 1:
            raise wrong(
                path,
                say(
                    "{links} are all called {word}; give only one of them that name",
                    links=", ".join(ends),
                    word=word,
                ),
            )
        if ends:
            return ends[0]
    raise wrong(path, say("no link is called {words}; name the one that is it", words=", ".join(words)))


def sides(tree: Tree, table: str, tool: str, path: Path) -> tuple[tuple[Joint, ...], tuple[Joint, ...]]:
    """Return the joints of the table from the work to the base, and those of the head from the base to the
    tool. Raises MachineError for a joint that is in neither, or in both."""
    under, over = tree.chain[table], tree.chain[tool]
    if both := [joint.name for joint in under if joint in over]:
        raise wrong(path, say("joint {joint} moves table and tool alike; make it fixed", joint=both[0]))
    moving = {joint.name for chain in tree.chain.values() for joint in chain}
    if spare := sorted(moving - {joint.name for joint in (*under, *over)}):
        raise wrong(
            path,
            say("{joints} move neither the table nor the tool; make them fixed", joints=", ".join(spare)),
        )
    return under[::-1], over
