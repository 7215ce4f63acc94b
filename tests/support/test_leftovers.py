# SPDX-License-Identifier: BSD-3-Clause
"""What counts as left behind."""
import os
import socket
import tempfile
import threading
import unittest

from leftovers import is_socket, left_behind


class Leftovers(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.addCleanup(setattr, tempfile, "tempdir", tempfile.tempdir)
        self.folder = tempfile.tempdir = scratch.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_a_socket_is(self):
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(self.path("tzc-socket"))
            self.assertIn(self.path("tzc-socket"), left_behind())

    def test_a_folder_of_another_test_is_not(self):
        os.mkdir(self.path("tzc_test"))
        self.assertNotIn(self.path("tzc_test"), left_behind())

    def test_what_is_gone_by_now_is_not(self):
        self.assertFalse(is_socket(self.path("tzc-gone")))

    def test_files_that_come_and_go_meanwhile_do_no_harm(self):
        stop = threading.Event()

        def come_and_go():
            while not stop.is_set():
                for number in range(50):
                    os.mkdir(self.path(f"tzc_{number}"))
                for number in range(50):
                    os.rmdir(self.path(f"tzc_{number}"))

        other = threading.Thread(target=come_and_go)
        other.start()
        try:
            for _ in range(300):
                self.assertFalse({path for path in left_behind() if path.startswith(self.folder)})
        finally:
            stop.set()
            other.join()


if __name__ == "__main__":
    unittest.main()
