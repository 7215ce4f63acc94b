#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What tzc-monitor costs the nodes that it watches: pairs of rounds of `tzc-bench roscpp`, the second one while live
monitors look on. Each of these is killed and started anew once a second. Prints latencies of both, and their ratios.

usage: monitor_cost.py TZC_BENCH TZC_MONITOR [--pairs N] [--count N] [--monitors N]
"""
import argparse
import json
import os
import pty
import select
import statistics
import subprocess
import tempfile
import threading
import time


class Terminal:
    """A live monitor on a terminal that somebody reads."""

    def __init__(self, monitor):
        self.end, other = pty.openpty()
        self.process = subprocess.Popen([monitor], stdin=subprocess.DEVNULL, stdout=other, stderr=other,
                                        start_new_session=True)
        os.close(other)
        self.end_of_life = time.monotonic() + 1

    def read(self):
        try:
            return os.read(self.end, 65536)
        except OSError:
            return b""

    def kill(self):
        self.process.kill()
        self.process.wait()
        os.close(self.end)


class Watchers:
    """So many monitors, as long as the block lasts; `kills` counts those that were killed, `nodes` whether they saw any."""

    def __init__(self, monitor, count):
        self.monitor, self.count = monitor, count
        self.kills, self.nodes = 0, False
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *exc):
        self._over.set()
        self._thread.join()
        return False

    def _watch(self):
        terminals = []
        try:
            self._replace(terminals)
        finally:
            for terminal in terminals:
                terminal.kill()

    def _replace(self, terminals):
        for number in range(self.count):
            terminals.append(Terminal(self.monitor))
            terminals[-1].end_of_life += number / self.count  # their lives end one after the other
        while not self._over.is_set():
            readable = select.select([terminal.end for terminal in terminals], [], [], 0.05)[0]
            for terminal in list(terminals):
                if terminal.end in readable:
                    self.nodes = b"bench_publisher" in terminal.read() or self.nodes
                if time.monotonic() > terminal.end_of_life:
                    terminals.remove(terminal)
                    terminal.kill()
                    self.kills += 1
                    terminals.append(Terminal(self.monitor))


def measure(options, scratch):
    """One row of tzc-bench: ported nodes, callbacks through their queues."""
    path = os.path.join(scratch, "rows.json")
    subprocess.run([options.bench, "roscpp", "--only", "tzc-queue", "--sizes", "4m", "--subscribers", "4", "--rounds", "1",
                    "--count", str(options.count), "--json", path], check=True, stdout=subprocess.DEVNULL,
                   env=dict(os.environ, ROS_HOME=scratch, ROS_LOG_DIR=scratch))
    with open(path, encoding="utf-8") as file:
        return json.load(file)["rows"][0]


def line(name, rows):
    values = [statistics.median(row[key] for row in rows) for key in ("median_us", "p99_us")]
    sent, delivered = (sum(row[key] for row in rows) for key in ("sent", "delivered"))
    return f"{name:12} {values[0]:10.1f} {values[1]:10.1f} {delivered:>9} of {sent}"


def ratio(key, alone, watched):
    ratios = sorted(b[key] / a[key] for a, b in zip(alone, watched))
    return f"{key} watched / alone: {statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("monitor")
    parser.add_argument("--pairs", type=int, default=10)
    parser.add_argument("--count", type=int, default=200, help="messages of a round, 4 MB to 4 subscribers at 30 Hz")
    parser.add_argument("--monitors", type=int, default=10, help="0: how far apart two rounds are without any")
    options = parser.parse_args()
    alone, watched, kills, nodes = [], [], 0, True
    with tempfile.TemporaryDirectory() as scratch:
        for _ in range(options.pairs):
            alone.append(measure(options, scratch))
            with Watchers(options.monitor, options.monitors) as watchers:
                watched.append(measure(options, scratch))
            kills += watchers.kills
            nodes = nodes and watchers.nodes
    print(f"{'':12} {'median_us':>10} {'p99_us':>10} {'delivered':>9}")
    print(line("alone", alone))
    print(line("watched", watched))
    print(ratio("median_us", alone, watched))
    print(ratio("p99_us", alone, watched))
    print(f"{options.monitors} monitors at a time, {kills} of them killed; pairs of rounds: {options.pairs}")
    return 0 if nodes or options.monitors == 0 else "the monitors did not see the nodes"


if __name__ == "__main__":
    raise SystemExit(main())
