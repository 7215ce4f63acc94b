# SPDX-License-Identifier: BSD-3-Clause
"""Golden cases for tests in Python: the grammar and the switch of golden_case.h."""
import os
import re

_MARK = re.compile(r"(?://|#)--- (.*)\n")


def updates_golden():
    """True while golden files are written instead of compared."""
    return os.environ.get("TZC_UPDATE_GOLDEN") == "1"


class GoldenCase:
    """A test case as one file: a head, named sections, and last the section `expected`. Bytes that are not UTF-8 stay as
    they are."""

    def __init__(self, path):
        self.path = path
        self.head, self.sections, self._input = "", {}, ""
        name = None
        with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
            for line in _lines(file.read()):
                if name != "expected":
                    self._input += line
                mark = _MARK.fullmatch(line)
                if mark:
                    name = mark.group(1)
                    self.sections[name] = ""
                elif name is None:
                    self.head += line
                else:
                    self.sections[name] += line
        if name != "expected":
            raise ValueError(f"{path}: the last section must be `--- expected`")
        self._expected = self.sections.pop("expected")

    def expected(self, actual):
        """What to compare `actual` with. While golden files are updated it is `actual`, and the file gets it."""
        if not updates_golden():
            return self._expected
        with open(self.path, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
            file.write(self._input + actual)
        return actual

    def write_sections(self, folder, names):
        """Writes each named section as a file of that name below the folder."""
        for name in names:
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
                file.write(self.sections[name])


def _lines(text):
    """The lines with their ends; only a newline ends one."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)
