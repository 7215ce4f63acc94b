# SPDX-License-Identifier: BSD-3-Clause
"""Every setting of the runtime has its row in docs/configuration.md, with its variable, and every row is a setting; tzc-bench refuses
each variable that stands there."""
import os
import re

from problem import Problem

TABLE, PAGE, BENCH = "runtime/roscpp/settings.cpp", "docs/configuration.md", "bench/environment.cpp"

_SETTING = re.compile(r'^\s*\{"(\w+)",\s*(?:nullptr|"\w+")', re.M)
_VARIABLE = re.compile(r"\bTZC_[A-Z_]+\b")
_ROW = re.compile(r"^\| `(\w+)` \| `(\w+)` \|", re.M)


def check(tree):
    settings = _SETTING.findall(tree.code(TABLE))
    with open(os.path.join(tree.root, PAGE), encoding="utf-8") as file:
        page = file.read()
    rows = dict(_ROW.findall(page))
    for name in sorted(set(_VARIABLE.findall(page)) ^ set(_VARIABLE.findall(tree.code(BENCH)))):
        yield Problem(name, BENCH, f"{name} must stand here and on {PAGE}, or on neither")
    if not settings:
        yield Problem(TABLE, TABLE, "no setting was found: has the form of the table changed?")
    for name in sorted(set(settings) - set(rows)):
        yield Problem(name, PAGE, f"no row describes the setting {name}")
    for name in sorted(set(rows) - set(settings)):
        yield Problem(name, PAGE, f"{name} is not a setting of {TABLE}")
    for name in sorted(set(settings) & set(rows)):
        if rows[name] != f"TZC_{name.upper()}":
            yield Problem(name, PAGE, f"the variable of {name} is TZC_{name.upper()}, not {rows[name]}")
