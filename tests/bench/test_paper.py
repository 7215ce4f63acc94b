# SPDX-License-Identifier: BSD-3-Clause
"""usage: test_paper.py TZC_BENCH report|interruption|mistakes

tzc-bench paper in a tiny form, with real nodes and a rosmaster: what it writes, how it goes on, how it ends."""
import csv
import glob
import html.parser
import json
import os
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

from paper_run import ROS_FREE, TINY, environment, key, read, rows, run

INTERRUPTED = "tcpros,tzc-queue,intraprocess,asl"


def percentile(samples, percent):
    """By Python's own definition of quantiles."""
    return statistics.quantiles(samples, n=100, method="inclusive")[percent - 1]


def check_latency(scratch, cells):
    """The CSV's figures are those of the raw samples."""
    table = rows(scratch, "latency.csv")
    assert [key(row) for row in table] == [key(cell) for cell in cells], table
    for row, cell in zip(table, cells):
        by_subscriber = [[ns for round in cell["rounds"] for ns in round["latency_ns"][who]]
                         for who in range(cell["subscribers"])]
        samples = [ns / 1000 for one in by_subscriber for ns in one if ns is not None]
        expected = {"min_us": min(samples), "p1_us": percentile(samples, 1), "q1_us": percentile(samples, 25),
                    "median_us": statistics.median(samples), "q3_us": percentile(samples, 75),
                    "p99_us": percentile(samples, 99), "max_us": max(samples), "mean_us": statistics.fmean(samples)}
        for name, value in expected.items():
            assert abs(float(row[name]) - value) < 0.001, (name, row, value)
        assert [sum(ns is not None for ns in one) for one in by_subscriber] == cell["delivered"], cell
        sent = sum(map(len, by_subscriber))
        assert abs(float(row["delivered_share"]) - len(samples) / sent) < 1e-6, (row, len(samples), sent)


def check_reliability(scratch, cells):
    expected = [(*key(cell), who, cell["sent"], delivered) for cell in cells
                for who, delivered in enumerate(cell["delivered"])]
    table = [(*key(row), int(row["subscriber"]), int(row["sent"]), int(row["delivered"]))
             for row in rows(scratch, "reliability.csv")]
    assert table == expected, table


def check_copies(scratch, size, subscribers):
    """Table I of the paper, of the transports whose code says how often they copy."""
    expected = {"tcpros": 1 + 3 * subscribers, "asl": 1 + subscribers, "ach": 1 + subscribers, "tzc": 0, "tzc-direct": 0}
    table = {key(row): row for row in rows(scratch, "copies.csv")}
    for contender, copies in expected.items():
        row = table[contender, size, subscribers]
        assert abs(float(row["copies"]) - copies) < 0.1 * max(copies, 1), row
    tcpros = table["tcpros", size, subscribers]
    assert float(tcpros["publisher_sent_bytes"]) >= size * subscribers, tcpros
    assert float(table["tzc", size, subscribers]["publisher_sent_bytes"]) < 1024, table


class Outside(html.parser.HTMLParser):
    """What a page takes from elsewhere, and the elements that it leaves open."""

    def __init__(self):
        super().__init__()
        self.references, self.elements = [], set()

    def handle_starttag(self, tag, attrs):
        self.elements.add(tag)
        self.references += [value for name, value in attrs if name in ("src", "href", "xlink:href", "data", "srcset")]


def check_page(scratch):
    page = read(scratch, "index.html")
    parser = Outside()
    parser.feed(page)
    assert all(reference.startswith("#") for reference in parser.references), parser.references
    assert not parser.elements & {"script", "link", "iframe", "object", "img"}, parser.elements
    assert {"svg", "table", "figure"} <= parser.elements, parser.elements
    assert all(target.startswith("#") for target in re.findall(r"url\(['\"]?(.)", page)), "a style from elsewhere"
    assert "@import" not in page and "<?xml" not in page
    machine = json.loads(read(scratch, "run.json"))["machine"]
    assert machine["kernel"] in page and "roscpp" in page


def check_plot(scratch, contenders):
    document = xml.etree.ElementTree.parse(os.path.join(scratch, "out", "latency-2.svg")).getroot()
    assert document.tag.endswith("svg"), document.tag
    texts = {"".join(text.itertext()).strip() for text in document.iter("{http://www.w3.org/2000/svg}text")}
    assert {"4 KB", "64 KB", "one-way latency", *contenders} <= texts, texts
    assert any(text.startswith("2 subscribers") for text in texts), texts
    with open(os.path.join(scratch, "out", "latency-2.png"), "rb") as file:
        assert file.read(8) == b"\x89PNG\r\n\x1a\n"


def stamps(scratch):
    return {path: os.stat(path).st_mtime_ns for path in glob.glob(os.path.join(scratch, "out", "cells", "*"))}


