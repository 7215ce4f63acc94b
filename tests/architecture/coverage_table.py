# SPDX-License-Identifier: BSD-3-Clause
"""The tables of tests/runtime/roscpp/README.md name tests that exist, and every class of tests there is named."""
import ast
import glob
import os
import re

from problem import Problem

FOLDER = "tests/runtime/roscpp"
_NAME = re.compile(r"`(?:([A-Z]\w*)\.)?(test_\w+)(\.\.\.)?`|`([A-Z]\w*)`")


def check(tree):
    table = f"{FOLDER}/README.md"
    with open(os.path.join(tree.root, table), encoding="utf-8") as file:
        rows = [line.split("|")[2] for line in file if line.count("|") >= 3]
    classes = _classes(os.path.join(tree.root, FOLDER))
    named = set()
    for row in rows:
        for text, found in _named(row, classes):
            named |= found
            if not found:
                yield Problem(text, table, f"there is no test {text}")
    for missing in sorted(set(classes) - named):
        yield Problem(missing, table, f"no row names the tests of class {missing}")


def _classes(folder):
    """Name -> names of the tests, of each class that has tests of its own."""
    found = {}
    for path in glob.glob(f"{folder}/test_*.py"):
        with open(path, encoding="utf-8") as file:
            for node in ast.walk(ast.parse(file.read())):
                if isinstance(node, ast.ClassDef):
                    tests = {item.name for item in node.body
                             if isinstance(item, ast.FunctionDef) and item.name.startswith("test_")}
                    if tests:
                        found[node.name] = tests
    return found


def _named(row, classes):
    """What a row names, each with the classes that have it. `Class.test_x...` stands for all that begin like that."""
    for owner, test, more, alone in _NAME.findall(row):
        if alone:
            yield alone, {alone} & set(classes)
            continue
        fits = [name for name, tests in classes.items() if owner in ("", name)
                and any(one == test or more and one.startswith(test) for one in tests)]
        yield f"{owner}.{test}".lstrip("."), set(fits)
