# SPDX-License-Identifier: BSD-3-Clause
"""A public header, one that is installed as <tzc/...>, lies in its module's include/tzc/ and includes no private one."""
import re

from modules import USES
from problem import Problem

_PUBLIC = re.compile(r"(.*)/include/tzc/(.*)$")


def check(tree):
    homes = {}
    for path in tree.files:
        public = _PUBLIC.match(path)
        if not public:
            continue
        module, name = public.groups()
        if module not in USES:
            yield Problem(path, path, f"a public header outside of a module: {module} is none")
        if name in homes:
            yield Problem(path, path, f"<tzc/{name}> is a header of {homes[name]}, too")
        homes[name] = module
        for include in tree.includes(path):
            if include.target and not _PUBLIC.match(include.target):
                yield Problem(path, f"{path}:{include.line}", f"includes {include.spelled}, which is not installed")
