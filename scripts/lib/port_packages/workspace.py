# SPDX-License-Identifier: BSD-3-Clause
"""A catkin workspace that is configured and built as far as it goes."""
import filecmp
import json
import os
import re
import shlex
import shutil
import subprocess
import xml.etree.ElementTree

from .command import run, tail
from .packages import with_users

TOPLEVEL = "cmake/toplevel.cmake"
PLACE = re.compile(r"(?:^|[\s(])([^\s():]+)/[^\s():/]+\.(?:txt|cmake):\d+")


def mirror(source, target):
    """Makes `target` a copy of `source`; files that are equal keep their times, so that little is built again."""
    os.makedirs(target, exist_ok=True)
    names = set(os.listdir(source))
    for name in set(os.listdir(target)) - names:
        remove(os.path.join(target, name))
    for name in names:
        before, after = os.path.join(source, name), os.path.join(target, name)
        if os.path.isdir(before) and not os.path.islink(before):
            if not os.path.isdir(after) or os.path.islink(after):
                remove(after)
            mirror(before, after)
        elif os.path.islink(before):
            remove(after)
            os.symlink(os.readlink(before), after)
        elif os.path.islink(after) or not os.path.isfile(after) or not filecmp.cmp(before, after, shallow=False):
            remove(after)
            shutil.copy2(before, after)
            os.utime(after)  # the copy is new, however old the source is


def remove(path):
    if os.path.isdir(path) and not os.path.islink(path):
        shutil.rmtree(path)
    elif os.path.lexists(path):
        os.remove(path)


