# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hands and eyes for tests inside FreeCAD's window: they press what a user presses and look at the screen he
sees.

press: a click on a command's button in a tool bar. row: a line of the model tree. modal: whoever answers the
next message box. A click is refused where the widget is hidden, covered or disabled, as it would be for a
hand. Screen coordinates are pixels from the top left; pictures go to ``$FIVEAXIS_OUT/NAME.png``.
"""

import ctypes
import os
import sys
import time

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps them here
    QtWidgets = QtGui

WORKBENCH = "FiveAxisWorkbench"
LEFT, NONE = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
PANELS = ("FiveAxisPanel", "FiveAxisPlay")
SMALL, WHOLE = (0, 0, 1280, 800), (0, 0, 1920, 1080)  # left, top, width and height of the window, pixels
REFRESH = 700  # ms until FreeCAD's timer has renewed which commands are enabled
QUICKLY = 85  # of 0 to 100: Qt's "quality" of a PNG is how little it is packed; nothing is lost at any
SETTLED = 15000  # ms until a layout has settled, also on a machine that is busy with other FreeCADs
TAKEN = 2000  # ms until what was clicked shows that; then it is clicked once more, where that does no harm
READY = 20000  # ms until a command, a panel or a button of it is there to be pressed
# ms between two pictures of the window: Mesa puts all of it together on the processor, whatever little
# changed. Who looks at the screen has it painted before (_shoot)
FRAME = 500


def _pump(ms=100):
    """Let the window work for so many milliseconds; between its events the processor is others'."""
    end = QtCore.QTimer()
    end.setSingleShot(True)
    end.start(ms)
    while end.isActive():
        QtWidgets.QApplication.processEvents(
            QtCore.QEventLoop.AllEvents | QtCore.QEventLoop.WaitForMoreEvents
        )


def _patience():
    """How many times as long the window may take: as many as there are processes to each half of a core."""
    return max(1.0, 2.0 * os.getloadavg()[0] / (os.cpu_count() or 1)) if hasattr(os, "getloadavg") else 1.0


def _until(condition, ms, what):
    """Let the window work until the condition gives something, and return it; TimeoutError (naming `what`)
    after so many ms, or as much longer as other work keeps the processors busy."""
    begin = time.monotonic()
    while True:
        found = condition()
        if found:
            return found
        if time.monotonic() - begin >= ms / 1000 * _patience():
            raise TimeoutError(f"{what}: not within {ms} ms")
        _pump(30)


def _within(ms, condition):
    """Whether the condition holds within so many ms, while the window works."""
    try:
        return _until(condition, ms, "")
    except TimeoutError:
        return False


def _out():
    folder = (
        os.environ.get("FIVEAXIS_OUT") or os.environ.get("OUT") or os.path.join(os.getcwd(), "out", "freecad")
    )
    os.makedirs(folder, exist_ok=True)
    return folder


def _shoot(name):
    """The screen as far as windows reach on it, from its top left on, as a PNG, packed quickly; its path.
    (The X server's picture: a widget's grab() would leave the 3D view blank.)"""
    _pump(300)
    for one in _frames:
        one.show()
    path = os.path.join(_out(), f"{name}.png")
    screen, end = QtGui.QGuiApplication.primaryScreen(), QtCore.QRect(*SMALL)
    for widget in QtWidgets.QApplication.topLevelWidgets():
        if widget.isVisible():
            end = end.united(widget.frameGeometry())
    assert screen.grabWindow(0, 0, 0, end.right() + 1, end.bottom() + 1).save(path, "PNG", QUICKLY), path
    return path


def _mouse(widget, kind, point, button, buttons, ms=5):
    place = QtCore.QPointF(point)
    window = QtCore.QPointF(widget.mapTo(widget.window(), point))
    event = QtGui.QMouseEvent(
        kind, place, window, QtCore.QPointF(widget.mapToGlobal(point)), button, buttons, QtCore.Qt.NoModifier
    )
    QtWidgets.QApplication.postEvent(widget, event)
    if ms:
        _pump(ms)


