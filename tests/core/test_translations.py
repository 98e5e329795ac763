# SPDX-License-Identifier: LGPL-2.1-or-later
"""No text that the user reads is missed by the translators; the compiled files hold what the edited ones
say."""

import ast
import re
import struct

import pytest
from sources import parse_source
from translation_script import ROOT, translations

from freecad_fiveaxis.app.option_texts import TEXTS, text_of
from freecad_fiveaxis.core.base.sentences import CONTEXT
from freecad_fiveaxis.core.pipeline.settings import FacesSettings, OutputSettings, option_fields

pytestmark = pytest.mark.texts

LANGUAGES = sorted(translations.FOLDER.glob("FiveAxis_*.ts"))


def german():
    return translations.read_ts((translations.FOLDER / "FiveAxis_de.ts").read_text(encoding="utf-8"))


def messages_of(qm):
    """What a .qm holds, read by its own tables: (context, text) -> translation, each found by its hash."""
    assert qm[:16] == translations.MAGIC
    sections, place = {}, 16
    while place < len(qm):
        tag, size = struct.unpack_from(">BI", qm, place)
        sections[tag], place = qm[place + 5 : place + 5 + size], place + 5 + size
    records, table = sections[translations.MESSAGES], sections[translations.HASHES]
    pairs = [struct.unpack_from(">II", table, row) for row in range(0, len(table), 8)]
    assert pairs == sorted(pairs)
    result = {}
    for found, start in pairs:
        parts, place = {}, start
        while records[place] != translations.END:
            tag, size = struct.unpack_from(">BI", records, place)
            parts[tag], place = records[place + 5 : place + 5 + size], place + 5 + size
        source = parts[translations.SOURCE]
        assert found == translations.elf_hash(source)
        result[parts[translations.CONTEXT].decode(), source.decode()] = parts[
            translations.TRANSLATION
        ].decode("utf-16-be")
    return result


def test_german_is_there():
    assert "FiveAxis_de.ts" in [path.name for path in LANGUAGES]


@pytest.mark.parametrize("path", LANGUAGES, ids=lambda path: path.stem)
def test_no_text_is_missed_and_no_file_is_out_of_date(path):
    ts, qm, missing = translations.update(path)
    assert not missing, "without translation (run scripts/translations, then translate): " + "; ".join(
        map(str, missing)
    )
    assert path.read_text(encoding="utf-8") == ts, "out of date: run scripts/translations"
    assert path.with_suffix(".qm").read_bytes() == qm, "out of date: run scripts/translations"


def test_the_texts_are_those_of_every_floor():
    contexts = {context for context, _ in translations.texts()}
    commands = {
        f"FiveAxis_{name}" for name in ("Tessellate", "Toolpath", "PostProcess", "Annotate", "Audit", "Play")
    }
    assert {"FiveAxis", "App::Property", "Workbench", "FiveAxisPreferences"} | commands <= contexts


NOT_SHOWN = (FacesSettings, OutputSettings)
"""Of files; in the window faces are selected, and solids are in mm."""


@pytest.mark.parametrize("task", ["mill", "audit"])
def test_every_setting_that_is_shown_has_its_help_and_its_name_translated(task):
    known, seen, named = (
        german(),
        0,
        translations.literal_of(translations.PROPERTIES.read_text(encoding="utf-8"), "_NAMED"),
    )
    for cls, leaf in option_fields(task):
        if cls not in NOT_SHOWN and leaf.metadata["kind"] not in ("path", "paths"):
            name = named.get(leaf.name) or "".join(part.capitalize() for part in leaf.name.split("_"))
            shown = (
                [name]
                if leaf.name != "cutter"
                else [f"Cutter{one}" for one in ("Kind", "Diameter", "Corner", "Taper", "Length")]
            )
            for text in [text_of(leaf), *map(translations.shown_name, shown)]:
                assert known.get(("App::Property", text)), text
                seen += 1
    assert seen > 10


