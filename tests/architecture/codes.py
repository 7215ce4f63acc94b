# SPDX-License-Identifier: BSD-3-Clause
"""Every diagnostic code is raised by the rewriter, has a page, and is raised by a test case; a retired one is not."""
import glob
import os
import re

from problem import Problem
from source_tree import without_comments

TABLE = "rewriter/model/codes.def"
_CODE = re.compile(r"TZC\d{4}")


def check(tree):
    table = _read(tree.root, TABLE)
    live = re.findall(r"^X\((TZC\d{4})", table, re.M)
    retired = [code for line in re.findall(r"^// Retired.*", table, re.M) for code in _CODE.findall(line)]
    raised, cases, pages = _raised(tree), _in_cases(tree.root), _pages(tree.root)
    for code in live:
        for missing, where in ((code not in raised, "nothing in the rewriter raises it"),
                               (code not in cases, "no test case raises it"),
                               (code not in pages, f"docs/diagnostics/{code}.md is missing")):
            if missing:
                yield Problem(code, code, where)
    for code in sorted(set(retired) & (set(live) | raised | pages)):
        yield Problem(code, code, "it is retired, but still raised, listed or described")
    for code in sorted((raised | pages) - set(live) - set(retired)):
        yield Problem(code, code, f"it is not in {TABLE}")


def _read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def _raised(tree):
    """What is raised: the report shows codes and sorts them, so what it names does not count."""
    return {code for path in tree.files if path.startswith("rewriter/") and not path.startswith("rewriter/report/")
            for code in re.findall(r"\bcodes::(TZC\d{4})", tree.code(path))}


def _in_cases(root):
    """What the golden cases expect, and what other tests of the rewriter name in their code."""
    found = set()
    for path in glob.glob(f"{root}/tests/rewriter/**/*", recursive=True):
        if re.search(r"/cases/.*\.(cpp|case)$", path):
            found |= set(_CODE.findall(_read("", path).partition("--- expected\n")[2]))
        elif path.endswith("_test.cpp"):
            found |= set(_CODE.findall(without_comments(_read("", path))))
    return found


def _pages(root):
    return {code for path in glob.glob(f"{root}/docs/diagnostics/*.md") for code in _CODE.findall(os.path.basename(path))}
