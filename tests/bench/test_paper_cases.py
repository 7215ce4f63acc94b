# SPDX-License-Identifier: BSD-3-Clause
"""usage: test_paper_cases.py TZC_BENCH contenders|conditions|counts

What tzc-bench paper measures besides the main cases, and whom it compares with; no ROS is needed."""
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile

from paper_run import ROS_FREE, TINY, environment, key, read, rows, run


def built_contenders(bench, scratch):
    """The message about an unknown one names those that there are."""
    return run(bench, scratch, "--only", "none").stderr.rpartition("there are ")[2].strip().split(", ")


def contenders(bench, scratch):
    """Every contender that needs no ROS carries messages; what borrows its samples copies nothing in the publisher."""
    of_ros = {"tcpros", "intraprocess", "tzc-queue", "tzc-direct", "tzc-spin", "asl"}
    others = [name for name in built_contenders(bench, scratch) if name not in of_ros]
    assert {"ach", "tzc"} <= set(others), others
    options = ["--sizes", "64k", "--subscribers", "2", "--count", "4", *TINY, "--no-plots"]
    done = run(bench, scratch, *options, "--only", ",".join(others))
    measured = {row["contender"]: row for row in rows(scratch, "latency.csv")}
    assert done.returncode == 0 or "multicast" in done.stderr, done
    assert set(measured) == set(others) - ({"lcm"} if "multicast" in done.stderr else set()), (done, measured)
    assert all(float(row["delivered_share"]) > 0 for row in measured.values()), measured
    for row in rows(scratch, "copies.csv"):
        copies, borrows = float(row["copies"]), row["contender"] in ("iceoryx-listener", "fastdds-loan", "tzc")
        assert (copies < 0.1) == borrows, row
        if row["contender"] == "cyclone-shm":
            assert float(row["publisher_copied_bytes"]) < 6554, row
    if "fastdds-shm" in others:
        check_nothing_is_left(bench, scratch)
    if "lcm" in others:
        check_obstacle(bench, scratch, [*options, "--only", "lcm,ach", "--output", os.path.join(scratch, "alone")])


def check_nothing_is_left(bench, scratch):
    """A process that is killed leaves its shared memory behind; with large messages it takes a while to end by itself."""
    def segments():
        return {name for name in os.listdir("/dev/shm") if re.fullmatch("fastrtps_[0-9a-f]{16}", name)}

    before = segments()
    run(bench, scratch, "--sizes", "64m", "--subscribers", "8", "--count", "4", *TINY, "--no-plots", "--only", "fastdds-shm",
        output="large")
    assert segments() <= before, segments() - before


def check_obstacle(bench, scratch, options):
    """Where there is no network, LCM is left out, with the reason; the others are measured."""
    alone = subprocess.run(["unshare", "--map-root-user", "--net", bench, "paper", *options], text=True, timeout=600,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment(scratch))
    assert alone.returncode == 1 and "multicast" in alone.stderr and "left out: lcm" in alone.stderr, alone
    with open(os.path.join(scratch, "alone", "latency.csv"), encoding="utf-8") as file:
        assert [row["contender"] for row in csv.DictReader(file)] == ["ach"], alone


def real_time_rows(bench, scratch, options):
    done = run(bench, scratch, *options, "--real-time", "--load")
    if "SCHED_FIFO" in done.stderr:  # which not every user may have: then the reason is told
        assert done.returncode == 1 and "rtprio" in done.stderr and "left out: real time" in done.stderr, done
        return []
    assert done.returncode == 0, done
    return rows(scratch, "real-time.csv")


def conditions(bench, scratch):
    """Cases under load and in real time stand in tables of their own; there TZC's path allocates and faults nothing."""
    options = ["--sizes", "64k", "--subscribers", "1,2", "--count", "10", *TINY, "--only", "ach,tzc,futex"]
    in_real_time = real_time_rows(bench, scratch, options)
    loaded = {key(row) for row in rows(scratch, "latency-load.csv")}
    assert loaded == {key(row) for row in rows(scratch, "latency.csv")}, loaded
    assert loaded == {(name, 65536, subscribers) for name in ("ach", "tzc") for subscribers in (1, 2)}, loaded
    assert {key(row) for row in rows(scratch, "reliability-load.csv")} == loaded
    assert "Under load" in read(scratch, "index.html")
    check_fill(bench, scratch)
    if not in_real_time:
        return
    assert {(row["contender"], row["subscribers"], row["load"]) for row in in_real_time} == {
        (name, "2", load) for name in ("ach", "tzc", "futex") for load in ("no", "yes")}, in_real_time
    for row in in_real_time:
        assert float(row["median_us"]) <= float(row["p99.9_us"]) <= float(row["max_us"]), row
        assert float(row["allocations"]) == 0 and float(row["page_faults"]) == 0, row
    assert "Real time" in read(scratch, "index.html")
    with open(os.path.join(scratch, "out", "real-time.png"), "rb") as file:
        assert file.read(8) == b"\x89PNG\r\n\x1a\n"