INNER = re.compile(
    r"--[a-z]|`|\[|KIND:|DIAMETERx|\bdeform\b|\bcur(e|es|ed|ing)\b|\bled\b|\blead the\b|\brotary words\b|metadata",
    re.I,
)
"""Words of the command line and of the core's own, which no machinist knows."""


def test_no_text_of_the_window_speaks_the_language_of_the_command_line_or_of_the_core():
    inner = sorted(
        text for context, text in translations.texts() if context != CONTEXT and INNER.search(text)
    )
    assert not inner, inner
    assert (
        INNER.search("the tolerance of --blend")
        and INNER.search("pass it (deform)")
        and INNER.search("`minimax`")
    )


COMMANDS = re.compile(
    r"--[a-z]|`|KIND:|DIAMETERx|\bdeform\b|\bcur(e|es|ed|ing)\b|\b(be|is|are|was|were) led\b|\blead the\b|minimax|facet_mean|"
    r"\b[Ll]inearize\b|\bgouge (lift|tilt|leave-out|report)\b|\b(setup|recover) finds\b|\bmax-tilt\b|\brtcp\b"
)
"""Words that a sentence of the core says by Option, Choice or Task, so that a window names its own fields and
commands."""


def test_no_sentence_of_the_core_speaks_the_language_of_the_command_line():
    message = {
        text: re.sub(r"\{\w*\}", "", text) for context, text in translations.texts() if context == CONTEXT
    }
    inner = sorted(text for text, words in message.items() if COMMANDS.search(words))
    assert not inner, inner


@pytest.mark.parametrize(
    "text",
    ["lift it (gouge lift, leave-out)", "divide (linearize on)", "use it with `mill`", "setup finds one", "give --spindle S",
     "leaves minimax no choice", "with cure {name}", "{count} passes are led past the pole"],
)  # fmt: skip
def test_a_word_of_the_command_line_would_be_noticed(text):
    assert COMMANDS.search(re.sub(r"\{\w*\}", "", text))


def named_in(tree):
    """What the sentences of a source name: ("Option" | "Choice" | "Task", name), and the choices as
    ("choice", name)."""
    for call in (
        node for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    ):
        if call.func.id in ("Option", "Choice", "Task") and isinstance(call.args[0], ast.Constant):
            yield call.func.id, call.args[0].value
            chosen = call.args[1].elts if len(call.args) > 1 and isinstance(call.args[1], ast.Tuple) else []
            yield from (("choice", one.value) for one in chosen if isinstance(one, ast.Constant))


def test_all_that_a_sentence_names_has_a_name_in_the_window():
    labels = {
        node.name: node
        for node in ast.parse(LABELS.read_text("utf-8")).body
        if isinstance(node, ast.FunctionDef)
    }
    known = {
        kind: {
            key.value
            for name in names
            for node in ast.walk(labels[name])
            if isinstance(node, ast.Dict)
            for key in node.keys
        }
        for kind, names in NAMING.items()
    }
    core = ROOT / "freecad_fiveaxis" / "core"
    named = {one for path in core.rglob("*.py") for one in named_in(parse_source(path))}
    assert {("Task", "setup"), ("Option", "spindle"), ("choice", "lift"), ("Choice", "linearize")} <= named
    assert not sorted((kind, name) for kind, name in named if name not in known[kind])


LABELS = ROOT / "freecad_fiveaxis" / "app" / "labels.py"
OF_OPTIONS = ("_of_passes", "_of_programs", "_of_machines_and_places")
NAMING = {"Option": OF_OPTIONS, "Choice": OF_OPTIONS, "Task": ("_tasks",), "choice": ("_choices",)}
"""The functions of app/labels.py whose tables name options, choices and tasks."""


def test_every_option_of_a_panel_is_explained_for_the_window():
    named = {leaf.name: leaf for _, leaf in option_fields()}
    assert set(TEXTS) <= set(named), "an option that is gone"
    tasks = ("mill", "audit", "setup")
    shown = {leaf.name for task in tasks for cls, leaf in option_fields(task) if cls is not FacesSettings}
    files = {name for name, leaf in named.items() if leaf.metadata["kind"] in ("path", "paths")}
    assert shown - files <= set(TEXTS)
    assert all(text[0].isupper() and not text.endswith(".") for text in TEXTS.values())


