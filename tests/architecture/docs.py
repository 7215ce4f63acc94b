# SPDX-License-Identifier: BSD-3-Clause
"""Every relative link of a page leads to a file, every page of docs/ is linked, decisions and diagnostics pages have their
form, every path in backticks exists, and docs/architecture.md has the modules of modules.py."""
import glob
import os
import re

from modules import USES
from problem import Problem

ARCHITECTURE = "docs/architecture.md"

_LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
_PATH = re.compile(r"`((?:runtime|msggen|rewriter|bench|compare|monitor|tests|docs|scripts|cmake|samples)/(?!.*nnnn)[\w/{},-]+\.[\w./{},-]+)`")
_DECISION = re.compile(r"# \d{3}: .+\n\nStatus: (accepted|superseded by \d{3})\n\n## Context\n.+\n## Decision\n.+\n## Consequences\n.+",
                       re.S)
_DIAGNOSTIC = re.compile(r"# TZC\d{4} [a-z-]+: .+\n\n## Cause\n.+\n## Why it matters\n.+\n## Fix\n.+", re.S)


def check(tree):
    pages = {path: _read(tree.root, path) for path in _pages(tree.root)}
    linked = set()
    for path, text in pages.items():
        for target in _LINK.findall(text):
            resolved = os.path.normpath(os.path.join(os.path.dirname(path), target))
            linked.add(resolved)
            if not os.path.exists(os.path.join(tree.root, resolved)):
                yield Problem(path, path, f"links to {target}, which does not exist")
        for named in _PATH.findall(text):
            for one in _expanded(named):
                if not os.path.exists(os.path.join(tree.root, one)):
                    yield Problem(path, path, f"names {one}, which does not exist")
    for path, text in pages.items():
        if path.startswith("docs/") and not _is_linked(path, linked):
            yield Problem(path, path, "no page links to it: add it to README.md or to the index of its folder")
        for folder, form in (("docs/decisions/", _DECISION), ("docs/diagnostics/", _DIAGNOSTIC)):
            if path.startswith(folder) and not path.endswith("/README.md") and not form.match(text):
                yield Problem(path, path, f"has not the form of its neighbours, see {folder}README.md")
    if ARCHITECTURE in pages:
        yield from _module_table(pages[ARCHITECTURE])


def _module_table(text):
    rows = {module: used for module, used in re.findall(r"^\| `([a-z_/]+)` \| .+ \| (.*?) ?\|$", text, re.M)}
    for module in sorted(set(USES) | {row for row in rows if "/" in row}):
        expected = ", ".join(name[len(module.split("/")[0]) + 1:] if name.split("/")[0] == module.split("/")[0] and "/" in name
                             else name for name in USES.get(module, []))
        if rows.get(module) != expected or module not in USES:
            yield Problem(module, ARCHITECTURE, f"the row of {module} must say that it may use: {expected or 'nothing'}")


def _expanded(path):
    """The paths of `dir/name.{h,cpp}`."""
    before, brace, rest = path.partition("{")
    if not brace:
        return [path]
    inside, _, after = rest.partition("}")
    return [before + choice + after for choice in inside.split(",")]


def _pages(root):
    found = glob.glob(f"{root}/*.md") + glob.glob(f"{root}/docs/**/*.md", recursive=True)
    return sorted(os.path.relpath(path, root) for path in found)


def _read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def _is_linked(path, linked):
    folder, name = os.path.split(path)
    return path in linked or (name == "README.md" and folder in linked)