def _scroll_to(widget):
    parent = widget.parentWidget()
    while parent is not None:
        if isinstance(parent, QtWidgets.QScrollArea):
            parent.ensureWidgetVisible(widget)
            _pump(50)
        parent = parent.parentWidget()


def _hit(widget, point):
    """The widget under the mouse, scrolled into sight, and where in it (without a point: in the middle of the
    given one). Fails unless a hand could click it within SETTLED ms: what was just unfolded is laid out
    first."""
    name = f"{type(widget).__name__} {widget.objectName()!r}"
    end = time.monotonic() + SETTLED / 1000
    while True:
        _scroll_to(widget)
        place = point or widget.rect().center()
        hit = QtWidgets.QApplication.widgetAt(widget.mapToGlobal(place))
        if not widget.isVisible():
            refused = "is not visible"
        elif not widget.isEnabled():
            refused = "is disabled"
        elif hit is widget:
            return hit, place
        elif hit is not None and widget.isAncestorOf(hit):
            return hit, hit.mapFrom(widget, place)
        else:
            refused = f"is covered by {hit}"
        assert time.monotonic() < end, f"{name} {refused}"
        _pump(50)


def _click(widget, point=None, double=False):
    """Press and release the left button on the widget (its middle, or a QPoint in it), by mouse events."""
    target, point = _hit(widget, point)
    kinds = QtCore.QEvent
    if target.focusPolicy() in (QtCore.Qt.ClickFocus, QtCore.Qt.StrongFocus, QtCore.Qt.WheelFocus):
        target.setFocus(QtCore.Qt.MouseFocusReason)  # Qt does that for events of the server only
    _mouse(
        target, kinds.MouseMove, point, NONE, NONE, ms=0
    )  # handled with the press: painted once, not twice
    _mouse(target, kinds.MouseButtonPress, point, LEFT, LEFT)
    _mouse(target, kinds.MouseButtonRelease, point, LEFT, NONE)
    if double:
        _mouse(target, kinds.MouseButtonDblClick, point, LEFT, LEFT)
        _mouse(target, kinds.MouseButtonRelease, point, LEFT, NONE)
    _pump(60)


def _key(widget, key, text="", ms=10):
    """Press and release a key. Both are posted first: the press may take the widget away."""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.postEvent(widget, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, text))
    if ms:
        _pump(ms)


class _XKeyEvent(ctypes.Structure):
    _fields_ = [
        ("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), *((name, ctypes.c_ulong) for name in ("window", "root", "subwindow", "time")),
        *((name, ctypes.c_int) for name in ("x", "y", "x_root", "y_root")), ("state", ctypes.c_uint),
        ("keycode", ctypes.c_uint), ("same_screen", ctypes.c_int), ("padding", ctypes.c_long * 12),
    ]  # fmt: skip


def _real_key(widget, name):
    """Send a key to the widget's window by the X server, so that Qt looks for shortcuts too; posted events
    never reach those."""
    x = ctypes.CDLL("libX11.so.6")
    x.XOpenDisplay.restype = ctypes.c_void_p
    x.XStringToKeysym.restype = x.XDefaultRootWindow.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x.XOpenDisplay(None))
    code = x.XKeysymToKeycode(display, ctypes.c_ulong(x.XStringToKeysym(name.encode())))
    window, root = int(widget.window().winId()), x.XDefaultRootWindow(display)
    for kind in (2, 3):  # press, release
        event = _XKeyEvent(kind, 0, 1, display.value, window, root, 0, 0, 1, 1, 1, 1, 0, code, 1)
        x.XSendEvent(display, ctypes.c_ulong(window), 1, ctypes.c_long(1 << (kind - 2)), ctypes.byref(event))
    x.XCloseDisplay(display)


