# SPDX-License-Identifier: BSD-3-Clause
"""Ports random programs and shows that they still do the same.

    run_fuzz.py CONFIG.json FOLDER [--seed N] [--programs N] [--first N] [--only N,N] [--batch N] [--adversarial]

Of every batch of programs (one package): tzc-rewrite ports it; original and port are compiled against the real roscpp,
image_transport, cv_bridge and PCL; both run under a roscore; every message that subscribers and a recorder get is
equal. No site stays on TCPROS. A second tzc-rewrite --apply changes nothing and reports the
same sites. A failing batch stays in FOLDER; the exit
status is 1.
"""
import argparse
import collections
import json
import os
import re
import resource
import shutil
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from execution import differences, execute, shared_messages  # noqa: E402
from grammar import package  # noqa: E402
from port import check_levels, check_sites, contents, lasting_sites, rewrite  # noqa: E402
from toolchain import Failure, Toolchain  # noqa: E402


class Batch:
    def __init__(self, options, toolchain, folder, indices):
        self.options, self.toolchain, self.folder = options, toolchain, folder
        self.programs = [package.make_program(options.seed, index, options.adversarial) for index in indices]
        self.before, self.after = f"{folder}/before/fuzz_nodes", f"{folder}/after/fuzz_nodes"
        self.seconds = collections.Counter()

    def timed(self, what, function, *arguments):
        begin = time.monotonic()
        try:
            return function(*arguments)
        finally:
            self.seconds[what] += time.monotonic() - begin

    def run(self):
        """(sites, messages, messages through shared memory)"""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.sources = package.write_package(self.before, self.programs)
        sites = self.timed("port", self.port)
        self.timed("port again", self.port_again, sites)
        precompiled = self.timed("precompile", self.toolchain.precompiled, f"{self.options.folder}/precompiled")
        programs = [self.timed("compile", self.toolchain.build, folder, f"{self.folder}/{name}/build", self.sources,
                               precompiled,
                               name == "after") for name, folder in (("before", self.before), ("after", self.after))]
        topics = [topic.name for program in self.programs for topic in program.topics]
        runs = [(programs[0], "before/run", False), (programs[1], "after/run", False)]
        if self.options.guard:
            runs.append((programs[1], "after/guard", True))
        logs = [self.timed("run", execute, program, self.toolchain.config["recorder"], f"{self.folder}/{folder}", topics,
                           guard)
                for program, folder, guard in runs]
        different = [line for log in logs[1:] for line in differences(logs[0], log)]
        if different:
            raise Failure("messages differ before and after:\n" + "\n".join(different))
        return sites, sum(map(len, logs[1].values())), shared_messages(f"{self.folder}/after/run")

    def port(self):
        self.toolchain.write_commands(self.before, f"{self.folder}/before/build", self.sources)
        report = rewrite(self.toolchain.config, f"{self.folder}/before/build", self.before,
                         f"{self.folder}/report.json",
                         ["--out-dir", f"{self.folder}/after"])
        check_sites(self.before, report)
        check_levels(report, may_be_plain=self.options.adversarial)
        return report["sites"]

    def port_again(self, sites):
        self.toolchain.write_commands(self.after, f"{self.folder}/after/build", self.sources)
        once = contents(self.after)
        again = rewrite(self.toolchain.config, f"{self.folder}/after/build", self.after, f"{self.folder}/again.json",
                        ["--apply", "--force"])
        changed = [path for path, text in contents(self.after).items() if text != once.get(path)]
        if changed or again["summary"]["files_changed"] != 0:
            raise Failure("a second run of tzc-rewrite changes the port again: " + ", ".join(changed))
        lost = sorted(set(lasting_sites(sites)) ^ set(lasting_sites(again["sites"])))
        if lost:
            raise Failure("a second run reports other sites:\n" + "\n".join(map(str, lost[:10])))

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


def table(sites):
    """kind -> level -> count"""
    levels = collections.defaultdict(collections.Counter)
    for site in sites:
        levels[site["kind"]][site["level"]] += 1
    return "\n".join(f"  {kind:10}" + ", ".join(f"{count} {level}" for level, count in levels[kind].most_common())
                     for kind in sorted(levels))


