#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails when clang-tidy 19 has something to say about a C++ file that is built. The checks are those of .clang-tidy.

Most of clang-tidy's time goes into headers, so files with the same compile flags are looked at together, as one
translation unit that includes them. Files that define one name twice (two helpers) do not come together; those that
do not compile together all the same are told apart by the errors. Those that the build compiles together are looked at
one by one: only then a missing #include is found. With the plugin own_declarations.cpp, clang-tidy does not look for
anything in system headers.

A clean file is not looked at again until its content, that of a header it includes from the repository or the build
folder, its compile command, the checks, clang-tidy, or the plugin changes: BUILD_FOLDER/tidy/ has a mark for each. Remove
the folder after an upgrade of other projects' headers. The repository has a list of such marks, too (--clean), so that a
fresh clone looks at what has changed since the list was made; --record makes it anew, from a look at everything.
"""
import argparse
import collections
import concurrent.futures
import functools
import hashlib
import json
import os
import re
import subprocess
import sys

from compile_flags import entries_of_files, flags_of, include_folders
from tree import cpp_files

_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.M)
_ERROR = re.compile(r"^(/[^:\n]+):\d+:\d+: error: .*\[clang-diagnostic-error", re.M)
# What begins a line and ends in a name and a bracket, as definitions in namespaces do. A second main gets another name.
_DEFINED = re.compile(rb"^(?!namespace |using )(?:(?:class|struct|union|enum class|enum) (\w+)[^;\n]*\{"
                      rb"|[A-Za-z][\w:<>,&* ]*[&* ](?!main\b)(\w+)(?:\(|\[| =|\{))", re.M)
_FILES_TOGETHER = 16
_NOT_LOOKED_AT = ("-W", "-O", "-g", "-fPIC", "-fPIE", "-ffile-prefix-map=")  # no check depends on them
_NOT_OURS = ["-Wno-enum-constexpr-conversion"]  # Clang 19 makes an error of what Boost's MPL does, GCC does not


class Headers:
    """What a file and all that it includes from some folders consist of."""

    def __init__(self, roots):
        self._roots = tuple(os.path.realpath(root) + os.sep for root in roots)
        self._files = {}
        self._file_at = functools.lru_cache(maxsize=None)(self._look_up)

    def digest(self, path, include_dirs):
        digest, seen, todo = hashlib.sha256(), {path}, [path]
        while todo:
            file = todo.pop()
            content, names = self._read(file)
            digest.update(content)
            for name in names:
                target = self._resolve(name, [os.path.dirname(file), *include_dirs])
                if target and target not in seen:
                    seen.add(target)
                    todo.append(target)
        return digest.hexdigest()

    def _read(self, path):
        if path not in self._files:
            with open(path, "rb") as file:
                text = file.read()
            self._files[path] = hashlib.sha256(text).digest(), [name.decode() for name in _INCLUDE.findall(text)]
        return self._files[path]

    def _resolve(self, name, folders):
        return next(filter(None, (self._file_at(folder, name) for folder in folders)), None)

    def _look_up(self, folder, name):
        path = os.path.realpath(os.path.join(folder, name))
        return path if path.startswith(self._roots) and os.path.isfile(path) else None


class Source:
    """A file that is built, and what it is looked at with."""

    def __init__(self, root, entry):
        self.path = os.path.realpath(entry["file"])
        self.folder = entry["directory"]
        self.flags = tuple(flag for flag in flags_of(entry) if not flag.startswith(_NOT_LOOKED_AT))
        self.alone = entry.get("together", False)
        self.configs = _configs(root, self.path)
        self.defines = frozenset(b"".join(names) for names in _DEFINED.findall(_content(self.path)))

    def group(self):
        """Sources of one group are compiled alike and checked alike."""
        return self.folder, self.flags, self.configs

    def key(self, headers, version, places):
        """The same wherever the repository and its build folder lie: `places` names both."""
        configs = b"".join(_content(config) for config in self.configs)
        content = headers.digest(self.path, include_folders(self.flags))
        command = repr((self.folder, self.flags, self.path))
        for folder, name in places:
            command = command.replace(folder, name)
        return hashlib.sha256(version + configs + command.encode() + content.encode()).hexdigest()


def _content(path):
    with open(path, "rb") as file:
        return file.read()


def _configs(root, path):
    """Every .clang-tidy from the file's folder up to the repository's."""
    found, folder, root = [], os.path.dirname(path), os.path.realpath(root)
    while folder.startswith(root):
        config = os.path.join(folder, ".clang-tidy")
        if os.path.exists(config):
            found.append(config)
        folder = os.path.dirname(folder)
    return tuple(found)


def _together(sources):
    """Parts of `sources`: none is long, none has two files that define the same name or one that is looked at alone."""
    parts = []
    for source in (source for source in sources if not source.alone):
        for part, names in parts:
            if len(part) < _FILES_TOGETHER and names.isdisjoint(source.defines):
                part.append(source)
                names |= source.defines
                break
        else:
            parts.append(([source], set(source.defines)))
    return [part for part, _ in parts] + [[source] for source in sources if source.alone]


def _version(program, plugin):
    """Of clang-tidy, without the processor that it names, and of the plugin."""
    said = subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True).stdout
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "own_declarations.cpp")
    return re.search(rb"version \S+", said).group() + (_content(beside) if plugin else b"")


class Tidy:
    def __init__(self, program, root, build, plugin=None, clean=frozenset()):
        self._root, self._build, self._clean = root, build, clean
        self._program = [program] + ([f"--load={plugin}"] if plugin else [])
        self._headers = Headers([root, build])
        self._version = _version(program, plugin)
        self._places = [(os.path.realpath(build), "BUILD"), (os.path.realpath(root), "ROOT")]  # the inner one first
        self._marks = os.path.join(build, "tidy")
        os.makedirs(self._marks, exist_ok=True)

    def batches(self, entries):
        """The sources that have no mark, those of a batch in one group."""
        groups = collections.defaultdict(list)
        for entry in entries:
            source = Source(self._root, entry)
            key = self.key(source)
            if key not in self._clean and not os.path.exists(os.path.join(self._marks, key)):
                groups[source.group()].append(source)
        return [part for sources in groups.values() for part in _together(sources)]

    def complaints(self, batch):
        """What clang-tidy says about the sources of a batch; "" when they are clean."""
        status, text = self._look_at(batch)
        if status == 0:
            for source in batch:
                _write(os.path.join(self._marks, self.key(source)), source.path + "\n")
            return ""
        if len(batch) == 1:
            return text
        apart = [source for source in batch if source.path in set(_ERROR.findall(text))]
        if apart and len(apart) < len(batch):
            return self.complaints([source for source in batch if source not in apart]) + self.complaints(apart)
        if "clang-diagnostic-error" in text:
            return "".join(self.complaints([source]) for source in batch)
        return text

    def _look_at(self, batch):
        """clang-tidy reads the file of includes as if it lay beside the first source, whose .clang-tidy it takes."""
        first = batch[0]
        if len(batch) == 1:
            return self._run(first, first.path)
        text = "".join(f'#define main main_{at}\n#include "{source.path}"\n#undef main\n' for at, source in enumerate(batch))
        name = hashlib.sha256(text.encode()).hexdigest()[:16]
        content = os.path.join(self._marks, f"{name}.cpp")
        seen_as = os.path.join(os.path.dirname(first.path), f"tidy_{name}.cpp")
        overlay = os.path.join(self._marks, f"{name}.json")
        _write(content, text)
        _write(overlay, json.dumps({"version": 0, "use-external-names": False, "roots": [
            {"name": seen_as, "type": "file", "external-contents": content}]}))
        try:
            return self._run(first, seen_as, f"--vfsoverlay={overlay}")
        finally:
            os.remove(content)
            os.remove(overlay)

    def _run(self, source, path, *options):
        result = subprocess.run([*self._program, "--quiet", *options, path, "--", *source.flags, *_NOT_OURS], text=True,
                                cwd=source.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        return result.returncode, result.stdout + _without_counts(result.stderr)

    def key(self, source):
        return source.key(self._headers, self._version, self._places)


def _write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _without_counts(text):
    return "".join(line for line in text.splitlines(True) if not re.match(r"\d+ warnings?( and \d+ errors?)? generated", line))


def entries(root, build, wanted):
    """The compile command of each file of the tree that is built, one a file."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        by_file = {os.path.realpath(entry["file"]): entry for entry in entries_of_files(json.load(file))}
    files = wanted or cpp_files(root)
    return [by_file[path] for path in (os.path.realpath(os.path.join(root, file)) for file in files) if path in by_file]


