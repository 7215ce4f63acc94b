# SPDX-License-Identifier: BSD-3-Clause
"""One package of generated programs, or two: written, ported, compiled, executed, compared."""
import collections
import os
import shutil

from copies import check_copies, mark_needless
from execution import differences, execute, shared_messages
from grammar import package
from port import check_levels, check_sites, contents, lasting_sites, rewrite
from summary import processor_seconds
from toolchain import Failure


class Batch:
    def __init__(self, options, toolchain, folder, indices):
        self.options, self.toolchain, self.folder = options, toolchain, folder
        self.programs = [package.make_program(options.seed, index, options.adversarial, options.siblings)
                         for index in indices]
        self.before, self.after = f"{folder}/before/src", f"{folder}/after/src"
        self.seconds = collections.Counter()  # of a processor

    def timed(self, what, function, *arguments):
        begin = processor_seconds()
        try:
            return function(*arguments)
        finally:
            self.seconds[what] += processor_seconds() - begin

    def run(self, twice):
        """(sites, messages, messages through shared memory)"""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.packages = package.write_packages(self.before, self.programs)
        folder = os.path.join(os.path.dirname(self.options.config), "precompiled")  # for all runs of a build folder
        self.precompiled = self.timed("precompile", self.toolchain.precompiled, folder)
        sites = self.timed("port", self.port)
        if twice:
            self.timed("port again", self.port_again, sites)
        logs = self.timed("run", self.execute, self.timed("compile", self.build))
        different = [line for log in logs[1:] for line in differences(logs[0], log)]
        if different:
            raise Failure("messages differ before and after:\n" + "\n".join(different))
        check_copies(sites, f"{self.folder}/after/run")
        mark_needless(sites, f"{self.folder}/after/run")
        return sites, sum(map(len, logs[1].values())), shared_messages(f"{self.folder}/after/run")

    def build(self):
        """The executables of the original and of the port."""
        return [self.toolchain.build(folder, f"{self.folder}/{name}/build", self.packages, self.precompiled,
                                     name == "after")
                for name, folder in (("before", self.before), ("after", self.after))]

    def execute(self, executables):
        """The logs of the original, of the port, and of the port in guard mode."""
        before, after = executables
        topics = [topic.name for program in self.programs for topic in program.topics]
        config = self.toolchain.config
        runs = [(before, "before/run", False, None), (after, "after/run", False, config["monitor"])]
        if self.options.guard:
            runs.append((after, "after/guard", True, None))
        return [execute(executable, config["recorder"], f"{self.folder}/{folder}", topics, guard, monitor)
                for executable, folder, guard, monitor in runs]

    def port(self):
        self.toolchain.write_commands(self.before, f"{self.folder}/before/build", self.packages, self.precompiled)
        report = rewrite(self.toolchain, f"{self.folder}/before/build", self.folders_in(self.before),
                         f"{self.folder}/report.json", ["--out-dir", self.after])
        check_sites(self.before, report)
        check_levels(report, may_be_plain=self.options.adversarial)
        return report["sites"]

    def port_again(self, sites):
        """Without precompiled headers, so that an include which the port lacks shows."""
        self.toolchain.write_commands(self.after, f"{self.folder}/after/build", self.packages)
        once = contents(self.after)
        again = rewrite(self.toolchain, f"{self.folder}/after/build", self.folders_in(self.after),
                        f"{self.folder}/again.json", ["--apply", "--force"])
        changed = [path for path, text in contents(self.after).items() if text != once.get(path)]
        if changed or again["files_changed"] != 0:
            raise Failure("a second run of tzc-rewrite changes the port again: " + ", ".join(changed))
        lost = sorted(set(lasting_sites(sites)) ^ set(lasting_sites(again["sites"])))
        if lost:
            raise Failure("a second run reports other sites:\n" + "\n".join(map(str, lost[:10])))

    def folders_in(self, source_space):
        return [f"{source_space}/{name}" for name in self.packages]

    def traits(self):
        return collections.Counter(trait for program in self.programs for trait in program.traits)

    def levels(self, sites):
        """trait -> level -> count, of what publishes"""
        traits = {topic.name: topic.traits for program in self.programs for topic in program.topics}
        levels = collections.defaultdict(collections.Counter)
        for site in sites:
            if site["kind"] == "publish":
                for trait in traits.get(site["topic"], ()):
                    levels[trait][site["level"]] += 1
        return levels
