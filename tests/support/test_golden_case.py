#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
import os
import tempfile
import unittest

from golden_case import GoldenCase


class GoldenCaseTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        before = os.environ.pop("TZC_UPDATE_GOLDEN", None)
        self.addCleanup(lambda: os.environ.update({"TZC_UPDATE_GOLDEN": before} if before else {}))
        self.addCleanup(lambda: os.environ.pop("TZC_UPDATE_GOLDEN", None))

    def read(self, content):
        path = os.path.join(self.folder, "one.case")
        with open(path, "wb") as file:
            file.write(content)
        return GoldenCase(path)

    def file(self, name="one.case"):
        with open(os.path.join(self.folder, name), "rb") as file:
            return file.read()

    def test_a_head_sections_and_an_expectation(self):
        one = self.read(b"head\n//--- a.h\nint a;\n#--- uses\n#--- expected\nout\n")
        self.assertEqual(one.head, "head\n")
        self.assertEqual(one.sections, {"a.h": "int a;\n", "uses": ""})
        self.assertEqual(one.expected("new\n"), "out\n")

    def test_without_an_expectation_it_is_an_error(self):
        for content in (b"head\n", b"#--- expected\nout\n#--- a\n"):
            with self.assertRaises(ValueError):
                self.read(content)

    def test_the_switch_writes_what_is_new(self):
        one = self.read(b"#--- a\nx\n#--- expected\nold\n")
        os.environ["TZC_UPDATE_GOLDEN"] = "1"
        self.assertEqual(one.expected("new\n"), "new\n")
        self.assertEqual(self.file(), b"#--- a\nx\n#--- expected\nnew\n")

    def test_any_bytes_stay_as_they_are(self):
        content = b"\xef\xbb\xbf\xff\x00\r\n\x0b\n"
        one = self.read(b"#--- sub/a\n" + content + b"#--- expected\nold\n")
        one.write_sections(self.folder, ["sub/a"])
        self.assertEqual(self.file("sub/a"), content)
        os.environ["TZC_UPDATE_GOLDEN"] = "1"
        one.expected("new\n")
        self.assertEqual(self.file(), b"#--- sub/a\n" + content + b"#--- expected\nnew\n")


if __name__ == "__main__":
    unittest.main()