class Workspace:
    def __init__(self, root, settings):
        self.root, self.settings = root, settings
        self.src, self.build, self.devel = (os.path.join(root, name) for name in ("src", "build", "devel"))
        self.log = os.path.join(os.path.dirname(root), "log", os.path.basename(root))
        self.env = dict(os.environ)
        prefixes = [os.path.join(settings.tzc, "devel"), os.environ.get("CMAKE_PREFIX_PATH", "")]
        self.env["CMAKE_PREFIX_PATH"] = ":".join(filter(None, prefixes))
        # What the port leaves as it is comes out of ccache: its paths are taken from the workspace on.
        self.env.setdefault("CCACHE_BASEDIR", os.path.abspath(root))
        self.env.setdefault("CCACHE_NOHASHDIR", "1")

    def fill(self, repository, packages):
        """Copies of the packages, in the repository's layout."""
        staged = os.path.join(self.root, "staged")
        remove(staged)
        for package in packages:
            shutil.copytree(os.path.join(repository, package.folder), os.path.join(staged, package.folder), symlinks=True,
                            ignore=shutil.ignore_patterns(".git"))
        self.adopt(staged)

    @property
    def commands(self):
        """The compile database."""
        return os.path.join(self.build, "compile_commands.json")

    @property
    def package_root(self):
        """Where the repository's top folder is; a repository that is a package itself lies below src."""
        alone = os.path.join(self.src, "package")
        return alone if os.path.isfile(os.path.join(alone, "package.xml")) else self.src

    def adopt(self, staged):
        """Makes the staged copies the sources of the workspace."""
        if os.path.isfile(os.path.join(staged, "package.xml")):
            os.makedirs(os.path.join(self.src, "package"), exist_ok=True)
            shutil.copy2(os.path.join(staged, "package.xml"), os.path.join(self.src, "package"))
        os.makedirs(self.src, exist_ok=True)
        top = os.path.join(self.src, "CMakeLists.txt")
        mirror(staged, self.package_root)
        if not os.path.lexists(top):
            os.symlink(os.path.join(self.settings.catkin, TOPLEVEL), top)
        remove(staged)

    def configure(self, packages):
        """Leaves out what CMake does not configure, and its users: {name: reason}."""
        left_out = {}
        while True:
            log = os.path.join(self.log, "configure.log")
            names = sorted(package.name for package in packages if package.name not in left_out)
            if not names:
                return left_out
            outcome = run(self.configure_command(names), log, env=self.env)
            if outcome.status == 0:
                return left_out
            culprit = self.culprit(packages, left_out, log)
            if culprit is None:
                raise RuntimeError(f"cannot be configured: {' '.join(tail(log))} ({log})")
            for name in with_users({culprit}, packages) - set(left_out):
                left_out[name] = self.reason(log) if name == culprit else f"needs {culprit}, which is left out"

    def configure_command(self, names):
        flags = {"CATKIN_DEVEL_PREFIX": self.devel, "CMAKE_INSTALL_PREFIX": os.path.join(self.root, "install"),
                 "CMAKE_BUILD_TYPE": self.settings.build_type, "CMAKE_EXPORT_COMPILE_COMMANDS": "ON",
                 "PYTHON_EXECUTABLE": "/usr/bin/python3", "CATKIN_WHITELIST_PACKAGES": ";".join(names),
                 "CATKIN_ENABLE_TESTING": "ON" if self.settings.tests else "OFF"}
        if shutil.which("ccache"):
            flags["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
        return ["cmake", "-G", "Ninja", "-S", self.src, "-B", self.build,
                *(f"-D{name}={value}" for name, value in flags.items())]

    def culprit(self, packages, left_out, log):
        """The package whose files the first error of CMake names."""
        with open(log, errors="replace") as file:
            text = file.read()
        for place in PLACE.findall(text[text.find("CMake Error"):]):
            folder = os.path.relpath(os.path.join(self.src, place), self.package_root)
            for package in packages:
                inside = package.folder == "." or (folder + "/").startswith(package.folder + "/")
                if inside and not folder.startswith("..") and package.name not in left_out:
                    return package.name
        return None

    def reason(self, log):
        with open(log, errors="replace") as file:
            text = file.read()
        error = text[text.find("CMake Error"):].split("\n\n")[0]
        return " ".join(" ".join(error.split()).split()[:40])

    def make(self, *targets, called=None, timeout=None):
        """Builds what can be built, whatever fails."""
        log = os.path.join(self.log, "-".join(("make", *([called] if called else targets))) + ".log")
        return run(["ninja", "-C", self.build, "-k", "0", f"-j{self.settings.jobs}", *targets], log, env=self.env,
                   timeout=timeout)

    def run_tests(self, packages, timeout):
        """Those of each package: catkin's target run_tests runs none as long as one test of the workspace cannot be built.
        Whether they ended in time."""
        listed = subprocess.run(["ninja", "-C", self.build, "-t", "targets", "all"], stdout=subprocess.PIPE, text=True)
        if listed.returncode != 0:
            raise RuntimeError(f"ninja does not list the targets of {self.build}")
        known = {line.split(":")[0] for line in listed.stdout.splitlines()}
        targets = known & {f"run_tests_{package.name}" for package in packages}
        remove(os.path.join(self.build, "test_results"))
        return not targets or not self.make(*sorted(targets), called="run_tests", timeout=timeout).timed_out

    def units(self):
        """{object file: whether it is there}, as CMake names it, the same in both versions."""
        with open(self.commands) as file:
            entries = json.load(file)
        return {output: os.path.exists(os.path.join(entry["directory"], output))
                for entry in entries for output in [self.output_of(entry)]}

    @staticmethod
    def output_of(entry):
        words = entry.get("arguments") or shlex.split(entry["command"])
        return entry.get("output") or words[words.index("-o") + 1]

    def artefacts(self):
        """Programs and libraries."""
        lib = os.path.join(self.devel, "lib")
        paths = {os.path.relpath(os.path.join(folder, name), lib) for folder, _, names in os.walk(lib) for name in names}
        return {path for path in paths if not path.startswith("python")}

    def test_results(self):
        """{(suite, test): passed}"""
        results = {}
        for folder, _, names in os.walk(os.path.join(self.build, "test_results")):
            for name in names:
                if name.endswith(".xml"):
                    results.update(read_results(os.path.join(folder, name)))
        return results


def read_results(path):
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except xml.etree.ElementTree.ParseError:
        return {(os.path.basename(path), "unreadable"): False}
    return {(case.get("classname", ""), case.get("name", "")): case.find("failure") is None and case.find("error") is None
            for case in root.iter("testcase")}
