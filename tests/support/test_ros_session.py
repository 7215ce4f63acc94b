# SPDX-License-Identifier: BSD-3-Clause
"""What a session's processes find in their environment, and that none of them outlives it."""
import contextlib
import io
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import ros_session
from ros_session import ReservedPort, RosSession


class Ports(unittest.TestCase):
    def test_a_port_is_given_to_one_session_only_from_its_beginning_to_its_end(self):
        """Else two share the roscore of one of them, which ends with that one."""
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(ros_session.random, "randrange") as dice:
            dice.side_effect = [15000, *range(15000, 16000)]
            first = ReservedPort()
            second = ReservedPort()
            self.assertNotEqual(first.number, second.number)
            dice.side_effect = [second.number, *range(16000, 17000)]
            second.close()
            with RosSession(folder) as ros:
                self.assertEqual(ros.port, second.number)
                dice.side_effect = [ros.port, *range(16000, 17000)]
                self.assertGreaterEqual(ReservedPort().number, 16000)
            first.close()

    def test_a_roscore_that_ended_is_said(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
            with RosSession(folder) as ros:
                ros.core.stop()
        self.assertIn("roscore ended before its session", said.getvalue())


class Environment(unittest.TestCase):
    def session(self, **env):
        return RosSession(tempfile.gettempdir(), env)

    def test_the_sessions_master_wins_over_the_one_that_a_workspace_names(self):
        session = self.session(ROS_MASTER_URI="http://localhost:11311", ROS_HOME="/nowhere", ROS_LOG_DIR="/nowhere")
        self.assertEqual(session.env["ROS_MASTER_URI"], session.uri)
        self.assertEqual(session.env["ROS_HOME"], tempfile.gettempdir())
        self.assertTrue(session.env["ROS_LOG_DIR"].startswith(tempfile.gettempdir()))

    def test_what_else_is_asked_for_is_given(self):
        session = self.session(ROS_IP="127.0.0.2", TZC_DISABLE="1")
        self.assertEqual((session.env["ROS_IP"], session.env["TZC_DISABLE"]), ("127.0.0.2", "1"))

    def test_a_host_name_of_the_machine_does_not_get_in(self):
        os.environ["ROS_HOSTNAME"] = "elsewhere"
        try:
            self.assertNotIn("ROS_HOSTNAME", self.session().env)
        finally:
            del os.environ["ROS_HOSTNAME"]


def processes_of(folder):
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/environ", "rb") as environment:
                found += [pid] if f"ROS_HOME={folder}".encode() in environment.read().split(b"\0") else []
        except OSError:  # it has ended, or is another user's
            continue
    return found


class End(unittest.TestCase):
    """Of a session whose process is terminated: while it starts roscore, while that starts, or later."""
    PROGRAM = """
import sys, time
from ros_session import RosSession
with RosSession(sys.argv[1]) as ros:
    print("entered", flush=True)
    time.sleep(60)
"""

    def terminated(self, folder, when, program=PROGRAM):
        environment = dict(os.environ, PYTHONPATH=os.path.dirname(os.path.abspath(__file__)))
        with subprocess.Popen([sys.executable, "-c", program, folder], env=environment, stdout=subprocess.PIPE) as child:
            when(child)
            child.send_signal(signal.SIGTERM)
            return child.wait(60)

    def assert_none_left(self, folder):
        """Each process of the session has the folder in its environment."""
        self.assertEqual(processes_of(folder), [])

    @staticmethod
    def core_is_started(folder):
        while not processes_of(folder):
            time.sleep(0.01)

    def test_while_roscore_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.terminated(folder, lambda child: self.core_is_started(folder)), 143)
            self.assert_none_left(folder)

    def test_while_a_process_is_there_and_nothing_names_it_yet(self):
        """As if the signal came between fork and the return of Popen."""
        program = """
import os, signal, subprocess, sys
from ros_session import RosSession
class Slow(subprocess.Popen):
    def __init__(self, *given, **named):
        super().__init__(*given, **named)
        os.kill(os.getpid(), signal.SIGTERM)
        for _ in range(1000):
            pass  # the handler runs here
subprocess.Popen = Slow
with RosSession(sys.argv[1]) as ros:
    pass
"""
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.terminated(folder, lambda child: child.wait(60), program), 143)
            self.assert_none_left(folder)

    def test_while_it_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.terminated(folder, lambda child: child.stdout.readline()), 143)
            self.assert_none_left(folder)


if __name__ == "__main__":
    unittest.main()
