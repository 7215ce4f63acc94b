#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs one check of the architecture over a repository. It fails on a problem that exceptions.txt does not name, and
on an exception that is no longer needed.

usage: check.py CHECK REPOSITORY      where CHECK.py is a module of this folder
"""
import importlib
import os
import sys

from problem import judge, read_exceptions
from source_tree import SourceTree

CHECKS = ["includes", "cycles", "clang_free", "classes", "parameters", "codes", "public_headers", "docs",
          "coverage_table", "settings", "package_xml"]
HERE = os.path.dirname(os.path.abspath(__file__))


def main(name, root):
    if name not in CHECKS:
        raise SystemExit(f"no check '{name}': one of {', '.join(CHECKS)}")
    tree = SourceTree(root)
    with open(os.path.join(HERE, "exceptions.txt"), encoding="utf-8") as file:
        granted = read_exceptions(file).get(name, {})
    complaints = list(judge(importlib.import_module(name).check(tree), granted))
    print("\n".join(complaints) or f"{name}: {len(tree.files)} files, {len(granted)} exceptions")
    return 1 if complaints or not tree.files else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    sys.exit(main(*sys.argv[1:]))
