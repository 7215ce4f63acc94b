# SPDX-License-Identifier: BSD-3-Clause
"""Runs original and ported nodes side by side and prints the demo's tables; exit status 1 when a claim fails.

usage: demo_pairs.py SCRATCH ORIGINAL_WORKSPACE PORTED_WORKSPACE --picture FILE --report FILE.json [--seconds N]
"""
import argparse
import json
import os
import subprocess
import sys

from pair_run import PairRun, run_tools
from workspace_env import workspace_env

IMAGE_BYTES = 1920 * 1080 * 3
MUST_BE_FASTER = 20  # camera_pair with 4 viewers, median
VERSIONS = ("original", "ported")


class CameraPair:
    name, topic = "camera_pair", "/camera/image"

    def publisher(self, workspace, viewers, messages):
        node = os.path.join(workspace, "devel/lib/camera_pair/camera_node")
        return [node, "__name:=camera", f"_count:={messages}", f"_subscribers:={viewers}"]


class ImagePublisher:
    name, topic = "image_publisher", "/image_publisher/image_raw"

    def __init__(self, picture):
        self.picture = picture

    def publisher(self, workspace, viewers, messages):
        del viewers, messages  # it publishes until it is stopped
        node = os.path.join(workspace, "devel/lib/image_publisher/image_publisher")
        return [node, self.picture, "__name:=image_publisher", "_publish_rate:=30", "_frame_id:=picture"]


def viewer(workspace, topic):
    node = os.path.join(workspace, "devel/lib/camera_pair/viewer_node")
    return lambda csv: [node, f"_csv:={csv}", f"camera/image:={topic}"]


