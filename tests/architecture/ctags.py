# SPDX-License-Identifier: BSD-3-Clause
"""The classes, members and functions of C++ files, as Universal Ctags sees them."""
import json
import re
import shutil
import subprocess
from collections import namedtuple

# scope: the enclosing classes and namespaces; text: the source line; end: the last line of a class or a body.
Tag = namedtuple("Tag", "path line end kind name scope signature text")

_ANONYMOUS = re.compile(r"__anon\w+::|(::)?__anon\w+")


def tags(tree):
    program = shutil.which("ctags-universal")
    if not program:
        raise SystemExit("ctags-universal was not found: install universal-ctags")
    command = [program, "--output-format=json", "--languages=C++", "--langmap=C++:.h.cpp", "--kinds-C++=cfmps",
               "--fields=+neSsZ", "--pattern-length-limit=0", "-f", "-", "-L", "-"]
    result = subprocess.run(command, cwd=tree.root, input="\n".join(tree.files), stdout=subprocess.PIPE, text=True,
                            check=True)
    return [_tag(tree, json.loads(line)) for line in result.stdout.splitlines()]


def _tag(tree, entry):
    line = entry["line"]
    return Tag(entry["path"], line, entry.get("end", line), entry["kind"], entry["name"],
               _ANONYMOUS.sub("", entry.get("scope", "")), entry.get("signature", "()"),
               tree.code(entry["path"]).splitlines()[line - 1])


def full_name(tag):
    return f"{tag.scope}::{tag.name}" if tag.scope else tag.name


def parameters(signature):
    """The parameters of a signature like "(int a, std::map<int, int> b = {1, 2}) const"."""
    inside = signature[signature.index("(") + 1:signature.rindex(")")]
    parts, depth, start = [], 0, 0
    for at, c in enumerate(inside):
        arrow = inside[at - 1:at + 1] == "->"
        depth += (c in "(<[{") - (c in ")>]}" and not arrow)
        if c == "," and depth == 0:
            parts.append(inside[start:at])
            start = at + 1
    parts.append(inside[start:])
    return [part.strip() for part in parts if part.strip() not in ("", "void")]