def _type(widget, text):
    """Click into a field, replace what stands there by the text, key by key, and leave it with Enter's
    effect."""
    _click(widget)
    line = widget if isinstance(widget, QtWidgets.QLineEdit) else widget.findChild(QtWidgets.QLineEdit)
    line.setFocus()
    _within(
        TAKEN, line.hasFocus
    )  # a window gets the keys late where a list or a dialog over it has just closed
    line.selectAll()
    for letter in text:  # one after the other, and the window painted once: that costs more than all letters
        _key(line, 0, letter, ms=0)
    _pump(10)
    _key(line, QtCore.Qt.Key_Tab)


def _choose(combo, text):
    """Open a combo box by the mouse, go to the item so named by the arrow keys, and take it."""
    _within(SETTLED, lambda: combo.findText(text) >= 0)
    at = combo.findText(text)
    assert at >= 0, f"no {text!r} among {[combo.itemText(i) for i in range(combo.count())]}"
    for _ in range(5):  # on a busy machine the list closes now and then as soon as it has opened
        if not combo.view().isVisible():
            _click(combo)
        if not _within(TAKEN, combo.view().isVisible):
            continue
        step = at - combo.view().currentIndex().row()
        for _ in range(abs(step)):
            _key(combo.view(), QtCore.Qt.Key_Down if step > 0 else QtCore.Qt.Key_Up)
        _key(combo.view(), QtCore.Qt.Key_Return)
        if _within(TAKEN, lambda: combo.currentIndex() == at):
            return
    raise AssertionError(f"{text!r} cannot be chosen in {combo.objectName()!r}")


def _main():
    return FreeCADGui.getMainWindow()


def _tool_button(command):
    """The button of a command in a tool bar that is shown, or None. Undo and Redo have menus at their
    buttons, which FreeCAD leaves without a name: those are known by their text."""
    text = FreeCADGui.Command.get(command).getInfo()["menuText"]
    bars = [bar for bar in _main().findChildren(QtWidgets.QToolBar) if bar.isVisible()]
    actions = [(bar, action) for bar in bars for action in bar.actions()]
    found = [pair for pair in actions if pair[1].objectName() == command]
    found = found or [pair for pair in actions if not pair[1].objectName() and pair[1].text() == text]
    return found[0][0].widgetForAction(found[0][1]) if found else None


def _ready_button(command):
    """The button of a command, once it can be pressed: FreeCAD renews by a timer which of them are
    enabled."""
    button = _tool_button(command)
    return button if button and button.isEnabled() and FreeCADGui.Command.get(command).isActive() else None


def _tree():
    """The model tree, brought to the front where the task panel hides it."""
    _pump(200)
    (tree, *_) = [
        tree
        for tree in _main().findChildren(QtWidgets.QTreeWidget)
        if tree.metaObject().className() == "Gui::TreeWidget"
    ]
    outer = tree.parentWidget()
    while outer is not None:
        if isinstance(outer, QtWidgets.QTabWidget) and not tree.isVisible():
            outer.setCurrentIndex(next(i for i in range(outer.count()) if outer.widget(i).isAncestorOf(tree)))
        if isinstance(outer, QtWidgets.QDockWidget):
            outer.show()
            outer.raise_()
        outer = outer.parentWidget()
    _pump(100)
    return tree


def _viewport():
    """The widget that draws the 3D view of the active document. (There is no *active* one while the window
    lacks the focus.)"""
    area = _main().findChild(QtWidgets.QMdiArea)
    return _until(area.currentSubWindow, SETTLED, "a 3D view").findChild(QtWidgets.QGraphicsView).viewport()


