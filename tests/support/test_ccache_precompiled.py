#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""cmake/ccache-precompiled: a precompiled header is the one of its headers, whatever lies in its place.

    test_ccache_precompiled.py CCACHE COMPILER
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

CCACHE, COMPILER = sys.argv[1:3]
WRAPPER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cmake", "ccache-precompiled")


class CcachePrecompiled(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.environment = dict(os.environ, CCACHE_DIR=os.path.join(self.folder, "cache"), CCACHE_NODISABLE="1")
        self.write("pch.hxx", '#include "value.h"\n')
        self.write("pch.hxx.cxx", "/* made by the build */\n")
        self.write("user.cpp", "static_assert(value == WANTED);\n")

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def compile(self, *arguments):
        subprocess.run([WRAPPER, CCACHE, COMPILER, "-std=c++17", "-fpch-preprocess", "-include", "pch.hxx", *arguments],
                       cwd=self.folder, env=self.environment, check=True)

    def build(self, value):
        self.write("value.h", f"constexpr int value = {value};\n")
        self.compile("-x", "c++-header", "-o", "pch.hxx.gch", "-c", "pch.hxx.cxx")
        self.compile(f"-DWANTED={value}", "-o", "user.o", "-c", "user.cpp")

    def test_two_changes_from_the_same_state(self):
        self.build(0)
        old = os.path.join(self.folder, "pch.hxx.gch")
        kept = os.path.join(self.folder, "kept")
        shutil.copy2(old, kept)
        self.build(1)
        shutil.copy2(kept, old)
        self.build(2)

    def test_a_header_that_is_as_it_was_comes_from_the_cache(self):
        self.build(0)
        self.build(1)
        self.build(0)
        counts = subprocess.run([CCACHE, "--print-stats"], env=self.environment, capture_output=True, text=True,
                                check=True).stdout
        hits = sum(int(line.split()[1]) for line in counts.splitlines() if line.endswith(tuple("123456789"))
                   and line.split()[0] in ("direct_cache_hit", "preprocessed_cache_hit"))
        self.assertGreaterEqual(hits, 1, counts)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
