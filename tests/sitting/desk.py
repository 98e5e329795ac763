# SPDX-License-Identifier: LGPL-2.1-or-later
"""The desk a user sits at: a screen, a window manager, the bus of the accessibility tree, and FreeCAD when he
starts it.

Everything started here is ended here, by its process and not by its name.
"""

from __future__ import annotations

import ctypes
import os
import subprocess
import tempfile
import time

from eyes import Bus
from gi.repository import Gio, GLib

SIZE = (1920, 1080)


class Desk:
    """``with Desk() as desk``: screen, window manager and bus are there. ``start`` begins a program on it."""

    def __init__(self, size: tuple[int, int] = SIZE) -> None:
        self.size, self.programs = size, []

    def __enter__(self) -> Desk:
        os.environ["DISPLAY"] = self._screen()
        self.start(["openbox"])
        launcher = os.environ["FIVEAXIS_BUS_LAUNCHER"]
        self.start([launcher, "--launch-immediately"])
        self.bus_address = _wait_for(_bus_address, 10)
        tell_root_window("AT_SPI_BUS", self.bus_address)  # else Qt 5 comes to the bus only now and then
        Bus(self.bus_address).program("")  # the registry is awake before the first program comes
        return self

    def _screen(self) -> str:
        """An X server with a display of its own; 96 dpi: with Xvfb's own 100 Qt scales by 1.04."""
        size = f"{self.size[0]}x{self.size[1]}x24"
        inlet, outlet = os.pipe()
        command = [
            "Xvfb",
            "-displayfd",
            str(outlet),
            "-screen",
            "0",
            size,
            "-dpi",
            "96",
            "-nolisten",
            "tcp",
            "-noreset",
        ]
        self.start(command, pass_fds=[outlet])
        os.close(outlet)
        with os.fdopen(inlet) as reported:
            return ":" + reported.readline().strip()

    def start(self, command: list[str], log: str = os.devnull, **more) -> subprocess.Popen:
        """Begin a program; what it says goes to the file ``log``."""
        with open(log, "ab") as out:
            program = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT, **more
            )
        self.programs.append(program)
        return program

    def __exit__(self, *_) -> None:
        for program in reversed(self.programs):
            program.terminate()
        for program in reversed(self.programs):
            try:
                program.wait(5)
            except subprocess.TimeoutExpired:
                program.kill()


def _bus_address() -> str:
    session = Gio.bus_get_sync(Gio.BusType.SESSION)
    try:
        reply = session.call_sync(
            "org.a11y.Bus",
            "/org/a11y/bus",
            "org.a11y.Bus",
            "GetAddress",
            None,
            None,
            Gio.DBusCallFlags.NONE,
            5000,
        )
    except GLib.Error:
        return ""
    return reply.unpack()[0]


def _wait_for(wanted, seconds: float) -> str:
    end = time.monotonic() + seconds
    while not (answer := wanted()):
        if time.monotonic() > end:
            raise TimeoutError(f"{wanted.__name__} gives nothing within {seconds} s")
        time.sleep(0.1)
    return answer


def tell_root_window(name: str, text: str) -> None:
    """Write a text where every program of this screen can read it."""
    x = ctypes.CDLL("libX11.so.6")
    x.XOpenDisplay.restype = ctypes.c_void_p
    for call in (x.XDefaultRootWindow, x.XInternAtom):
        call.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x.XOpenDisplay(None))
    atom = ctypes.c_ulong(x.XInternAtom(display, name.encode(), 0))
    string, replace, message = ctypes.c_ulong(31), 0, text.encode()
    x.XChangeProperty(
        display,
        ctypes.c_ulong(x.XDefaultRootWindow(display)),
        atom,
        string,
        8,
        replace,
        message,
        len(message),
    )
    x.XCloseDisplay(display)


def run_quietly(command: list[str], seconds: float = 120, **environment: str) -> str:
    """Run a program to its end; what it said. Raises RuntimeError with that where it fails."""
    with tempfile.TemporaryFile() as out:
        done = subprocess.run(
            command, env={**os.environ, **environment}, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
            timeout=seconds, check=False,
        )  # fmt: skip
        out.seek(0)
        message = out.read().decode(errors="replace")
    if done.returncode:
        raise RuntimeError(f"{command[0]} failed (code {done.returncode}):\n{message[-2000:]}")
    return message
