# SPDX-License-Identifier: LGPL-2.1-or-later
"""The DISPLAY program of a headless LinuxCNC: homes, runs the programs of orders.json one after the other,
samples every servo cycle of each, and quits. Runs under the system's Python, where LinuxCNC's module is."""

import json
import signal
import subprocess
import sys
import time

import linuxcnc

SECONDS = 60.0
"""The longest that one program may take."""


def main(orders):
    command, state, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()
    switch_on(command, state)
    with open(orders) as stream:
        jobs = json.load(stream)
    results = [run(command, state, errors, job["program"], job["samples"]) for job in jobs]
    with open("results.json", "w") as stream:
        json.dump(results, stream)


def switch_on(command, state):
    for step in (lambda: command.state(linuxcnc.STATE_ESTOP_RESET), lambda: command.state(linuxcnc.STATE_ON)):
        step()
        command.wait_complete(10)
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete(10)
    command.home(-1)
    wait(state, lambda: all(state.homed[: state.joints]), 20.0)
    command.teleop_enable(1)
    command.wait_complete(10)
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete(10)


def wait(state, ready, seconds):
    end = time.time() + seconds
    while time.time() < end:
        state.poll()
        if ready():
            return True
        time.sleep(0.01)
    return False


def run(command, state, errors, program, samples):
    """The messages of the controller while it runs the program; empty where all went well."""
    command.program_open(program)
    command.wait_complete(10)
    with open(samples, "w") as stream:
        sampler = subprocess.Popen(["halsampler", "-t", "-c", "0"], stdout=stream)
        time.sleep(0.1)
        command.auto(linuxcnc.AUTO_RUN, 0)
        wait(state, lambda: state.interp_state != linuxcnc.INTERP_IDLE, 3.0)
        done = wait(
            state,
            lambda: state.interp_state == linuxcnc.INTERP_IDLE and state.inpos and state.queue == 0,
            SECONDS,
        )
        time.sleep(0.2)
        sampler.send_signal(signal.SIGINT)
        sampler.wait(10)
    reported = [] if done else ["the program did not come to its end"]
    while (message := errors.poll()) is not None:
        reported.append(message[1].strip())
    return reported


if __name__ == "__main__":
    main("orders.json")
    sys.exit(0)