def check_publication(bench, scratch, options):
    """A repository's page of what was measured: it refers to files beside it, and raw samples stay behind."""
    folder = os.path.join(scratch, "repository", "docs")
    done = run(bench, scratch, *options, "--publish", folder)
    assert done.returncode == 0 and "measured already" in done.stderr, done
    with open(os.path.join(folder, "README.md"), encoding="utf-8") as file:
        page = file.read()
    named = re.findall(r"\]\(([^)]+)\)", page)
    assert {"latency-2.svg", "latency.csv", "overview.csv", "ranking.csv"} <= set(named), named
    assert set(named) <= set(os.listdir(folder)) and "results.json" not in os.listdir(folder), os.listdir(folder)
    assert json.loads(read(scratch, "run.json"))["machine"]["kernel"] in page, page
    overview = {row["contender"]: row for row in rows(scratch, "overview.csv")}
    assert {row["cells"] for row in overview.values()} == {"2"} and "tcpros" in overview, overview
    assert [row["size_bytes"] for row in rows(scratch, "ranking.csv")] == ["4096", "65536"]


def check_own_gnuplot_settings(bench, scratch):
    """What ~/.gnuplot says is for the user's own plots."""
    with open(os.path.join(scratch, ".gnuplot"), "w", encoding="utf-8") as file:
        file.write('set label "of the user" at graph 0.5, graph 0.5\n')
    done = run(bench, scratch, *ROS_FREE, "--sizes", "4k", "--count", "2", *TINY, output="plain", HOME=scratch)
    assert done.returncode == 0, done
    with open(os.path.join(scratch, "plain", "latency-1.svg"), encoding="utf-8") as file:
        assert "of the user" not in file.read()


def check_resuming(bench, scratch, options):
    before = stamps(scratch)
    again = run(bench, scratch, *options)
    assert again.returncode == 0 and "measured already" in again.stderr, again
    assert stamps(scratch) == before, "finished cells were measured again"
    gone = next(path for path in before if "tzc-direct-4096" in path)
    os.unlink(gone)
    once_more = run(bench, scratch, *options)
    assert once_more.returncode == 0 and "1 measurement," in once_more.stderr, once_more
    after = stamps(scratch)
    assert {path for path in before if after[path] != before[path]} == {gone}, (before, after)


def check_other_cases(bench, scratch, cells):
    """Whatever a run asks for, and whatever it lacks this time, the report has all that the folder has."""
    common = ["--subscribers", "2", "--count", "4", *TINY]
    few = run(bench, scratch, *common, "--sizes", "4k", "--only", "tzc")
    assert few.returncode == 0 and "measured already" in few.stderr, few
    assert len(rows(scratch, "latency.csv")) == cells
    without_ros = run(bench, scratch, *common, "--sizes", "4k,64k", "--only", "tcpros,tzc", "--no-plots", PATH=scratch)
    assert without_ros.returncode == 1 and "rosmaster" in without_ros.stderr, without_ros
    assert [key(row) for row in rows(scratch, "latency.csv")].count(("tcpros", 65536, 2)) == 1
    alone = run(bench, scratch, *common, "--sizes", "4k", "--only", "tcpros", "--no-plots", PATH=scratch)
    assert alone.returncode == 1 and "nothing of it can be measured here" in alone.stderr, alone
    assert not glob.glob(os.path.join(scratch, "out", "latency-*.svg")), "plots of an earlier run, beside newer tables"
    assert "measured already" not in alone.stderr, alone
    assert len(rows(scratch, "latency.csv")) == cells
    assert run(bench, scratch, *common, "--sizes", "4k", "--only", "tzc").returncode == 0  # with plots again


def report(bench, scratch):
    contenders = ["tcpros", "intraprocess", "tzc-queue", "tzc-spin", "tzc-direct", "asl", "ach", "tzc"]
    options = ["--sizes", "4k,64k", "--subscribers", "2", "--count", "4", *TINY, "--only", ",".join(contenders)]
    done = run(bench, scratch, *options)
    assert done.returncode == 0, done
    results = json.loads(read(scratch, "results.json"))
    assert {key(cell) for cell in results["cells"]} == {(name, size, 2) for name in contenders for size in (4096, 65536)}
    assert all(cell["sent"] == 4 for cell in results["cells"]), results["cells"]
    check_latency(scratch, results["cells"])
    check_reliability(scratch, results["cells"])
    check_copies(scratch, 65536, 2)
    check_page(scratch)
    check_plot(scratch, contenders)
    check_own_gnuplot_settings(bench, scratch)
    check_publication(bench, scratch, options)
    check_resuming(bench, scratch, options)
    check_other_cases(bench, scratch, cells=len(contenders) * 2)
    other = run(bench, scratch, *options, "--rate", "60")
    assert other.returncode != 0, "results of two rates were mixed"


