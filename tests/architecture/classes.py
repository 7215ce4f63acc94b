# SPDX-License-Identifier: BSD-3-Clause
"""No class has more than 20 methods or 12 data members.

A method is what the class's body declares, an overload each; constructors, the destructor, and what is deleted or
defaulted are not counted. A static data member is not counted.
"""
import re

import ctags
from problem import Problem

MAX_METHODS, MAX_DATA_MEMBERS = 20, 12


def check(tree):
    tags = ctags.tags(tree)
    by_file = {}
    for tag in tags:
        by_file.setdefault(tag.path, []).append(tag)
    for one in (tag for tag in tags if tag.kind in ("class", "struct")):
        name = ctags.full_name(one)
        body = [tag for tag in by_file[one.path] if tag.scope == name and one.line <= tag.line <= one.end]
        methods = sum(_is_method(tag, one.name) for tag in body)
        data = sum(tag.kind == "member" and not re.search(r"\bstatic\b", tag.text) for tag in body)
        if methods > MAX_METHODS:
            yield Problem(f"{name} methods", f"{one.path}:{one.line}", f"{name} has {methods} methods, {MAX_METHODS} are allowed")
        if data > MAX_DATA_MEMBERS:
            yield Problem(f"{name} data", f"{one.path}:{one.line}",
                          f"{name} has {data} data members, {MAX_DATA_MEMBERS} are allowed")


def _is_method(tag, class_name):
    if tag.kind not in ("function", "prototype") or tag.name in (class_name, f"~{class_name}"):
        return False
    return not re.search(r"=\s*(delete|default)\s*;", tag.text)