def check_fill(bench, scratch):
    """Filling 64 MB takes milliseconds that are inside the span only with --fill, whatever the caches and other processes do."""
    options = ["--sizes", "64m", "--subscribers", "1", "--count", "60", *TINY, "--only", "tzc", "--no-plots"]
    for more in ([], ["--fill"]):
        assert run(bench, scratch, *options, *more, output="filled" if more else "published").returncode == 0
    least = [float(next(csv.DictReader(open(os.path.join(scratch, name, "latency.csv"))))["min_us"])
             for name in ("published", "filled")]
    assert least[1] > least[0] + 200, least
    mixed = run(bench, scratch, *options, output="filled")
    assert mixed.returncode == 1 and "allocate, fill, publish" in mixed.stderr, mixed


def write_tool(folder, name, script):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("#!/bin/sh\n" + script)
    os.chmod(path, 0o755)


CENSUS = '{"totals": {"types": %d, "has_variable_array": %d, "has_data_part": %d}}'
DIFF = "--- a/x.cpp\n+++ b/x.cpp\n@@ -1,2 +1,3 @@\n-old\n+new\n+newer\n same\n"


def counts(bench, scratch):
    """Types and changed lines are those that tzc-msggen and tzc-rewrite name; scripts beside a copy of tzc-bench play
    both, with one folder and one package that they refuse."""
    tools = os.path.join(scratch, "tools")
    folders = {name: os.path.join(scratch, name) for name in ("one", "two", "refused")}
    for folder in (tools, *folders.values()):
        os.mkdir(folder)
    copy = shutil.copy(bench, tools)
    write_tool(tools, "tzc-msggen", f"""[ "$*" = "classify --json {folders['one']}" ] && echo '{CENSUS % (10, 4, 2)}' && exit
[ "$*" = "classify --json {folders['two']}" ] && echo '{CENSUS % (5, 1, 1)}' && exit
[ "$*" = "classify --json {folders['one']} {folders['two']}" ] && echo '{CENSUS % (12, 4, 2)}' && exit
echo "refused: $*" >&2; exit 2\n""")
    write_tool(tools, "tzc-rewrite", f"""[ "$*" = "--quiet {folders['one']}" ] && printf %s '{DIFF}' && exit 1
echo "no compile_commands.json" >&2; exit 2\n""")
    asked = [f"--{what}={folders[name]}" for what in ("types", "effort") for name in ("one", "two", "refused")]
    done = run(copy, scratch, *ROS_FREE, "--sizes", "4k", "--count", "2", *TINY, "--no-plots", *asked)
    assert done.returncode == 1 and done.stderr.count("left out") == 3, done
    assert "types of " + folders["refused"] + ": refused" in done.stderr and "no compile_commands" in done.stderr, done
    types = [list(row.values()) for row in rows(scratch, "types.csv")]
    assert types == [[folders["one"], "10", "4", "40.0", "2", "50.0"], [folders["two"], "5", "1", "20.0", "1", "100.0"],
                     ["all", "12", "4", "33.3", "2", "50.0"]], types
    effort = [list(row.values()) for row in rows(scratch, "effort.csv")]
    assert effort == [[folders["one"], "1", "2", "1"]], effort
    page = read(scratch, "index.html")
    assert "Message types" in page and "Effort" in page
    check_kept_counts(copy, scratch, folders, types, effort)


def check_kept_counts(bench, scratch, folders, types, effort):
    """A run that counts nothing, or one folder anew, shows what earlier runs counted."""
    options = [*ROS_FREE, "--sizes", "4k", "--count", "2", *TINY, "--no-plots"]
    silent = run(bench, scratch, *options)
    assert silent.returncode == 0, silent
    for name, expected in (("types.csv", types), ("effort.csv", effort)):
        assert [list(row.values()) for row in rows(scratch, name)] == expected, (name, read(scratch, name))
    assert "Message types" in read(scratch, "index.html")
    write_tool(os.path.dirname(bench), "tzc-msggen",
               f"""[ "$*" = "classify --json {folders['two']}" ] && echo '{CENSUS % (6, 3, 3)}' && exit
[ "$*" = "classify --json {folders['one']} {folders['two']}" ] && echo '{CENSUS % (13, 6, 3)}' && exit
echo "refused: $*" >&2; exit 2\n""")
    again = run(bench, scratch, *options, f"--types={folders['two']}/")
    assert again.returncode == 0, again
    anew = [list(row.values())[1:] for row in rows(scratch, "types.csv")]
    assert anew == [types[0][1:], ["6", "3", "50.0", "3", "100.0"], ["13", "6", "46.2", "3", "50.0"]], anew
    assert [list(row.values()) for row in rows(scratch, "effort.csv")] == effort


def main():
    bench, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        {"contenders": contenders, "conditions": conditions, "counts": counts}[case](os.path.abspath(bench), scratch)


main()