def test_a_forgotten_text_would_be_noticed(tmp_path):
    """The same check fails on a copy of the German file that lacks one translation, and on one that lacks a
    text."""
    messages = german()
    text = next(iter(sorted(messages)))
    path = tmp_path / "FiveAxis_de.ts"
    for spoilt in ({**messages, text: ""}, {key: value for key, value in messages.items() if key != text}):
        path.write_text(translations.write_ts("de", spoilt), encoding="utf-8")
        _, qm, missing = translations.update(path)
        assert text in missing
        assert text not in messages_of(qm)


SHOWING = {
    "setText", "setToolTip", "setStatusTip", "setWindowTitle", "setTitle", "setPlaceholderText", "setLabelText", "setSuffix",
    "setPrefix", "setPlainText", "setHtml", "addItem", "addAction", "addTab", "addRow", "addMenu", "showMessage", "QLabel",
    "QPushButton", "QToolButton", "QCheckBox", "QRadioButton", "QGroupBox", "QAction", "QDockWidget", "QProgressDialog",
    "warn", "ask", "status", "waiting", "transaction", "SelectionError", "SettingsError", "FileError", "QTreeWidgetItem",
}  # fmt: skip
"""Calls that put a text before the user."""


def has_words(text):
    """Whether anything is left for translators when markup is taken away."""
    return bool(re.search(r"[A-Za-z]{2}", re.sub(r"<[^<>]*>|&\w+;", "", text)))


def bare_texts(tree):
    """Words that a call of SHOWING gets without ``translate``, and helps of settings that are shown as they
    stand."""
    translated = {
        id(one)
        for call in ast.walk(tree)
        if isinstance(call, ast.Call) and ast.unparse(call.func).endswith("translate")
        for one in ast.walk(call)
    }
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.Subscript)
            and ast.unparse(node).endswith("metadata['text']")
            and id(node) not in translated
        ):
            yield node.lineno, ast.unparse(node)
        if isinstance(node, ast.Call) and ast.unparse(node.func).rsplit(".", 1)[-1] in SHOWING:
            for given in node.args:
                parts = given.values if isinstance(given, ast.JoinedStr) else [given]
                for one in parts:
                    if isinstance(one, ast.Constant) and has_words(str(one.value)):
                        yield one.lineno, one.value


def test_the_window_shows_no_text_that_nobody_can_translate():
    bare = []
    for path in sorted((ROOT / "freecad_fiveaxis" / "gui").rglob("*.py")):
        for line, text in bare_texts(parse_source(path)):
            bare.append(f"{path.relative_to(ROOT)}:{line}: {text}")
    assert not bare, "shown without translate():\n" + "\n".join(bare)


@pytest.mark.parametrize(
    "source",
    [
        'box.setText("Proven below")',
        'QtWidgets.QLabel(f"Line {3}")',
        "Field(leaf.name, leaf.metadata['text'])",
    ],
)
def test_a_bare_text_would_be_noticed(source):
    assert list(bare_texts(ast.parse(source)))


@pytest.mark.parametrize(
    "source",
    ['box.setText(translate("FiveAxis", "Proven below"))', 'box.setText("…")', 'row.setText(f"<b>{value}</b>")',
     "translate('App::Property', leaf.metadata['text'])", 'box.setObjectName("line")'],
)  # fmt: skip
def test_what_is_translated_or_no_word_is_not_bare(source):
    assert not list(bare_texts(ast.parse(source)))


def test_new_calls_are_found():
    source = """
label = translate("FiveAxis", "one " "text")
tip = QT_TRANSLATE_NOOP("App::Property", 'another')
other = FreeCAD.Qt.translate("Workbench", "third")
"word".translate(table)
hint = translate("App::Property", leaf.metadata["text"])
"""
    found = [("FiveAxis", "one text"), ("App::Property", "another"), ("Workbench", "third")]
    assert list(translations.texts_of_source(source)) == found


