# SPDX-License-Identifier: BSD-3-Clause
"""Runs a check over a tiny tree."""
import os
import tempfile
import unittest

from source_tree import SourceTree


class CheckCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name

    def problems(self, check, files):
        for path, text in files.items():
            full = os.path.join(self.root, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)
        return [f"{p.where}: {p.text}" for p in check(SourceTree(self.root))]

    def assert_problem(self, check, files, *words):
        found = self.problems(check, files)
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def assert_clean(self, check, files):
        self.assertEqual(self.problems(check, files), [])
