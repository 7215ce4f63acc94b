# SPDX-License-Identifier: BSD-3-Clause
"""The environment of a workspace, wherever it lies."""
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
from workspace_env import workspace_env  # noqa: E402


class WorkspaceEnv(unittest.TestCase):
    def workspace(self, folder, name, setup):
        workspace = os.path.join(folder, name)
        os.makedirs(os.path.join(workspace, "devel"))
        with open(os.path.join(workspace, "devel", "setup.bash"), "w", encoding="utf-8") as file:
            file.write(setup)
        return workspace

    def test_whatever_its_path(self):
        for name in ("plain", "with a blank", "it's", "$HOME; exit 3"):
            with tempfile.TemporaryDirectory() as folder:
                setup = 'echo it speaks\nexport OF_WORKSPACE="two\nlines" ARGUMENTS=$#\n'
                env = workspace_env(self.workspace(folder, name, setup))
                self.assertEqual((env["OF_WORKSPACE"], env["ARGUMENTS"]), ("two\nlines", "0"))

    def test_a_setup_file_that_fails_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(subprocess.CalledProcessError):
            workspace_env(self.workspace(folder, "broken", "exit 3\n"))


if __name__ == "__main__":
    unittest.main()
