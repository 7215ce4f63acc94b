# SPDX-License-Identifier: BSD-3-Clause
"""Measures tzc-rewrite against the compiler.

    rewriter_speed.py [--rounds N] [--jobs N] [--limit FACTOR] REWRITE BUILD PACKAGE...

In turns: clang++-19 -fsyntax-only over the same units, with the same flags on as many cores, and tzc-rewrite, which only
reports and takes nothing from its cache. Prints processor and wall time of each round, what the package's own compiler
and CMake took of the former apart, and how many times the syntax check's median the other medians are; the exit status
is 1 when tzc-rewrite's own processor time is above the limit.
"""
import argparse
import concurrent.futures
import json
import os
import re
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


def processor_seconds(log):
    """What tzc-rewrite says of itself, and of the programs that it has started."""
    return [float(figure) for figure in re.search(r"processor time: (\S+) s for tzc-rewrite, (\S+) s for", log).groups()]


def megabytes(log):
    """The most memory that tzc-rewrite held, and the largest of the programs that it has started."""
    return [int(figure) for figure in re.search(r"memory: (\d+) MB, (\d+) MB for the largest", log).groups()]


def rewrite(program, build, packages, jobs):
    """(its own processor seconds, those of the package's compiler and CMake)"""
    done = subprocess.run([program, "-p", build, "-j", str(jobs), "--no-cache", *packages], stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"tzc-rewrite ends with {done.returncode}:\n{done.stderr.decode(errors='replace')[-2000:]}")
    return processor_seconds(done.stderr.decode(errors="replace"))


def measured(work, *arguments):
    """(processor seconds of the child processes, wall seconds)"""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    work(*arguments)
    after, end = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, end - begin


def print_round(number, name, processor, wall):
    print(f"round {number}  {name:23} {processor:7.1f} s processor {wall:7.1f} s wall", flush=True)


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
    checks, ports, others = [], [], []
    for turn in range(1, options.rounds + 1):
        checks.append(measured(compile_all, units, options.jobs))
        print_round(turn, "clang++ -fsyntax-only", *checks[-1])
        begin = time.monotonic()
        own, started = rewrite(options.rewrite, options.build, options.packages, options.jobs)
        ports.append((own, time.monotonic() - begin))
        others.append(started)
        print_round(turn, "tzc-rewrite", *ports[-1])
        print(f"         of the compiler and CMake {started:5.1f} s processor besides", flush=True)
    check, port = ([statistics.median(kind) for kind in zip(*times)] for times in (checks, ports))
    ratio = port[0] / check[0]
    print(f"tzc-rewrite's own processor time: {port[0]:.1f} s / {check[0]:.1f} s = {ratio:.2f} of the syntax check's\n"
          f"the package's compiler and CMake: {statistics.median(others):.1f} s = {statistics.median(others) / check[0]:.2f}\n"
          f"wall time, both together: {port[1]:.1f} s / {check[1]:.1f} s = {port[1] / check[1]:.2f}")
    print(f"{len(units)} units, {options.jobs} jobs, medians of {options.rounds} rounds; the limit is {options.limit}")
    return 1 if ratio > options.limit else 0


if __name__ == "__main__":
    sys.exit(main())