def processes_of_session(session):
    found = []
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path, encoding="utf-8", errors="replace") as file:
                name, _, rest = file.read().rpartition(")")
        except OSError:
            continue  # it has ended
        state, _, _, its_session = rest.split()[:4]
        if int(its_session) == session and state != "Z":
            found.append(name)
    return found


def wait_until(condition, what, seconds=120):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"no {what} after {seconds} s"
        time.sleep(0.01)


def start_and_send(bench, scratch, sig, moment, options, send=os.kill, before=signal.SIG_DFL, **more):
    """Starts a run, sends it the signal when moment(pid, what it has said) is true; its status and what it said. before: how
    the run finds the signal handled when it starts."""
    path = os.path.join(scratch, "said")
    command = [bench, "paper", "--output", os.path.join(scratch, "out"), *options, *TINY]
    with open(path, "w", encoding="utf-8") as said:
        process = subprocess.Popen(command, stdout=said, stderr=said, env=environment(scratch, **more),
                                   start_new_session=True,
                                   preexec_fn=None if sig == signal.SIGKILL else lambda: signal.signal(sig, before))

    def said_so_far():
        with open(path, encoding="utf-8") as said:
            return said.read()

    try:
        wait_until(lambda: moment(process.pid, said_so_far()) or process.poll() is not None, "moment to end the run", 60)
        assert process.poll() is None, (process.poll(), said_so_far())
        send(process.pid, sig)
        status = process.wait(120)
        wait_until(lambda: not processes_of_session(process.pid), f"end of {processes_of_session(process.pid)}")
    finally:
        process.kill()
        process.wait()
    return status, said_so_far()


def in_measurement(number):
    """With rosmaster, a publisher and at least one subscriber beside the command."""
    return lambda pid, said: f"[{number}]" in said and len(processes_of_session(pid)) >= 4


in_third_measurement = in_measurement("3/4")


def check_interrupted_drawing(bench, scratch):
    """gnuplot, played by a script, has written half of a plot and goes on forever."""
    gnuplot = os.path.join(scratch, "gnuplot")
    with open(gnuplot, "w", encoding="utf-8") as file:
        file.write("#!/bin/sh\n[ $1 = --version ] && echo gnuplot 5 && exit\necho half > latency-1.svg.tmp\nexec sleep 60\n")
    os.chmod(gnuplot, 0o755)
    half = os.path.join(scratch, "out", "latency-1.svg.tmp")
    status, said = start_and_send(bench, scratch, signal.SIGINT, lambda *_: os.path.exists(half),
                                  [*ROS_FREE, "--sizes", "4k", "--count", "2"],
                                  PATH=scratch + os.pathsep + os.environ["PATH"])
    assert status == 130, (status, said)
    left = glob.glob(os.path.join(scratch, "out", "**", "*.tmp"), recursive=True)
    assert not left and not os.path.exists(os.path.join(scratch, "out", "index.html")), left


def check_whole_files(scratch):
    names = [os.path.relpath(path, os.path.join(scratch, "out"))
             for path in glob.glob(os.path.join(scratch, "out", "**"), recursive=True) if os.path.isfile(path)]
    assert names and all(name.endswith(".json") for name in names), names
    assert all(json.loads(read(scratch, name)) for name in names)
    assert sum(name.startswith("cells/") for name in names) == 2, names


def check_end_of_terminal(bench, scratch, sig, options):
    """A terminal sends its signals to all processes: the command decides, and can go on from there. nohup keeps it running."""
    status, said = start_and_send(bench, scratch, sig, in_third_measurement, options, send=os.killpg)
    assert status == 130 and "goes on from here" in said, (status, said)
    check_whole_files(scratch)
    status, said = start_and_send(bench, scratch, sig, in_measurement("1/2"), options, send=os.killpg,
                                  before=signal.SIG_IGN)
    assert status == 0 and "interrupted" not in said, (status, said)
    assert len(rows(scratch, "latency.csv")) == 4


def interruption(bench, scratch):
    options = ["--sizes", "4k", "--subscribers", "2", "--only", INTERRUPTED, "--count", "50", "--no-plots"]
    status, said = start_and_send(bench, scratch, signal.SIGINT, in_third_measurement, options)
    assert status == 130 and "goes on from here" in said, (status, said)
    check_whole_files(scratch)
    done = run(bench, scratch, *options, *TINY)
    assert done.returncode == 0 and "2 measurements," in done.stderr, done
    assert len(rows(scratch, "latency.csv")) == 4
    for sig in (signal.SIGHUP, signal.SIGQUIT):
        with tempfile.TemporaryDirectory() as another:
            check_end_of_terminal(bench, another, sig, options)
    with tempfile.TemporaryDirectory() as another:
        status, said = start_and_send(bench, another, signal.SIGKILL, in_third_measurement, options)
        assert status == -signal.SIGKILL, (status, said)
        check_whole_files(another)
    with tempfile.TemporaryDirectory() as another:
        check_interrupted_drawing(bench, another)