class _Frames(QtCore.QObject):
    """Paints a window at most once in so many ms, as a slow screen does: what changes meanwhile is painted
    together. Nothing else waits: events, layouts and the work behind them go on, and the last change is
    always painted.

    `between`: ms; with 0 whatever Qt asks for is painted at once. `painted`: how many pictures there were.
    """

    def __init__(self, window):
        super().__init__(window)
        self.between, self.painted = FRAME, 0
        self._window, self._last, self._timer = window, 0.0, QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._ask)
        window.installEventFilter(self)

    def _ask(self):
        QtCore.QCoreApplication.postEvent(self._window, QtCore.QEvent(QtCore.QEvent.UpdateRequest))

    def show(self):
        """Paint now what has changed since the last picture, and let the server show it."""
        if self._timer.isActive():
            self._timer.stop()
            self._last = 0.0
            self._ask()
            _pump(50)

    def eventFilter(self, window, event):
        """Qt calls this before an event arrives at the window."""
        if event.type() != QtCore.QEvent.UpdateRequest:
            return False
        left = self.between - 1000.0 * (time.monotonic() - self._last)
        if left <= 0:
            self._last, self.painted = time.monotonic(), self.painted + 1
            return False
        if not self._timer.isActive():
            self._timer.start(int(left) + 1)
        return True


_frames = []
"""That of the main window, once a test has asked for it."""


@pytest.fixture
def every_frame(window):
    """The window painted whenever Qt asks for it, for tests that are about pictures that follow one another,
    and about how lively the window is."""
    _frames[0].between = 0
    yield
    _frames[0].between = FRAME


@pytest.fixture
def frames(window):
    """What paints the window: see _Frames."""
    return _frames[0]


@pytest.fixture(scope="session")
def window():
    """FreeCAD's main window with tree and task panel shown and the workbench active. It is as small as most
    tests need, and painted twice a second: each change of any widget paints all of it, on the processor.

    The view jumps where it is sent: an animation (FreeCAD 1.1) would still be under way when the test looks.
    It has no cube to turn it by: FreeCAD paints that anew for every view, in most of the time that a new
    document takes.
    """
    main = _main()
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    view.SetBool("UseNavigationAnimations", False)
    view.SetBool("ShowNaviCube", False)
    QtWidgets.QApplication.setCursorFlashTime(0)  # a cursor that blinks has the whole window painted
    main.setGeometry(*SMALL)
    for dock in main.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Combo View", "Model", "Tasks"):
            dock.show()
    FreeCADGui.activateWorkbench(WORKBENCH)
    _frames.append(_Frames(main))
    _pump(500)
    return main


@pytest.fixture
def whole_screen(window):
    """The window as large as the screen, for tests of what needs that room."""
    window.setGeometry(*WHOLE)
    _pump(200)
    yield window
    window.setGeometry(*SMALL)
    _pump(200)


@pytest.fixture
def doc(window):
    """A new document, shown in the window; closed afterwards with whatever dialog or selection is left."""
    FreeCADGui.activateWorkbench(WORKBENCH)
    document = FreeCAD.newDocument()
    document.UndoMode = 1
    _pump(200)
    name = document.Name
    yield document
    close_all(name)


def close_all(*names):
    """Close task panel, selection and the named documents without asking."""
    FreeCADGui.Selection.clearSelection()
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    written = sys.modules.get("freecad_fiveaxis.gui.panels.written")
    for dialog in written._dialogs.values() if written else ():
        dialog.close()
    _pump(100)
    for name in names:
        if name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)
    _pump(100)


@pytest.fixture
def german(window):
    """The window in German; afterwards in English. (The locale that FreeCAD says it started with cannot
    always be set again.)"""
    FreeCADGui.setLocale("German")
    yield
    FreeCADGui.setLocale("English")


@pytest.fixture
def pump():
    """pump(ms): let the window work."""
    return _pump


@pytest.fixture
def until():
    """until(condition, ms, what): let the window work until the condition holds."""
    return _until


@pytest.fixture
def within():
    """within(ms, condition): whether the condition holds within so many ms, while the window works."""
    return _within


@pytest.fixture
def screenshot():
    """screenshot(name): picture of the screen with all windows, kept; its path."""
    return _shoot


@pytest.fixture
def click():
    """click(widget, point=None, double=False): by mouse events; fails where the widget is hidden, covered or
    disabled."""
    return _click


@pytest.fixture
def type_into():
    """type_into(widget, text): replace a field's text key by key, then Tab."""
    return _type