@pytest.mark.parametrize("text", ['f"{count} blocks"', "name", '"a" + name', '"{}".format(3)'])
def test_a_text_put_together_at_run_time_is_refused(text):
    with pytest.raises(translations.NotLiteral, match=r"tool\.py:1"):
        list(translations.texts_of_source(f'translate("FiveAxis", {text})', "tool.py"))


def test_templates_of_sentences_are_found():
    source = """
finding = Finding(WARNING, "code", say("one {count}", count=3))
text = plural(n, "{count} row", "{count} rows") + say("by " "{depth}", depth=Length(3.0))
TABLE = {1: Template("a table's {name}")}
later = TABLE[1].say(name="C")
"""
    found = {"one {count}", "{count} row", "{count} rows", "by {depth}", "a table's {name}"}
    assert set(translations.texts_of_sentences(source)) == {(translations.CORE, text) for text in found}


def test_the_context_of_sentences_is_that_of_the_core():
    assert translations.CORE == CONTEXT


@pytest.mark.parametrize("call", ['say(f"{count} blocks")', "say(text)", 'plural(n, "{count} row", many)'])
def test_a_sentence_put_together_at_run_time_is_refused(call):
    with pytest.raises(translations.NotLiteral, match=r"tool\.py:1"):
        list(translations.texts_of_sentences(call, "tool.py"))


def test_names_and_groups_of_properties_are_found():
    source = """
VERSION = Property("SchemaVersion", "App::PropertyInteger", "Base", text, 1)
obj.addProperty("App::PropertyLink", "NCFile", "Result", text)
ROWS = (("App::PropertyBool", "ShowAxes", True, text),)
"""
    found = ["Schema Version", "Base", "NCFile", "Result", "Show Axes"]
    assert [text for _, text in translations.texts_of_properties(source)] == found


def test_forms_give_their_strings_under_their_class():
    form = """<ui version="4.0"><class>Page</class><widget class="QWidget" name="Page">
      <property name="text"><string>Feed &amp; speed</string></property>
      <property name="unit"><string notr="true">mm</string></property></widget></ui>"""
    assert list(translations.texts_of_form(form)) == [("Page", "Feed & speed")]


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("WorkZero", "Work Zero"),
        ("NCFile", "NCFile"),
        ("MaxBound", "Max Bound"),
        ("NC file", "NC file"),
        ("Tool", "Tool"),
    ],
)
def test_property_names_are_looked_up_as_the_editor_shows_them(name, shown):
    assert translations.shown_name(name) == shown


def test_ts_and_qm_hold_any_text():
    messages = {
        ("A", "same"): "eins", ("B", "same"): "zwei", ("A", 'a < b & "c"'): "Maß „ß“ > 1 µm",
        ("A", "two\nlines"): "zwei\nZeilen", ("A", "clef"): "𝄞", ("A", "not yet"): "",
    }  # fmt: skip
    assert translations.read_ts(translations.write_ts("de", messages)) == messages
    assert messages_of(translations.write_qm("de", messages)) == {
        text: reported for text, reported in messages.items() if reported
    }


def test_unfinished_and_vanished_messages_do_not_count():
    ts = """<TS><context><name>A</name>
      <message><source>one</source><translation type="unfinished">vielleicht</translation></message>
      <message><source>two</source><translation>zwei</translation></message></context></TS>"""
    assert translations.read_ts(ts) == {("A", "one"): "", ("A", "two"): "zwei"}


@pytest.mark.parametrize("path", LANGUAGES, ids=lambda path: path.stem)
def test_translations_keep_the_places_for_values(path):
    """``{}``, ``{name}``, ``%1`` and a file filter's ``*.ngc`` must come back as they went out."""
    places = re.compile(r"\{[^{}]*\}|%\w|\*\.\w+")
    for (context, text), reported in translations.read_ts(path.read_text(encoding="utf-8")).items():
        assert sorted(places.findall(reported)) == sorted(places.findall(text)), (context, text, reported)