def check_plan(bench, scratch):
    """A dry run tells what a run would do, and does nothing."""
    full = run(bench, scratch, "--dry-run", PATH=scratch)
    assert full.returncode == 0 and re.search(r"^tcpros +2\d +1\d\d +\d+ minutes +\d+ MB$", full.stdout, re.M), full
    large = run(bench, scratch, *ROS_FREE, "--sizes", "4k,1tb", "--dry-run")
    assert large.returncode == 0 and "may need" in large.stdout and re.search(r"^all +2 ", large.stdout, re.M), large
    assert not os.path.exists(os.path.join(scratch, "out")), "a dry run left something behind"


def check_impossible_wishes(bench, scratch):
    """What no case can be is no success, and the true reason is told, in a dry run too."""
    alone = "futex is measured in real time alone: give --real-time"
    for wish, why in ((["--only", "tcpros", "--real-time"], "contenders of --only is measured in real time; there are futex"),
                      (["--only", "futex"], alone),
                      (["--only", "futex,tcpros"], alone),
                      (["--only", "tzc", "--sizes", "64m", "--real-time"], "only messages up to 4 MB are measured")):
        for plan in ([], ["--dry-run"]):
            told = run(bench, scratch, *wish, *plan, "--no-plots")
            assert told.returncode == 2 and why in told.stderr, (wish, told)
    assert not os.path.exists(os.path.join(scratch, "out")), "it measured all the same"


def mistakes(bench, scratch):
    check_plan(bench, scratch)
    unknown = run(bench, scratch, "--only", "tzc,udpros")
    assert unknown.returncode == 2 and "udpros" in unknown.stderr and "tcpros" in unknown.stderr, unknown
    assert run(bench, scratch, "--sizes", "many").returncode == 2
    check_impossible_wishes(bench, scratch)
    without_gnuplot = run(bench, scratch, *ROS_FREE, PATH=scratch)
    assert without_gnuplot.returncode == 1, without_gnuplot
    assert "gnuplot-nox" in without_gnuplot.stderr and "--no-plots" in without_gnuplot.stderr, without_gnuplot
    assert not os.path.exists(os.path.join(scratch, "out")), "it measured all the same"
    tables = run(bench, scratch, *ROS_FREE, "--sizes", "4k", "--count", "2", *TINY, "--no-plots", PATH=scratch)
    assert tables.returncode == 0, tables
    assert not glob.glob(os.path.join(scratch, "out", "*.svg")) and "<figure>" not in read(scratch, "index.html")
    mixed = run(bench, scratch, *ROS_FREE, "--sizes", "4k", "--count", "3", *TINY, "--no-plots")
    assert mixed.returncode == 1 and "--output" in mixed.stderr, mixed
    folder = os.path.join(scratch, "file")
    with open(folder, "w", encoding="utf-8"):
        pass
    no_folder = run(bench, scratch, *ROS_FREE, "--no-plots", output="file")
    assert no_folder.returncode == 1 and folder in no_folder.stderr, no_folder
    too_long = "n" * 300
    for plan in ([], ["--dry-run"]):
        unusable = run(bench, scratch, *ROS_FREE, "--no-plots", *plan, output=too_long)
        assert unusable.returncode == 1 and too_long in unusable.stderr, unusable
    damaged = os.path.join(scratch, "damaged", "run.json")
    os.mkdir(os.path.dirname(damaged))
    with open(damaged, "w", encoding="utf-8") as file:
        file.write("[]")
    no_run = run(bench, scratch, *ROS_FREE, "--no-plots", output="damaged")
    assert no_run.returncode == 1 and damaged in no_run.stderr, no_run
    without_ros = run(bench, scratch, "--only", "tcpros", "--no-plots", "--count", "3", *TINY, "--sizes", "4k",
                      output="without_ros", PATH=scratch)
    assert without_ros.returncode == 1 and "rosmaster" in without_ros.stderr, without_ros
    too_large = run(bench, scratch, *ROS_FREE, "--sizes", "4k,1tb", "--count", "2", *TINY, "--no-plots", output="large")
    assert too_large.returncode == 1 and "may need" in too_large.stderr and "is free" in too_large.stderr, too_large
    with open(os.path.join(scratch, "large", "latency.csv"), encoding="utf-8") as file:
        assert [row["size_bytes"] for row in csv.DictReader(file)] == ["4096", "4096"]
    shown = run(bench, scratch, "--help")
    assert shown.returncode == 0 and "--quick" in shown.stdout and "Examples:" in shown.stdout, shown


def main():
    bench, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        {"report": report, "interruption": interruption, "mistakes": mistakes}[case](os.path.abspath(bench), scratch)


main()