@pytest.fixture
def choose():
    """choose(combo box, text): open it and click the item so named."""
    return _choose


def _unfold(form, name):
    """Click the header of each folded group of the panel in which a widget of that name stands."""
    for header in form.findChildren(QtWidgets.QToolButton):
        group = header.parentWidget()
        if (
            header.objectName().startswith("fold_")
            and not header.isChecked()
            and group.findChild(QtWidgets.QWidget, name)
        ):
            _click(header)
            _pump(50)


@pytest.fixture
def unfold():
    """unfold(): click open every folded group of the task panel that is open."""

    def open_all():
        for form in _main().findChildren(QtWidgets.QWidget, PANELS[0]):
            for header in form.findChildren(QtWidgets.QToolButton):
                if header.objectName().startswith("fold_") and not header.isChecked():
                    _click(header)
                    _pump(150)

    return open_all


@pytest.fixture
def field():
    """field(name, ms=10000): the visible widget of that name in the task panel that is open, or that opens
    within so many ms; a folded group around it is clicked open."""

    def shown(name):
        forms = [form for panel in PANELS for form in _main().findChildren(QtWidgets.QWidget, panel)]
        for form in forms:
            _unfold(form, name)
        return [
            one
            for form in forms
            for one in form.findChildren(QtWidgets.QWidget, name)
            if one.isVisibleTo(form)
        ]

    return lambda name, ms=10000: _until(lambda: shown(name), ms, f"widget {name!r} shown in the task panel")[
        -1
    ]


@pytest.fixture
def key():
    """key(widget, key): press and release, e.g. QtCore.Qt.Key_Escape."""
    return _key


@pytest.fixture
def real_key():
    """real_key(widget, "Escape"): as if the keyboard had sent it to the widget's window, shortcuts
    included."""
    return _real_key


@pytest.fixture
def tool_button():
    """tool_button(command id, wait=REFRESH): its QToolButton in a visible tool bar, its state renewed within
    so many ms."""

    def find(command, wait=REFRESH):
        _pump(wait)
        return _until(lambda: _tool_button(command), READY, f"a button for {command} in a tool bar")

    return find


@pytest.fixture
def press():
    """press(command id, wait=300): a click on its tool bar button once that is enabled, then so many ms for
    the window."""

    def press_button(command, wait=300):
        _pump(50)
        _click(_until(lambda: _ready_button(command), READY, f"{command} enabled"))
        _pump(wait)

    return press_button


@pytest.fixture
def select():
    """select(obj, *sub-element names): select it alone, as a click in the tree or on its faces does."""

    def choose(obj, *subs):
        FreeCADGui.Selection.clearSelection()
        for sub in subs or ("",):
            FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, sub)
        _pump(50)

    return choose


@pytest.fixture
def panel_button():
    """panel_button("OK" | "Cancel" | "Apply" | "Close", wait=300): click that button of the task panel that
    is open."""
    box_type = QtWidgets.QDialogButtonBox
    buttons = {"OK": box_type.Ok, "Cancel": box_type.Cancel, "Apply": box_type.Apply, "Close": box_type.Close}

    def press_button(name, wait=300):
        def found():
            return [
                box for box in _main().findChildren(box_type) if box.isVisible() and box.button(buttons[name])
            ]

        _click(_until(found, READY, f"a task panel with a button {name}")[-1].button(buttons[name]))
        _pump(wait)

    return press_button


@pytest.fixture
def panel_closed():
    """panel_closed(): wait until no task panel is open."""
    return lambda: _until(lambda: not FreeCADGui.Control.activeDialog(), READY, "the task panel closed")


