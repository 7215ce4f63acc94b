# SPDX-License-Identifier: BSD-3-Clause
"""One repository: built, ported, built again, tested and compared. Each step says what failed and lets the others go on."""
import functools
import json
import os
import shutil
import sys

from rewriter_speed import megabytes, processor_seconds, units_of

from .command import run, tail
from .kept import Kept, digest_of
from .packages import find_packages
from .sites import summary_of
from .workspace import Workspace, remove

LENIENT_STATUS = (0, 1)  # of tzc-rewrite: nothing or something is left


class Repository:
    def __init__(self, name, folder, settings):
        self.name, self.folder, self.settings = name, folder, settings
        self.out = os.path.join(settings.out, name)
        self.original, self.ported = (Workspace(os.path.join(self.out, which), settings) for which in ("original", "ported"))
        self.result = {"name": name, "problems": []}
        self.packages = []

    @functools.cached_property
    def depends(self):
        """What its result depends on."""
        return [self.folder, self.settings.key, self.settings.runtime, digest_of(self.folder, *filter(None, [self.arguments()]))]

    def saved(self):
        """The result of an earlier run that depends on the same and had no problem (a full disk may have been one); or None."""
        try:
            with open(os.path.join(self.out, "result.json")) as file:
                result = json.load(file)
        except (OSError, ValueError):
            return None
        return result if result.get("depends") == self.depends and not result["problems"] else None

    def run(self):
        self.result["depends"] = self.depends
        if self.settings.inputs and not self.arguments():
            self.say(f"its runs are not compared: {self.settings.inputs} has no {self.name}.args")
        for step in (self.build_original, self.port, self.build_port, self.measure, self.test, self.compare):
            self.say(step.__name__.replace("_", " "))
            try:
                step()
            except (RuntimeError, OSError) as error:
                self.problem(f"{step.__name__.replace('_', ' ')}: {error}")
                break
        temporary = os.path.join(self.out, "result.json.new")
        os.makedirs(self.out, exist_ok=True)
        with open(temporary, "w") as file:
            json.dump(self.result, file, indent=1)
        os.replace(temporary, os.path.join(self.out, "result.json"))
        return self.result

    def say(self, text):
        print(f"{self.name}: {text}", file=sys.stderr, flush=True)

    def problem(self, text):
        self.say(text)
        self.result["problems"].append(text)

    def build_original(self):
        self.packages, left_out = find_packages(self.folder, self.settings.only)
        if self.packages:
            self.original.fill(self.folder, self.packages)
            left_out.update(self.original.configure(self.packages))
        self.packages = [package for package in self.packages if package.name not in left_out]
        self.result.update(packages=[package.name for package in self.packages], left_out=left_out)
        if not self.packages:
            raise RuntimeError("no package could be configured")
        self.result["build_status"] = self.original.make().status
        units = self.original.units()
        self.result.update(units=len(units), compiled=sum(units.values()))

    def port(self):
        """A dry run, so that nothing but the diff tells the versions apart; then the diff."""
        diff = os.path.join(self.out, "port.diff")
        compiled = sorted(unit for unit, is_there in self.original.units().items() if is_there)
        kept = Kept(os.path.join(self.out, "rewriting.json"),
                    [self.settings.key, compiled, digest_of(self.original.package_root, self.original.commands)])
        found = kept.read() if os.path.exists(diff) and not self.settings.again else None
        if found:
            self.say("has been rewritten already")
        else:
            kept.forget()  # the diff of an interrupted rewriting is none
            found = self.rewrite(diff)
            kept.write(found)
        for problem in found.pop("problems"):
            self.problem(problem)
        self.result.update(found)
        self.apply(diff)

    def rewrite(self, diff):
        report, log = (os.path.join(self.out, name) for name in ("report.json", "log/rewrite.log"))
        remove(report)
        env = dict(self.original.env, GIT_CEILING_DIRECTORIES=self.original.root)
        command = [os.path.join(self.settings.tzc, "bin/tzc-rewrite"), "-p", self.original.build, "--no-cache",
                   "-j", str(self.settings.jobs), "--report", report, *self.settings.options, *(package.folder for package in self.packages)]
        outcome = run(command, log, cwd=self.original.package_root, env=env, output=diff)
        found = {"rewrite_seconds": outcome.seconds, "rewrite_wall": outcome.wall}
        with open(log, errors="replace") as file:
            said = file.read()
        if "processor time" in said:
            found["own_seconds"], _ = processor_seconds(said)
            found["megabytes"] = megabytes(said)
        found["problems"] = [line.strip() for line in said.splitlines() if "error:" in line and line.startswith("tzc-rewrite")]
        if outcome.status not in LENIENT_STATUS and not found["problems"]:
            raise RuntimeError(f"tzc-rewrite ended with {outcome.status}: {' '.join(tail(log))}")
        if os.path.exists(report):
            found["sites"] = summary_of(report)
        return found

    def apply(self, diff):
        staged = os.path.join(self.ported.root, "staged")
        remove(staged)
        os.makedirs(self.ported.root, exist_ok=True)
        shutil.copytree(self.original.package_root, staged, symlinks=True)
        if self.original.package_root == self.original.src:
            remove(os.path.join(staged, "CMakeLists.txt"))  # catkin's, not the repository's
        patch = ["patch", "-p1", "--no-backup-if-mismatch", "-d", staged, "-i", diff]
        log = os.path.join(self.out, "log/patch.log")
        if os.path.getsize(diff) and run(patch, log).status != 0:
            raise RuntimeError(f"its own diff does not apply: {' '.join(tail(log))}")
        self.ported.adopt(staged)

    def build_port(self):
        for name, reason in self.ported.configure(self.packages).items():
            self.problem(f"the port of {name} cannot be configured: {reason}")
        self.ported.make()
        before, after = self.original.units(), self.ported.units()
        lost = sorted(unit for unit, compiled in before.items() if compiled and not after.get(unit))
        missing = sorted(self.original.artefacts() - self.ported.artefacts())
        self.result.update(compiled_after=sum(after.values()), lost_units=lost, lost_artefacts=missing)
        for what in lost + missing:
            self.problem(f"built before and not after: {what}")

    def measure(self):
        """The compiler's syntax check of the units that were ported, on one processor after the other."""
        if not self.settings.speed:
            return
        folders = [os.path.join(self.original.package_root, package.folder) for package in self.packages]
        log, seconds, checked = os.path.join(self.out, "log/syntax.log"), 0, 0
        for folder, command in units_of(self.original.build, folders):
            outcome = run(command, log, cwd=folder)
            seconds, checked = seconds + outcome.seconds, checked + 1
        self.result.update(syntax_seconds=seconds, syntax_units=checked)

    def test(self):
        if not self.settings.tests:
            return
        results, stopped = {}, []
        for version, workspace in (("before", self.original), ("after", self.ported)):
            built = workspace.make("tests", timeout=self.settings.timeout)
            if built.timed_out or not workspace.run_tests(self.packages, self.settings.timeout):
                stopped.append(version)
            results[version] = workspace.test_results()
            self.result[f"tests_{version}"] = [sum(results[version].values()), len(results[version])]
        for version in stopped:
            self.problem(f"the tests {version} the port were stopped after {self.settings.timeout:g} s: a longer --timeout "
                         "lets them end")
        # What a stopped run has not come to says nothing of the port.
        missing = "after" in stopped
        broken = [test for test, passed in results["before"].items() if passed and not results["after"].get(test, missing)]
        self.result["broken_tests"] = sorted(" ".join(test) for test in broken)
        for test in self.result["broken_tests"]:
            self.problem(f"test passed before and not after: {test}")

    def arguments(self):
        """The file of tzc-compare's arguments; None: there is none."""
        path = self.settings.inputs and os.path.join(self.settings.inputs, f"{self.name}.args")
        return path if path and os.path.exists(path) else None

    def compare(self):
        if not self.arguments():
            return
        with open(self.arguments()) as file:
            words = [line.strip().replace("{inputs}", self.settings.inputs) for line in file if line.strip()]
        log = os.path.join(self.out, "log/compare.log")
        # Guard mode ends a node that writes to what it has published, so that its messages are missed.
        outcome = run([os.path.join(self.settings.tzc, "bin/tzc-compare"), self.original.root, self.ported.root, *words],
                      log, env=dict(os.environ, TZC_GUARD="abort"), timeout=self.settings.timeout)
        self.result["compare"] = {0: "equal", 1: "different"}.get(outcome.status, "error")
        if outcome.status != 0:
            self.problem(f"tzc-compare: {self.result['compare']}: {' '.join(tail(log))}")