def share(counts):
    return f"{counts['zero_copy']}/{sum(counts.values()) - counts['not_needed']}"


def levels_by_trait(levels):
    """How many sites of each pattern were ported to zero_copy: an attack on what is not ported tests nothing."""
    kinds = collections.defaultdict(list)
    for trait in sorted(levels):
        kind, name = trait.split(": ")
        kinds[kind].append(f"{name} {share(levels[trait])}")
    return "\n".join(f"  {kind:10}" + ", ".join(names) for kind, names in kinds.items())


def zero_copy_share(sites):
    counts = collections.Counter(site["level"] for site in sites if site["kind"] == "publish")
    needed = sum(counts.values()) - counts["not_needed"]
    return f"  zero_copy {counts['zero_copy']} of {needed} publish sites" + (
        f": {100 * counts['zero_copy'] // needed} %" if needed else "")


def remarks(sites):
    codes = collections.Counter(site["code"] for site in sites if site["kind"] == "publish" and site["code"])
    return "  remarks   " + ", ".join(f"{count} {code}" for code, count in codes.most_common())


def again(options, failure, indices):
    """The command that repeats a failure: with the programs that it names, otherwise with the whole batch."""
    named = sorted({int(number) for number in re.findall(r"\bp(\d{3,})\b", str(failure))} & set(indices))
    switches = "".join(f" --{name}" for name in ("adversarial", "guard") if getattr(options, name))
    programs = ",".join(map(str, named or indices))
    return (f"{sys.executable} {' '.join(sys.argv[:3])} --keep{switches} --seed {options.seed} --only {programs}")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("config")
    parser.add_argument("folder")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--adversarial", action="store_true", help="programs that point into their messages")
    parser.add_argument("--programs", type=int, default=50)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", help="these programs alone, by number")
    parser.add_argument("--batch", type=int, default=50)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", action="store_true", help="keep the packages of batches that pass, too")
    parser.add_argument("--guard", action="store_true", help="run each port in guard mode, too: a late write is a failure")
    options = parser.parse_args()
    options.folder = os.path.realpath(options.folder)
    return options


def batches_of(options):
    if options.only:
        return [[int(number) for number in options.only.split(",")]]
    last = options.first + options.programs
    return [list(range(i, min(i + options.batch, last))) for i in range(options.first, last, options.batch)]


def main():
    options = parse_arguments()
    with open(options.config) as file:
        toolchain = Toolchain(json.load(file), options.jobs)
    sites, traits, messages, shared, failed, programs = [], collections.Counter(), 0, 0, 0, 0
    levels = collections.defaultdict(collections.Counter)
    for indices in batches_of(options):
        batch = Batch(options, toolchain, f"{options.folder}/seed-{options.seed}-{indices[0]}-{indices[-1]}", indices)
        name = f"seed {options.seed}, programs {indices[0]} to {indices[-1]}"
        try:
            some_sites, some_messages, some_shared = batch.run()
            sites, messages, shared = sites + some_sites, messages + some_messages, shared + some_shared
            traits += batch.traits()
            programs += len(batch.programs)
            for trait, counts in batch.levels(some_sites).items():
                levels[trait] += counts
            print(f"ok   {name}: " + ", ".join(f"{what} {taken:.0f} s" for what, taken in batch.seconds.items()),
                  flush=True)
            if not options.keep:
                shutil.rmtree(batch.folder)
        except (Failure, RuntimeError) as failure:
            failed += 1
            print(f"FAIL {name} ({batch.folder})\n{failure}\nagain: {again(options, failure, indices)}", flush=True)
    print(f"{programs} programs, {messages} messages compared, {shared} received through shared memory\n"
          f"{table(sites)}\n{zero_copy_share(sites)}\n{remarks(sites)}")
    if levels:
        print(levels_by_trait(levels))
    print("  patterns  " + ", ".join(f"{count} {trait}" for trait, count in traits.most_common()))
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"  processor {used.ru_utime + used.ru_stime:.0f} s")
    vacuous = not failed and shared == 0
    if vacuous:
        print("FAIL nothing went through shared memory")
    return 1 if failed or vacuous else 0


if __name__ == "__main__":
    sys.exit(main())
