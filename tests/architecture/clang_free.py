# SPDX-License-Identifier: BSD-3-Clause
"""No file of a module that is to be free of Clang reaches a header of Clang or LLVM, through any chain of includes."""
import re

from modules import CLANG_FREE, FOREIGN, module_of
from problem import Problem


def check(tree):
    for path in tree.files:
        if module_of(path) in CLANG_FREE:
            chain = _chain_to_clang(tree, path)
            if chain:
                yield Problem(module_of(path), path, "reaches Clang: " + " -> ".join(chain))


def _chain_to_clang(tree, start):
    chains, seen = [[start]], {start}
    while chains:
        chain = chains.pop()
        for include in tree.includes(chain[-1]):
            if re.match(FOREIGN["Clang"][0], include.spelled):
                return chain + [include.spelled]
            if include.target and include.target not in seen:
                seen.add(include.target)
                chains.append(chain + [include.target])
    return None
