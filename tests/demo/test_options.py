# SPDX-License-Identifier: BSD-3-Clause
"""scripts/demo refuses options that mean nothing, before it sets anything up."""
import os
import subprocess
import unittest

DEMO = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "demo")


def demo(*options):
    done = subprocess.run([DEMO, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
    return done.returncode, done.stdout.decode()


class Options(unittest.TestCase):
    def test_of_an_application_need_an_application(self):
        for option in (["--quick"], ["--build-only"], ["--runs", "3"]):
            self.assertEqual(demo(*option), (2, f"error: {option[0]} goes with --red-light or --rotation\n"))

    def test_of_the_pairs_need_that_there_is_no_application(self):
        for options in (["--red-light", "--seconds", "3"], ["--seconds", "3", "--rotation"]):
            self.assertEqual(demo(*options), (2, "error: --seconds goes without --red-light and --rotation\n"))

    def test_with_a_number_need_one(self):
        for number in ("0", "-1", "many"):
            status, output = demo("--red-light", "--runs", number)
            self.assertEqual((status, output), (2, f"error: --runs needs a number of at least 1, not '{number}'\n"))
        for number in ("0", "0.0", "-1", "many", "1 2"):
            self.assertEqual(demo("--seconds", number), (2, f"error: --seconds needs a number above 0, not '{number}'\n"))

    def test_with_a_number_have_one(self):
        for option in ("--runs", "--seconds"):
            status, output = demo("--red-light", option)
            self.assertEqual(status, 2)
            self.assertIn(f"{option} needs a number", output)

    def test_that_are_unknown_show_the_usage(self):
        status, output = demo("--blue-light")
        self.assertEqual(status, 2)
        self.assertIn("usage: scripts/demo", output)

    def test_help_shows_examples(self):
        status, output = demo("--help")
        self.assertEqual(status, 0)
        self.assertIn("scripts/demo --rotation --quick", output)


if __name__ == "__main__":
    unittest.main()