@pytest.fixture
def tree_row():
    """tree_row(label, double=False): click that row of the model tree (parents are unfolded).

    The tree is read through its model: PySide keeps what it hands out of FreeCAD's own QTreeWidgetItems after
    FreeCAD has deleted them, takes the next widget made at such an address for an item, and in the end
    deletes it a second time.
    """

    def rows(model, parent):
        for at in range(model.rowCount(parent)):
            index = model.index(at, 0, parent)
            yield index
            yield from rows(model, index)

    def click_row(label, double=False):
        tree = _tree()

        def row():
            return next(
                (index for index in rows(tree.model(), QtCore.QModelIndex()) if index.data() == label), None
            )

        for _ in range(
            5
            # a tree that is just being laid out again takes its selection back: whoever sees that clicks again
        ):
            tree.scrollTo(_until(row, SETTLED, f"row {label!r} in the tree"))
            _pump(100)
            _click(
                tree.viewport(),
                tree.visualRect(_until(row, SETTLED, f"row {label!r} in the tree")).center(),
                double,
            )
            if double or _within(
                TAKEN, lambda: label in [one.Label for one in FreeCADGui.Selection.getSelection()]
            ):
                return
        raise AssertionError(f"a click on row {label!r} of the tree does not select it")

    return click_row


class Answer:
    """Waits for a modal dialog and answers it. `said`: the texts of those that it met."""

    def __init__(self, answer, limit):
        self.texts = []
        self._answer, self._end = answer, time.monotonic() + limit
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(100)

    @property
    def waiting(self):
        return self._timer.isActive()

    def stop(self):
        self._timer.stop()

    def _look(self):
        dialog = QtWidgets.QApplication.activeModalWidget()
        if time.monotonic() > self._end:
            self.stop()
        if dialog is None or isinstance(dialog, QtWidgets.QProgressDialog) or not dialog.isVisible():
            return
        self.stop()
        self.texts.append(_text_of(dialog))
        if callable(self._answer):
            self._answer(dialog)
        else:
            _click_text(dialog, self._answer)


def _text_of(dialog):
    return dialog.text() if isinstance(dialog, QtWidgets.QMessageBox) else dialog.windowTitle()


def _click_text(dialog, text):
    names = {}
    for button in dialog.findChildren(QtWidgets.QAbstractButton):
        names[button.text().replace("&", "").lower()] = button
    if text.lower() not in names:
        dialog.close()
        raise AssertionError(f"no button {text!r} in the dialog, only {sorted(names)}")
    names[text.lower()].click()


@pytest.fixture
def modal():
    """modal(answer, limit=60): before what opens a dialog: who will click the button so named, or call
    answer(dialog).

    Gives an Answer whose `said` holds the text of the dialog it met (empty: none came).
    """
    result = []

    def arm(answer="OK", limit=60):
        result.append(Answer(answer, limit))
        return result[-1]

    arm.dialogs = result
    yield arm
    for answer in result:
        answer.stop()


@pytest.fixture(autouse=True)
def _nobody_left_waiting(request):
    """A message box that no test answers would stop everything: it is closed after 10 s, and the test fails
    with its text."""
    seen, unexpected = {}, []

    def look():
        dialog = QtWidgets.QApplication.activeModalWidget()
        armed = "modal" in request.fixturenames and any(
            a.waiting for a in request.getfixturevalue("modal").dialogs
        )
        if not isinstance(dialog, QtWidgets.QMessageBox) or armed:
            seen.clear()
        elif time.monotonic() - seen.setdefault("since", time.monotonic()) > 10:
            unexpected.append(dialog.text())
            dialog.close()

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(500)
    yield
    timer.stop()
    assert not unexpected, f"a message box that nobody answered: {unexpected}"


@pytest.fixture
def pixels():
    """pixels(path, rgb, tolerance=12, box=None): how many pixels differ from rgb (0 to 255) by no more than
    the tolerance.

    box: (left, top, width, height) in pixels, the part of the picture that counts; `view_box` gives that of
    the 3D view.
    """

    def count(path, rgb, tolerance=12, box=None):
        seen = _bytes_of(path)
        if box:
            left, top, width, height = box
            seen = seen[top : top + height, left : left + width]
        near = np.ones(seen.shape[:2], bool)
        for at, part in enumerate(rgb):
            values = np.abs(np.arange(256) - part) <= tolerance
            near &= values[seen[..., at]]
        return int(near.sum())

    return count


