#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The format and tidy tests fail on bad files, pass on good ones, and tidy looks again only at what has changed.

usage: test_style.py CLANG_FORMAT CLANG_TIDY [--plugin PLUGIN]
"""
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from unittest import mock

import format as format_test
import tidy

CLANG_FORMAT, CLANG_TIDY = sys.argv[1:3] if len(sys.argv) > 2 else ("clang-format-19", "clang-tidy-19")
PLUGIN = sys.argv[3:5]


class StyleCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        self.write(".clang-format", "BasedOnStyle: Google\n")
        self.write(".clang-tidy", "Checks: '-*,modernize-use-nullptr'\nWarningsAsErrors: '*'\nHeaderFilterRegex: '.*'\n")

    def write(self, path, text):
        full = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "w", encoding="utf-8") as file:
            file.write(text)

    def outcome(self, main, *arguments):
        output = io.StringIO()
        with redirect_stdout(output):
            status = main(*arguments)
        return status, output.getvalue()


class Format(StyleCase):
    def test_a_file_out_of_form_is_named(self):
        self.write("bench/a.cpp", "int  a;\n")
        self.write("bench/b.cpp", "int b;\n")
        status, output = self.outcome(format_test.main, CLANG_FORMAT, self.root)
        self.assertEqual(status, 1)
        self.assertIn("-i bench/a.cpp\n", output)

    def test_files_in_form(self):
        self.write("bench/b.cpp", "int b;\n")
        self.assertEqual(self.outcome(format_test.main, CLANG_FORMAT, self.root)[0], 0)

    def test_the_inputs_of_tests_may_have_any_form(self):
        self.write("bench/b.cpp", "int b;\n")
        self.write("tests/rewriter/golden/cases/plain/a.cpp", "int  a;\n")
        self.assertEqual(self.outcome(format_test.main, CLANG_FORMAT, self.root)[0], 0)

    def test_no_files_is_a_failure(self):
        self.assertEqual(self.outcome(format_test.main, CLANG_FORMAT, self.root)[0], 1)


class Tidy(StyleCase):
    def tidy(self, *names, options=()):
        build = os.path.join(self.root, "build")
        files = [os.path.join(self.root, name) for name in names or ["bench/a.cpp"]]
        self.write("build/compile_commands.json", json.dumps([{
            "directory": build, "file": file, "command": f"ccache c++ -I{self.root} -o {file}.o -c {file}"} for file in files]))
        return self.outcome(tidy.main, *PLUGIN, *options, CLANG_TIDY, self.root, build)

    def marks(self):
        return len(os.listdir(os.path.join(self.root, "build/tidy")))

    def test_a_bad_file_is_reported_every_time(self):
        self.write("bench/a.cpp", "int* a = 0;\n")
        for _ in range(2):
            status, output = self.tidy()
            self.assertEqual(status, 1)
            self.assertIn("modernize-use-nullptr", output)

    def test_a_clean_file_is_not_looked_at_again(self):
        self.write("bench/a.cpp", "int* a = nullptr;\n")
        self.assertEqual((self.tidy()[0], self.tidy()[0], self.marks()), (0, 0, 1))

    def test_folders_may_be_relative(self):
        self.write("bench/a.cpp", "int* a = nullptr;\n")
        self.tidy()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.root)
        self.write("bench/a.cpp", "int* a = 0;\n")
        self.assertIn("modernize-use-nullptr", self.outcome(tidy.main, *PLUGIN, CLANG_TIDY, ".", "build", "bench/a.cpp")[1])

    def test_a_header_that_gets_worse_is_noticed(self):
        self.write("bench/a.h", "\n")
        self.write("bench/a.cpp", '#include "bench/a.h"\n')
        self.assertEqual(self.tidy()[0], 0)
        self.write("bench/a.h", "static int* a = 0;\n")
        self.assertEqual(self.tidy()[0], 1)

    def test_other_checks_are_noticed(self):
        self.write("bench/a.cpp", "int* a = nullptr;\n")
        self.assertEqual(self.tidy()[0], 0)
        self.write(".clang-tidy", "Checks: '-*,cppcoreguidelines-avoid-non-const-global-variables'\nWarningsAsErrors: '*'\n")
        self.assertEqual(self.tidy()[0], 1)

    def test_other_checks_of_a_folder_are_noticed(self):
        self.write("bench/a.cpp", "int* a = nullptr;\n")
        self.assertEqual(self.tidy()[0], 0)
        self.write("bench/.clang-tidy", "InheritParentConfig: true\n"
                   "Checks: 'cppcoreguidelines-avoid-non-const-global-variables'\n")
        self.assertEqual(self.tidy()[0], 1)

    def test_a_file_that_does_not_parse_fails(self):
        self.write("bench/a.cpp", "int\n")
        self.assertEqual(self.tidy()[0], 1)

    def test_files_looked_at_together(self):
        names = [f"bench/{name}.cpp" for name in "abc"]
        for name in names:
            self.write(name, f"int* {name[6]} = nullptr;\n")
        self.assertEqual((self.tidy(*names)[0], self.marks()), (0, 3))
        self.write("bench/b.cpp", "int* b = 0;\n")
        status, output = self.tidy(*names)
        self.assertEqual(status, 1)
        self.assertIn("bench/b.cpp:1", output)
        self.assertNotIn("bench/a.cpp", output)
        self.assertEqual(self.marks(), 3)

    def test_files_with_helpers_of_one_name(self):
        names = [f"bench/{name}.cpp" for name in "abcd"]
        for name in names:
            self.write(name, f"namespace {{\nint* helper() {{ return nullptr; }}\n}}\nint* {name[6]} = helper();\n")
        self.write("bench/d.cpp", "int* d = nullptr;\n")
        status, output = self.tidy(*names)
        self.assertEqual((status, self.marks()), (0, 4), output)
        self.write("bench/c.cpp", "namespace {\nint* helper() { return 0; }\n}\nint* c = helper();\n")
        status, output = self.tidy(*names)
        self.assertEqual(status, 1)
        self.assertIn("bench/c.cpp:2", output)
        self.assertNotIn("redefinition", output)

    def test_programs_are_looked_at_together(self):
        names = [f"bench/{name}.cpp" for name in "ab"]
        for name in names:
            self.write(name, "int main() { return 0; }\n")
        batches = []
        with mock.patch.object(tidy.Tidy, "complaints", lambda _, batch: batches.append(len(batch)) or ""):
            self.tidy(*names)
        self.assertEqual(batches, [2])
        self.assertEqual(self.tidy(*names)[0], 0)

    def test_a_recorded_file_is_not_looked_at_in_another_clone(self):
        self.write("bench/a.h", "static int* b = nullptr;\n")
        self.write("bench/a.cpp", '#include "bench/a.h"\nint* a = nullptr;\n')
        record = os.path.join(self.root, "clean.txt")
        self.assertEqual(self.tidy(options=["--record", record])[0], 0)
        other = tempfile.TemporaryDirectory()
        self.addCleanup(other.cleanup)
        self.root = shutil.copytree(self.root, other.name, dirs_exist_ok=True, ignore=shutil.ignore_patterns("build"))
        self.assertEqual((self.tidy(options=["--clean", record])[0], self.marks()), (0, 0))
        self.write("bench/a.h", "static int* b = 0;\n")
        status, output = self.tidy(options=["--clean", record])
        self.assertEqual(status, 1)
        self.assertIn("bench/a.h:1", output)

    def test_nothing_is_recorded_of_what_is_not_clean(self):
        self.write("bench/a.cpp", "int* a = 0;\n")
        record = os.path.join(self.root, "clean.txt")
        self.assertEqual(self.tidy(options=["--record", record])[0], 1)
        self.assertFalse(os.path.exists(record))

    def test_files_of_folders_with_other_checks(self):
        self.write("bench/.clang-tidy", "Checks: '-*,misc-unused-alias-decls'\nWarningsAsErrors: '*'\n")
        self.write("bench/a.cpp", "int* a = 0;\n")
        self.write("tests/b.cpp", "int* b = 0;\n")
        status, output = self.tidy("bench/a.cpp", "tests/b.cpp")
        self.assertEqual(status, 1)
        self.assertIn("tests/b.cpp:1", output)
        self.assertNotIn("bench/a.cpp", output)


@unittest.skipUnless(PLUGIN, "no Clang 19 to build the plugin with")
class Plugin(StyleCase):
    def findings(self, *options):
        """Of a file and of a system header, where clang-tidy is asked for those, too."""
        for file in "system/header.h", "bench/own.h", "bench/a.cpp":
            include = '#include <header.h>\n#include "own.h"\n' if file.endswith(".cpp") else "\n\n"
            self.write(file, f"{include}inline double in_{len(file)}(int a) {{ return a / 2; }}\n")
        return subprocess.run([CLANG_TIDY, *options, "--checks=-*,bugprone-integer-division", "--header-filter=.*",
                               "--system-headers", "--quiet", f"{self.root}/bench/a.cpp", "--",
                               "-isystem", f"{self.root}/system"], text=True, stdout=subprocess.PIPE, check=False).stdout

    def test_nothing_is_looked_for_in_system_headers(self):
        self.assertIn("system/header.h:3", self.findings())
        findings = self.findings(f"--load={PLUGIN[1]}")
        self.assertNotIn("system/header.h", findings)
        self.assertIn("bench/own.h:3", findings)
        self.assertIn("bench/a.cpp:3", findings)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
