# SPDX-License-Identifier: BSD-3-Clause
"""A module includes only what modules.py allows: its own files, modules below it, foreign headers that it may know."""
import re

from modules import FOREIGN, USES, module_of
from problem import Problem


def check(tree):
    for path in tree.files:
        module = module_of(path)
        if module is None:
            yield Problem(path, path, "lies in no module: add its folder to tests/architecture/modules.py")
            continue
        for include in tree.includes(path):
            for text in _problems(module, include):
                yield Problem(f"{path} -> {include.spelled}", f"{path}:{include.line}", text)


def _problems(module, include):
    if include.target:
        used = module_of(include.target)
        if used != module and used not in USES[module]:
            yield f"{module} must not use {used} ({include.spelled})"
        return
    for name, (pattern, allowed) in FOREIGN.items():
        if re.match(pattern, include.spelled) and module not in allowed:
            yield f"{module} must not know {name} ({include.spelled})"
