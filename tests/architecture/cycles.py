# SPDX-License-Identifier: BSD-3-Clause
"""No units (x.h with x.cpp) include each other in a circle, and no modules use each other in a circle."""
from modules import USES
from problem import Problem
from source_tree import unit_of


def check(tree):
    units = {unit_of(path): set() for path in tree.files}
    for path in tree.files:
        for include in tree.includes(path):
            if include.target and unit_of(include.target) != unit_of(path):
                units[unit_of(path)].add(unit_of(include.target))
    for cycle in cycles(units):
        yield Problem(cycle[0], cycle[0], f"{len(cycle)} units include each other in a circle: {', '.join(cycle)}")
    for cycle in cycles(USES):
        yield Problem(cycle[0], "modules.py", f"modules use each other in a circle: {', '.join(cycle)}")


def cycles(graph):
    """The strongly connected components of more than one node, each sorted."""
    reachable = {node: _reachable(graph, node) for node in graph}
    found = {tuple(sorted(other for other in reachable[node] if node in reachable[other]))
             for node in graph if node in reachable[node]}
    return sorted(component for component in found if len(component) > 1)


def _reachable(graph, start):
    """What a path of one step or more leads to."""
    seen, todo = set(), list(graph[start])
    while todo:
        node = todo.pop()
        if node not in seen:
            seen.add(node)
            todo += graph.get(node, ())  # a file that is no unit includes nothing that counts
    return seen
