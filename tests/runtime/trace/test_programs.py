# SPDX-License-Identifier: BSD-3-Clause
"""The traces of two programs without ROS: test_programs.py BIN_DIR."""
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from trace_file import Trace, events_of, is_strict_json, load  # noqa: E402

BIN = sys.argv.pop()
CAMERA, VIEWER = (os.path.join(BIN, f"posix_pair_{side}") for side in ("camera", "viewer"))


def wait_until(condition, what, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"waited in vain for {what}")
        time.sleep(0.02)


class Programs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tzc_test_")
        self.addCleanup(scratch.cleanup)
        self.scratch = scratch.name
        self.file = os.path.join(self.scratch, "trace.json")

    def start(self, *command, trace=None):
        process = subprocess.Popen(command, env=dict(os.environ, TZC_TRACE=self.file if trace is None else trace),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def view(self, frames, **how):
        """A viewer that came to its end; the camera needs a moment before it can be found."""
        viewers = []

        def saw_all():
            viewers.append(self.start(VIEWER, str(frames), **how))
            viewers[-1].wait(60)
            return viewers[-1].returncode == 0
        wait_until(saw_all, "the frames")
        return viewers[-1]

    def test_each_step_of_each_message_and_its_flow(self):
        camera = self.start(CAMERA)
        viewer = self.view(10)
        viewer_trace = f"{self.file}.{viewer.pid}"
        self.assertTrue(is_strict_json(viewer_trace))
        steps_of_each = ("publish", "wake", "take")  # the camera writes its own a little later
        wait_until(lambda: len(Trace(load(self.file + ".*")).complete(*steps_of_each)) == 10, "the camera's events")
        camera.send_signal(signal.SIGKILL)
        camera.wait()
        camera_trace = f"{self.file}.{camera.pid}"
        self.assertFalse(is_strict_json(camera_trace))  # it was killed; its lines can be read all the same
        trace = Trace(events_of(camera_trace) + events_of(viewer_trace))
        messages = trace.complete(*steps_of_each)
        self.assertEqual(len(messages), 10)
        for message, steps in messages.items():
            trace.check_order(self, message)
            self.assertEqual((steps["publish"]["pid"], steps["take"]["pid"]), (camera.pid, viewer.pid))
            self.assertLess(steps["publish"]["args"]["bytes"], 1000)
        self.assertEqual(len(trace.names("process_name")), 2)
        self.assertEqual(trace.left_out(), 0)

    def test_a_file_that_cannot_be_written_is_said_once_and_changes_nothing(self):
        camera = self.start(CAMERA, "300", trace="/no/such/folder/trace")
        viewer = self.view(5, trace="")
        camera.kill()
        self.assertEqual(viewer.returncode, 0)
        self.assertEqual(os.listdir(self.scratch), [])
        error = camera.communicate()[1].decode()
        self.assertEqual(error.count("TZC_TRACE: cannot write /no/such/folder/trace"), 1, error)

    def test_a_full_disk_is_said_once_and_changes_nothing(self):
        camera = self.start(CAMERA, "300", trace="/proc/%p/root/dev/full")
        viewer = self.view(5, trace="")
        camera.kill()
        self.assertEqual(viewer.returncode, 0)
        error = camera.communicate()[1].decode()
        self.assertEqual(error.count("No space left on device; events are left out of the trace"), 1, error)

    def test_without_the_variable_there_is_no_thread_and_no_file(self):
        camera = self.start(CAMERA, "300", trace="")
        self.view(3, trace="")
        threads = []
        for task in os.listdir(f"/proc/{camera.pid}/task"):
            with open(f"/proc/{camera.pid}/task/{task}/comm", encoding="ascii") as comm:
                threads.append(comm.read().strip())
        self.assertNotIn("tzc-trace", threads)
        self.assertEqual(os.listdir(self.scratch), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
