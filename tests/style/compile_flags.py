# SPDX-License-Identifier: BSD-3-Clause
"""What an entry of compile_commands.json says of the language, without the file, its output and its dependencies, and
without CMake's precompiled header: a file is to include what it uses."""
import os
import re
import shlex

_UNITY_FILE = re.compile(r"/Unity/unity_\d+_cxx\.cxx$")
_INCLUDED = re.compile(r'^#include "([^"]+)"', re.M)
_WITH_A_VALUE = {"-o", "-MF", "-MT", "-MQ"}
_ALONE = {"-c", "-MD", "-MMD", "-MP", "-Winvalid-pch", "-fpch-preprocess"}


def entries_of_files(entries):
    """An entry for each file that people write, in place of those for CMake's unity files, which include several. Its
    "together" tells whether it is compiled after another one."""
    for entry in entries:
        unity = entry["file"]
        if not _UNITY_FILE.search(unity):
            yield entry
            continue
        with open(unity, encoding="utf-8") as file:
            included = _INCLUDED.findall(file.read())
        for path in included:
            yield {**entry, "file": path, "command": entry["command"].replace(unity, path), "together": path != included[0]}


def flags_of(entry):
    words = iter(_without_compiler(shlex.split(entry["command"])))
    source, flags = os.path.realpath(os.path.join(entry["directory"], entry["file"])), []
    for word in words:
        if word in _WITH_A_VALUE:
            next(words, None)
        elif word == "-include":
            header = next(words, "")
            if os.path.basename(header) != "cmake_pch.hxx":
                flags += [word, header]
        elif word not in _ALONE and os.path.realpath(os.path.join(entry["directory"], word)) != source:
            flags.append(word)
    return tuple(flags)


def include_folders(flags):
    folders = [flag[2:] for flag in flags if flag.startswith("-I") and len(flag) > 2]
    return folders + [flags[at + 1] for at, flag in enumerate(flags[:-1]) if flag in ("-I", "-isystem")]


def _without_compiler(words):
    """A launcher (ccache) may stand before the compiler; options begin after both."""
    first_option = next((at for at, word in enumerate(words) if word.startswith("-")), len(words))
    return words[first_option:]
