# SPDX-License-Identifier: BSD-3-Clause
"""Measures tzc-rewrite against the compiler.

    rewriter_speed.py [--rounds N] [--jobs N] [--limit FACTOR] REWRITE BUILD PACKAGE...

In turns: tzc-rewrite, which only reports, and clang++-19 -fsyntax-only over the same units, with the same flags on as
many cores. Prints processor and wall time of each round and the ratio of the medians; the exit status is 1 when one of
them is above the limit.
"""
import argparse
import concurrent.futures
import json
import os
import resource
import shlex
import statistics
import subprocess
import sys
import time

# The flags that tzc-rewrite adds: old ROS code does not parse without them.
LENIENCY = ["-w", "-Wno-enum-constexpr-conversion", "-Wno-missing-template-arg-list-after-template-kw",
            "-Wno-dynamic-exception-spec", "-Wno-register"]


def units_of(build, packages):
    """The commands, without outputs, that compile the packages' files."""
    folders = tuple(os.path.realpath(package) + "/" for package in packages)
    with open(f"{build}/compile_commands.json") as file:
        entries = [entry for entry in json.load(file) if os.path.realpath(entry["file"]).startswith(folders)]
    units = []
    for entry in entries:
        words = entry.get("arguments") or shlex.split(entry["command"])
        while not os.path.basename(words[0]).startswith(("c++", "g++", "clang++", "cc")) or "ccache" in words[0]:
            words = words[1:]  # launchers
        kept = [word for before, word in zip(words, words[1:]) if word not in ("-c", "-o") and before != "-o"]
        units.append((entry["directory"], ["clang++-19", "-fsyntax-only", *kept, *LENIENCY]))
    return units


def compile_all(units, jobs):
    def one(unit):
        folder, command = unit
        done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
        if done.returncode != 0:
            sys.exit(f"does not compile: {shlex.join(command)}\n{done.stderr.decode(errors='replace')[-2000:]}")
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(one, units))


def rewrite(program, build, packages, jobs):
    done = subprocess.run([program, "-p", build, "-j", str(jobs), "-q", *packages], stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"tzc-rewrite ends with {done.returncode}:\n{done.stderr.decode(errors='replace')[-2000:]}")


def measured(work, *arguments):
    """(processor seconds of the child processes, wall seconds)"""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    work(*arguments)
    after, end = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, end - begin


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rewrite")
    parser.add_argument("build")
    parser.add_argument("packages", nargs="+")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--limit", type=float, default=2.5)
    return parser.parse_args()


def main():
    options = parse_arguments()
    units = units_of(options.build, options.packages)
    if not units:
        sys.exit(f"no unit of these packages is in {options.build}/compile_commands.json")
    rounds = {"clang++ -fsyntax-only": [], "tzc-rewrite": []}
    for turn in range(options.rounds):
        taken = [measured(compile_all, units, options.jobs),
                 measured(rewrite, options.rewrite, options.build, options.packages, options.jobs)]
        for (name, times), pair in zip(rounds.items(), taken):
            times.append(pair)
            print(f"round {turn + 1}  {name:22} {pair[0]:7.1f} s processor {pair[1]:7.1f} s wall", flush=True)
    ratios = []
    for index, kind in enumerate(("processor", "wall")):
        compiler, rewriter = (statistics.median(pair[index] for pair in times) for times in rounds.values())
        ratios.append(rewriter / compiler)
        print(f"{kind:9} {rewriter:.1f} s / {compiler:.1f} s = {ratios[-1]:.2f}")
    print(f"{len(units)} units, {options.jobs} jobs, medians of {options.rounds} rounds; the limit is {options.limit}")
    return 1 if max(ratios) > options.limit else 0


if __name__ == "__main__":
    sys.exit(main())
