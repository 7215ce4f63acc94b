# SPDX-License-Identifier: BSD-3-Clause
"""One run of a publisher and its viewers under a roscore of their own, for scripts/demo."""
import csv
import dataclasses
import json
import os
import statistics
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "support"))
from ros_session import RosSession  # noqa: E402

WARM_UP = 15  # messages of each viewer that are left out: discovery, upgrade, first touch of the pages
TOOL_TIMEOUT = 60


@dataclasses.dataclass
class Result:
    """What a run showed."""
    median_us: float
    p99_us: float
    delivered: int
    shared_messages: int  # of those, seen at an address inside a mapped segment
    statistics: dict      # the publisher's own counters; empty for the original


@dataclasses.dataclass
class PairRun:
    scratch: str
    env: dict
    publisher: list  # a command
    viewer: object   # function: CSV path -> command
    topic: str
    viewers: int
    seconds: float

    def measure(self):
        """Runs until the publisher ends by itself, or for a little more than `seconds`."""
        counters = os.path.join(self.scratch, "statistics.json")
        with RosSession(self.scratch, dict(self.env, TZC_STATISTICS=counters)) as ros:
            viewers = self.start_viewers(ros)
            publisher = ros.start(self.publisher, name="publisher")
            ros.wait_until(lambda: self.topic in published_topics(ros), TOOL_TIMEOUT, f"{self.topic} to be published")
            segments = [set() for _ in viewers]
            end = time.monotonic() + self.seconds + 2
            while publisher.alive() and time.monotonic() < end:
                for mapped, viewer in zip(segments, viewers):
                    mapped.update(mapped_segments(viewer.pid))
                time.sleep(0.3)
            for process in [publisher] + viewers:
                process.stop()
        return self.evaluate(segments, read_statistics(counters, self.topic))

    def start_viewers(self, ros):
        viewers = [ros.start(self.viewer(self.csv_path(i)), name=f"viewer-{i}") for i in range(self.viewers)]
        ros.wait_until(lambda: len(ros.subscribers(self.topic)) >= self.viewers, TOOL_TIMEOUT, "the viewers")
        return viewers

    def csv_path(self, index):
        return os.path.join(self.scratch, f"viewer-{index}.csv")

    def evaluate(self, segments, counters):
        latencies, shared = [], 0
        for index, mapped in enumerate(segments):
            with open(self.csv_path(index)) as lines:
                rows = list(csv.DictReader(lines))[WARM_UP:]
            latencies += [float(row["latency_us"]) for row in rows]
            shared += sum(any(low <= int(row["address"], 16) < high for low, high in mapped) for row in rows)
        if not latencies:
            raise RuntimeError(f"the viewers of {self.topic} got no messages; logs are in {self.scratch}")
        return Result(statistics.median(latencies), percentile(latencies, 0.99), len(latencies), shared, counters)


def run_tools(run):
    """rostopic hz, rostopic echo and rosbag record while the pair runs; what each of them said."""
    bag = os.path.join(run.scratch, "recorded.bag")
    if os.path.exists(bag):
        os.remove(bag)
    with RosSession(run.scratch, run.env) as ros:
        run.start_viewers(ros)
        recorder = ros.start(["rosbag", "record", "-O", bag, "-l", "20", run.topic], name="rosbag")
        ros.wait_until(lambda: len(ros.subscribers(run.topic)) >= run.viewers + 1, TOOL_TIMEOUT, "rosbag record")
        ros.start(run.publisher, name="publisher")
        rate = ros.start(["rostopic", "hz", "-w", "20", run.topic], name="rostopic-hz")
        _, echo = ros.run(["rostopic", "echo", "-n1", "--noarr", run.topic], TOOL_TIMEOUT)
        recorder.wait(TOOL_TIMEOUT)
        ros.wait_until(lambda: "average rate" in rate.log(), TOOL_TIMEOUT, "rostopic hz")
        rates = [line for line in rate.log().splitlines() if "average rate" in line]
        compressed = None
        if run.topic + "/compressed" in published_topics(ros):
            _, compressed = ros.run(["rostopic", "echo", "-n1", "--noarr", run.topic + "/compressed"], TOOL_TIMEOUT)
        return {"bag": bag, "echo": "height:" in echo, "hz": rates[-1].split(":")[1].strip() + " Hz",
                "compressed": compressed and "jpeg" in compressed}


def published_topics(ros):
    return [topic for topic, _ in ros.master.getPublishedTopics("/tzc_test", "")[2]]


def mapped_segments(pid):
    """Address ranges of the shared-memory segments that a process has mapped."""
    with open(f"/proc/{pid}/maps") as maps:
        fields = [line.split() for line in maps if "/memfd:tzc" in line]
    return {tuple(int(end, 16) for end in field[0].split("-")) for field in fields}


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def read_statistics(path, topic):
    """The publisher's counters: a line of JSON, written when its topic ended."""
    if not os.path.exists(path):
        return {}
    with open(path) as lines:
        found = [entry for entry in map(json.loads, lines) if entry["topic"] == topic]
    return found[-1] if found else {}
