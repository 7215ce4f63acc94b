# SPDX-License-Identifier: BSD-3-Clause
"""Ports random programs and shows that they still do the same.

    run_fuzz.py CONFIG.json FOLDER [--seed N] [--programs N] [--first N] [--only N,N] [--batch N] [--twice N]
                [--adversarial] [--siblings] [--guard]

Of every batch of programs (one package, or two with --siblings): tzc-rewrite ports it; original and port are compiled
against the real roscpp, image_transport, cv_bridge and PCL; both run under a roscore; every message that subscribers
and a recorder get is equal. No site stays on TCPROS. Of the first batch and of each Nth after it (--twice), a second
tzc-rewrite --apply changes nothing and reports the same sites. A failing batch stays in FOLDER; the exit status is 1.
"""
import argparse
import json
import os
import re
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from batch import Batch  # noqa: E402
from summary import Summary  # noqa: E402
from toolchain import Failure, Toolchain  # noqa: E402


def again(options, failure, indices):
    """The command that repeats a failure: with the programs that it names, otherwise with the whole batch."""
    named = sorted({int(number) for number in re.findall(r"\bp(\d{3,})\b", str(failure))} & set(indices))
    switches = "".join(f" --{name}" for name in ("adversarial", "siblings", "guard") if getattr(options, name))
    programs = ",".join(map(str, named or indices))
    return (f"{sys.executable} {' '.join(sys.argv[:3])} --keep{switches} --seed {options.seed} --only {programs}")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("config")
    parser.add_argument("folder")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--adversarial", action="store_true", help="programs that attack the analysis")
    parser.add_argument("--siblings", action="store_true", help="functions of the programs are in a package of their own")
    parser.add_argument("--programs", type=int, default=50)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", help="these programs alone, by number")
    parser.add_argument("--batch", type=int, default=50)
    parser.add_argument("--twice", type=int, default=4, metavar="N", help="port each Nth batch twice (4)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", action="store_true", help="keep the packages of batches that pass, too")
    parser.add_argument("--guard", action="store_true", help="run each port in guard mode, too: a late write is a failure")
    options = parser.parse_args()
    options.config, options.folder = os.path.realpath(options.config), os.path.realpath(options.folder)
    return options


def batches_of(options):
    if options.only:
        return [[int(number) for number in options.only.split(",")]]
    last = options.first + options.programs
    return [list(range(i, min(i + options.batch, last))) for i in range(options.first, last, options.batch)]


def run_batch(options, batch, indices, summary, twice):
    """Whether all was as it must be."""
    name = f"seed {options.seed}, programs {indices[0]} to {indices[-1]}"
    try:
        summary.add(batch, *batch.run(twice))
        print(f"ok   {name}: " + ", ".join(f"{what} {used:.0f} s" for what, used in batch.seconds.items()), flush=True)
        if not options.keep:
            shutil.rmtree(batch.folder)
        return True
    except (Failure, RuntimeError) as failure:
        print(f"FAIL {name} ({batch.folder})\n{failure}\nagain: {again(options, failure, indices)}", flush=True)
        return False
    finally:
        summary.seconds.update(batch.seconds)


def main():
    options = parse_arguments()
    with open(options.config) as file:
        toolchain = Toolchain(json.load(file), options.jobs)
    summary, failed = Summary(), 0
    for number, indices in enumerate(batches_of(options)):
        folder = f"{options.folder}/seed-{options.seed}-{indices[0]}-{indices[-1]}"
        batch = Batch(options, toolchain, folder, indices)
        failed += not run_batch(options, batch, indices, summary, number % options.twice == 0)
    print(summary)
    vacuous = not failed and summary.shared == 0
    if vacuous:
        print("FAIL nothing went through shared memory")
    return 1 if failed or vacuous else 0


if __name__ == "__main__":
    sys.exit(main())
