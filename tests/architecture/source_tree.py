# SPDX-License-Identifier: BSD-3-Clause
"""The C++ files of a repository, and what each includes."""
import os
import re
from collections import namedtuple

import modules

Include = namedtuple("Include", "line spelled target")  # target: the repository's file, or None for another project's

_DIRECTIVE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)
_COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)


def without_comments(text):
    """The text with comments blanked out; lines stay where they are, strings stay as they are."""
    def blank(match):
        found = match.group()
        return found if found.startswith('"') else re.sub(r"[^\n]", " ", found)
    return _COMMENT_OR_STRING.sub(blank, text)


class SourceTree:
    """All .h and .cpp files below the products' folders of `root`."""

    def __init__(self, root):
        self.root = root
        self.files = sorted(self._find())
        self._roots = [r for r in self._include_roots() if os.path.isdir(os.path.join(root, r))]
        self._code = {}
        self._includes = {}

    def _find(self):
        for product in modules.INCLUDE_ROOTS:
            for folder, _, names in os.walk(os.path.join(self.root, product)):
                for name in names:
                    if name.endswith((".h", ".cpp")):
                        yield os.path.relpath(os.path.join(folder, name), self.root)

    def _include_roots(self):
        yield from (f"{module}/include" for module in modules.USES)
        yield from modules.INCLUDE_ROOTS

    def code(self, path):
        """The file's text without comments."""
        if path not in self._code:
            with open(os.path.join(self.root, path), encoding="utf-8") as source:
                self._code[path] = without_comments(source.read())
        return self._code[path]

    def includes(self, path):
        if path not in self._includes:
            code = self.code(path)
            self._includes[path] = [Include(code.count("\n", 0, match.start()) + 1, match.group(2),
                                            self._resolve(path, *match.groups()))
                                    for match in _DIRECTIVE.finditer(code)]
        return self._includes[path]

    def _resolve(self, path, quote, spelled):
        own_product = path.split("/")[0]
        folders = [os.path.dirname(path)] if quote == '"' else []
        # Every product's root is an include root of its own: the nearest file of that name is meant.
        folders += sorted(self._roots, key=lambda root: root.split("/")[0] != own_product)
        for folder in folders:
            candidate = os.path.normpath(os.path.join(folder, spelled))
            if os.path.isfile(os.path.join(self.root, candidate)):
                return candidate
        return None


def unit_of(path):
    """x.h and x.cpp are one unit."""
    return os.path.splitext(path)[0]
