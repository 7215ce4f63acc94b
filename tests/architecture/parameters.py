# SPDX-License-Identifier: BSD-3-Clause
"""No function has more than 7 parameters, and few functions of the rewriter have 5 or more."""
import ctags
from problem import Problem

MAX_PARAMETERS = 7
MANY, MAX_WITH_MANY = 5, 8


def check(tree):
    functions = _functions(tree)
    for (_, _, name), tag in functions.items():
        count = len(ctags.parameters(tag.signature))
        if count > MAX_PARAMETERS:
            yield Problem(name, f"{tag.path}:{tag.line}", f"{name} has {count} parameters, {MAX_PARAMETERS} are allowed")
    with_many = sorted(f"{name} ({tag.path}:{tag.line})" for (product, _, name), tag in functions.items()
                       if product == "rewriter" and len(ctags.parameters(tag.signature)) >= MANY)
    if len(with_many) > MAX_WITH_MANY:
        yield Problem("rewriter", "rewriter", f"{len(with_many)} functions have {MANY} parameters or more, "
                      f"{MAX_WITH_MANY} are allowed: " + ", ".join(with_many))


def _functions(tree):
    """(product, types of parameters, name) -> tag: a function is counted once, declared and defined."""
    found = {}
    for tag in ctags.tags(tree):
        if tag.kind in ("function", "prototype"):
            count = len(ctags.parameters(tag.signature))
            found.setdefault((tag.path.split("/")[0], count, ctags.full_name(tag)), tag)
    return found
