# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C ends scripts/demo --red-light, and every process that it started.

usage: test_interrupt.py SOURCE_DIR PORTED_APPLICATIONS SCRATCH
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TIMEOUT = 120


def processes_with(text, file):
    """Pids, with what /proc/PID/cmdline or environ says, of the processes where that contains the text."""
    found = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/{file}", "rb") as content:
                entries = content.read().decode(errors="replace").replace("\0", " ")
        except OSError:  # it has ended
            continue
        if text in entries and int(pid) != os.getpid():
            found[int(pid)] = entries
    return found


def started_in(scratch):
    """Roslaunch and the nodes by their command lines, roscore and rosmaster by their environment."""
    return {**processes_with(scratch, "cmdline"), **processes_with(f"ROS_HOME={scratch}", "environ")}


def wait_until(condition, what):
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        assert time.monotonic() < deadline, f"waited in vain for {what}"
        time.sleep(0.1)


def main():
    source, applications, scratch = sys.argv[1:]
    shutil.rmtree(scratch, ignore_errors=True)
    os.makedirs(scratch)
    scratch = tempfile.mkdtemp(dir=scratch)  # a name that no command line had before
    demo = subprocess.Popen(
        [sys.executable, os.path.join(source, "scripts/lib/applications.py"), "red_light", scratch,
         os.path.join(applications, "original"), os.path.join(applications, "ported"),
         "--port-report", os.path.join(applications, "port.json"), "--runs", "1"], stdout=subprocess.DEVNULL)
    try:
        nodes = ("robot_node", "camera_node", "logger_node", "detector_node", "braking_node", "stopwatch_node")
        wait_until(lambda: all(map(" ".join(processes_with(scratch, "cmdline").values()).__contains__, nodes)),
                   "the nodes to start")
        assert any("rosmaster" in command for command in processes_with(scratch, "cmdline").values()), \
            "no rosmaster was found, so its end would not be seen"
    finally:
        demo.send_signal(signal.SIGINT)
        status = demo.wait(TIMEOUT)
    left = started_in(scratch)
    assert not left, f"still there after Ctrl-C: {left}"
    assert status == 130, f"exit status {status} instead of 130"


if __name__ == "__main__":
    main()