def _bytes_of(path):
    """(height, width, 3) uint8: red, green, blue of each pixel."""
    image = QtGui.QImage(path)
    assert not image.isNull(), path
    image = image.convertToFormat(QtGui.QImage.Format_RGB32)
    pixel = np.frombuffer(bytes(image.constBits()), np.uint8).reshape(image.height(), image.width(), 4)
    return pixel[..., 2::-1]  # blue, green, red, nothing, as processors are that FreeCAD runs on


def picture(path):
    return _bytes_of(path).astype(int)


SHADES = " .:-=+*#%@"
CELL = 12, 24  # pixels of the screen, width and height, for one letter


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """What failed shows the screen in letters, the darker the denser: where the rings run far away, nobody
    sees the pictures."""
    report = (yield).get_result()
    if report.when == "call" and report.failed:
        report.sections.append(("the screen when it failed", _in_letters(_shoot("failed"))))


def _in_letters(path):
    """The picture's darkness as lines of text, a letter for each cell."""
    seen, (width, height) = picture(path).mean(axis=2), CELL
    rows, columns = seen.shape[0] // height, seen.shape[1] // width
    mean = seen[: rows * height, : columns * width].reshape(rows, height, columns, width).mean(axis=(1, 3))
    level = ((255.0 - mean) / 256.0 * len(SHADES)).astype(int)
    return "\n".join(
        "".join(SHADES[one] for one in row) for row in level[: SMALL[3] // height, : SMALL[2] // width]
    )


@pytest.fixture
def view_box():
    """view_box(): (left, top, width, height) of the 3D view on the screen."""

    def box():
        viewport = _viewport()
        corner = viewport.mapToGlobal(QtCore.QPoint(0, 0))
        return corner.x(), corner.y(), viewport.width(), viewport.height()

    return box


@pytest.fixture
def view_point():
    """view_point((x, y, z)): the QPoint of the 3D view's widget where that point of the document is drawn."""

    def point(place):
        view, viewport = FreeCADGui.ActiveDocument.ActiveView, _viewport()
        x, y = view.getPointOnScreen(*place)
        width, height = view.getSize()  # device pixels; where Qt scales, the widget has fewer
        return QtCore.QPoint(
            round(x * viewport.width() / width), round((height - 1 - y) * viewport.height() / height)
        )

    return point


@pytest.fixture
def view_click(whole_screen, view_point):
    """view_click((x, y, z)): move the mouse in the 3D view to where that point is drawn (mm, document), and
    click there, once the view stands still. On the whole screen: in a small window FreeCAD 1.1 lays its
    panels over the view."""

    def still(place):
        before = view_point(place)
        _pump(200)
        return view_point(place) == before

    def click_at(place):
        _until(lambda: still(place), SETTLED, "a view that stands still")
        point, viewport = view_point(place), _viewport()
        assert viewport.rect().contains(point), f"{place} is drawn outside the view, at {point}"
        _mouse(viewport, QtCore.QEvent.MouseMove, point + QtCore.QPoint(3, 3), NONE, NONE)
        _pump(150)
        _click(viewport, point)
        _pump(200)

    return click_at


@pytest.fixture
def parameters():
    """parameters(path): a FreeCAD parameter group whose contents are put back afterwards."""
    kept = []

    def group(path):
        found = FreeCAD.ParamGet(path)
        kept.append((found, found.GetContents() or []))
        return found

    yield group
    for found, contents in reversed(kept):
        found.Clear()
        for kind, name, value in contents:
            {
                "String": found.SetString, "Integer": found.SetInt, "Float": found.SetFloat, "Boolean": found.SetBool,
                "Unsigned Long": found.SetUnsigned,
            }[kind](name, value)  # fmt: skip


@pytest.fixture
def dome(doc):
    """The upper half of a ball, 20 mm."""
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    return part