def read_keys(path):
    with open(path, encoding="utf-8") as file:
        return frozenset(line.split()[0] for line in file if not line.startswith("#"))


def write_keys(path, tidy, root, sources):
    rows = sorted((os.path.relpath(source.path, root), tidy.key(source)) for source in sources)
    _write(path, "# What clang-tidy has nothing to say about. Made by scripts/test.d/full/0-tidy.\n"
           + "".join(f"{key} {name}\n" for name, key in rows))


def main(*words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", type=os.path.abspath, help="a plugin that clang-tidy loads")
    lists = parser.add_mutually_exclusive_group()
    lists.add_argument("--clean", help="a list of what is clean, from --record")
    lists.add_argument("--record", help="look at everything, and write the list of what is clean to this file")
    parser.add_argument("clang_tidy")
    parser.add_argument("repository", type=os.path.abspath)
    parser.add_argument("build", type=os.path.abspath)
    parser.add_argument("files", nargs="*")
    asked = parser.parse_args(words)
    todo = entries(asked.repository, asked.build, asked.files)
    clean = read_keys(asked.clean) if asked.clean else frozenset()
    tidy = Tidy(asked.clang_tidy, asked.repository, asked.build, asked.plugin, clean)
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for text in pool.map(tidy.complaints, tidy.batches(todo)):
            bad += bool(text)
            print(text, end="", flush=True)
    print(f"{len(todo)} files, " + (f"not clean: {bad} groups of them" if bad else "clean"))
    if asked.record and todo and not bad:
        write_keys(asked.record, tidy, asked.repository, [Source(asked.repository, entry) for entry in todo])
    return 1 if bad or not todo else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