class Demo:
    def __init__(self, options):
        self.options = options
        self.workspaces = {"original": options.original, "ported": options.ported}
        self.envs = {version: workspace_env(path) for version, path in self.workspaces.items()}
        self.failures = []

    def expect(self, claim, text):
        if not claim:
            self.failures.append(text)

    def scratch(self, *parts):
        folder = os.path.join(self.options.scratch, "-".join(map(str, parts)))
        os.makedirs(folder, exist_ok=True)
        return folder

    def run(self, pair, version, viewers, seconds, purpose):
        workspace = self.workspaces[version]
        messages = int(30 * seconds)
        return PairRun(self.scratch(pair.name, version, viewers, purpose), self.envs[version],
                       pair.publisher(workspace, viewers, messages), viewer(workspace, pair.topic), pair.topic,
                       viewers, seconds)

    # -- what was ported ------------------------------------------------------------------------------------------

    def show_reports(self, pairs):
        row(["package", "sites", "ported as", "files", "lines"], SITE_WIDTHS)
        with open(self.options.report) as report:
            reports = {entry["package"]: entry for entry in json.load(report)["packages"]}
        for pair in pairs:
            self.show_report(pair, reports[pair.name])
        print()

    def show_report(self, pair, report):
        summary = report["summary"]
        for kind in ("publish", "subscribe"):
            levels = {level: count for level, count in summary.get(kind, {}).items() if level != "total" and count}
            row([pair.name, f"{summary.get(kind, {}).get('total', 0)} {kind}",
                 ", ".join(f"{count} {level}" for level, count in levels.items()) or "none",
                 summary["files_changed"], f"+{summary['lines_added']} -{summary['lines_removed']}"], SITE_WIDTHS)
        self.expect(summary["publish"].get("plain", 0) == 0, f"{pair.name}: a publish site was left plain")
        if pair.name == "camera_pair":
            self.expect(summary["publish"].get("zero_copy", 0) == summary["publish"]["total"],
                        "camera_pair: a publish site is not zero_copy")

    # -- how fast it is -------------------------------------------------------------------------------------------

    def show_latencies(self, pairs):
        row(["package", "version", "viewers", "median/us", "p99/us", "bytes/msg", "seen in segment", "copied",
             "original/ported"], RUN_WIDTHS)
        for pair in pairs:
            for viewers in (1, 4):
                self.compare(pair, viewers)
        print()

    def compare(self, pair, viewers):
        results = {version: self.run(pair, version, viewers, self.options.seconds, "speed").measure()
                   for version in VERSIONS}
        ratio = results["original"].median_us / results["ported"].median_us
        for version, result in results.items():
            self.show_run(pair, version, viewers, result, f"{ratio:.1f} x" if version == "ported" else "")
        self.check_ported(pair, viewers, results["ported"], ratio)

    @staticmethod
    def show_run(pair, version, viewers, result, ratio):
        counters = result.statistics
        sent = counters["control_bytes"] // max(1, counters["messages"]) if counters else IMAGE_BYTES
        row([pair.name, version, viewers, f"{result.median_us:.0f}", f"{result.p99_us:.0f}", sent,
             f"{result.shared_messages} of {result.delivered}",
             "every one" if version == "original" else f"{counters.get('copied_bytes', 0) // IMAGE_BYTES} images",
             ratio], RUN_WIDTHS)

    def check_ported(self, pair, viewers, result, ratio):
        where = f"{pair.name}, {viewers} viewers"
        self.expect(result.delivered > 0, f"{where}: nothing was delivered")
        self.expect(result.shared_messages == result.delivered,
                    f"{where}: {result.delivered - result.shared_messages} messages were not seen in shared memory")
        if isinstance(pair, CameraPair):
            self.expect(result.statistics.get("copied_bytes") == 0, f"{where}: data was copied")
            self.expect(viewers < 4 or ratio >= MUST_BE_FASTER or self.options.any_speed, f"{where}: less than {MUST_BE_FASTER} times faster")

    # -- what else still works ------------------------------------------------------------------------------------

    def show_tools(self, pairs):
        for pair in pairs:
            bags = {}
            for version in VERSIONS:
                run = self.run(pair, version, 2, 3600, "tools")  # the recorder counts as a viewer for the camera
                run.viewers = 1
                said = run_tools(run)
                bags[version] = said["bag"]
                if version == "ported":
                    self.show_tool_report(pair, said)
            same = subprocess.run([sys.executable, os.path.join(os.path.dirname(__file__), "compare_bags.py"),
                                   bags["original"], bags["ported"]], capture_output=True, check=False)
            print(f"{pair.name}: rosbag record: {(same.stdout + same.stderr).decode().strip()}")
            self.expect(same.returncode == 0, f"{pair.name}: the recordings differ")

    def show_tool_report(self, pair, said):
        print(f"{pair.name}: rostopic hz: {said['hz'] or 'nothing'}; rostopic echo -n1: "
              f"{'a message' if said['echo'] else 'nothing'}")
        self.expect(said["hz"] and said["echo"], f"{pair.name}: rostopic sees nothing on the ported topic")
        if isinstance(pair, ImagePublisher):
            print(f"{pair.name}: compressed transport: {'a JPEG image' if said['compressed'] else 'nothing'}")
            self.expect(said["compressed"], f"{pair.name}: its compressed transport is silent")


SITE_WIDTHS = (17, 14, 28, 7, 10)
RUN_WIDTHS = (17, 10, 8, 10, 8, 10, 16, 11, 16)


def row(cells, widths):
    print("  ".join(str(cell).ljust(width) for cell, width in zip(cells, widths)).rstrip(), flush=True)


def main():
    parser = argparse.ArgumentParser()
    for name in ("scratch", "original", "ported"):
        parser.add_argument(name)
    parser.add_argument("--picture", required=True)
    parser.add_argument("--report", required=True)
    parser.add_argument("--seconds", type=float, default=5)
    parser.add_argument("--any-speed", action="store_true")
    options = parser.parse_args()
    demo = Demo(options)
    pairs = [CameraPair(), ImagePublisher(options.picture)]
    demo.show_reports(pairs)
    demo.show_latencies(pairs)
    demo.show_tools(pairs)
    for failure in demo.failures:
        print("FAILED:", failure)
    return 1 if demo.failures else 0


if __name__ == "__main__":
    sys.exit(main())
