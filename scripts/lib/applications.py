# SPDX-License-Identifier: BSD-3-Clause
"""Runs samples/red_light or samples/rotation, original and port in turns, and prints what the braking distance is made of.

usage: applications.py EXPERIMENT SCRATCH ORIGINAL_WORKSPACE PORTED_WORKSPACE --port-report FILE.json [--runs N]
       [--stops N] [--any-speed]

Exit status 1 when the report of the port, the counters of its camera or the measured stops contradict a claim.
"""
import argparse
import csv
import dataclasses
import json
import os
import platform
import shutil
import subprocess
import sys

from braking import PARTS, VERSIONS, Comparison, middle, read_stops
from braking_plot import draw
from demo_pairs import row
from pair_run import RosSession, read_statistics
from workspace_env import workspace_env

TOPIC = "/camera/image"
SECONDS_PER_STOP = 20  # it takes 4; the rest is for a machine that has much else to do
SECONDS_TO_END = 40    # roslaunch gives its nodes 15 s to end before it kills them


@dataclasses.dataclass
class Experiment:
    package: str
    title: str
    unit: str
    scale: float       # from the unit of stopwatch_node
    packages: tuple    # whose report must say zero_copy and shared


EXPERIMENTS = {
    "red_light": Experiment("red_light", "0.6 m/s towards a light that turns red", "mm", 1000.0, ("red_light",)),
    "rotation": Experiment("rotation", "1 rad/s past a red light", "degrees", 57.29578, ("rotation", "red_light")),
}
WIDTHS = (4, 9) + 4 * (7,) + 4 * (8,) + (9, 9)


class Application:
    def __init__(self, options):
        self.options = options
        self.experiment = EXPERIMENTS[options.experiment]
        self.envs = {"original": workspace_env(options.original), "ported": workspace_env(options.ported)}
        self.failures = []

    def expect(self, claim, text):
        if not claim:
            self.failures.append(text)

    # -- what was ported ------------------------------------------------------------------------------------------

    def check_report(self):
        """Images are published without a copy and received in shared memory, by every node that handles them."""
        with open(self.options.port_report, encoding="utf-8") as file:
            packages = {entry["package"]: entry for entry in json.load(file)["packages"]}
        for name in self.experiment.packages:
            sites = [site for site in packages[name]["sites"] if site["message_type"] == "sensor_msgs/Image"]
            for site in sites:
                print(f"{name}: {site['file']}:{site['line']}: {site['kind']} {site['level']}")
                self.expect(site["level"] in ("zero_copy", "shared"), f"{name}: {site['file']} is {site['level']}")
            self.expect(sites, f"{name}: its report has no site with images")

    # -- the runs -------------------------------------------------------------------------------------------------

    def measure(self):
        """Original and port in turns; which of them is first changes from run to run, as does the phase."""
        runs = []
        row(["run", "version"] + [f"T{p}/ms" for p in PARTS] + [f"L{p}" for p in PARTS]
            + [self.experiment.unit, "shorter"], WIDTHS)
        for number in range(1, self.options.runs + 1):
            order = VERSIONS if number % 2 else tuple(reversed(VERSIONS))
            phase = (number - 0.5) / self.options.runs
            runs.append({version: self.run(number, version, phase) for version in order})
            self.show_run(number, runs[-1])
        return Comparison(runs)

    def run(self, number, version, phase):
        folder = os.path.join(self.options.scratch, "runs", f"{number:02d}-{version}")
        counters = os.path.join(folder, "statistics.json")
        command = ["roslaunch", self.experiment.package, f"{self.experiment.package}.launch", f"phase:={phase:.4f}",
                   f"stops:={self.options.stops}", f"logs:={folder}"]
        with RosSession(folder, dict(self.envs[version], TZC_STATISTICS=counters)) as ros:
            launch = ros.start(command, name="roslaunch")
            try:
                launch.wait(SECONDS_PER_STOP * (1 + self.options.stops))
            finally:
                launch.stop(timeout=SECONDS_TO_END)
        if version == "ported":
            self.check_counters(folder, read_statistics(counters, TOPIC))
        return self.stops_in(folder)

    def stops_in(self, folder):
        stops = read_stops(os.path.join(folder, "stops.csv"))
        if len(stops) < self.options.stops:
            raise RuntimeError(f"the robot stopped {len(stops)} times instead of {self.options.stops}; logs are in {folder}")
        return stops

    def check_counters(self, folder, counters):
        self.expect(counters.get("messages", 0) > 0, f"{folder}: the camera sent nothing through shared memory")
        self.expect(counters.get("copied_bytes") == 0, f"{folder}: the camera copied images")

    # -- what came out --------------------------------------------------------------------------------------------

    def show_run(self, number, run):
        stops = {version: middle(run[version]) for version in VERSIONS}
        gain = 1 - stops["ported"].distance / stops["original"].distance
        for version, stop in stops.items():
            row([number, version] + [f"{1e3 * t:.2f}" for t in stop.times]
                + [f"{self.experiment.scale * length:.2f}" for length in stop.lengths]
                + [f"{self.experiment.scale * stop.distance:.2f}", f"{gain:.1%}" if version == "ported" else ""], WIDTHS)

    def show_summary(self, comparison):
        runs, unit, scale = len(comparison.runs), self.experiment.unit, self.experiment.scale
        print(f"\nthe port stops earlier in {comparison.shorter()} of {runs} runs")
        for version in VERSIONS:
            times = ", ".join(f"T{p} {1e3 * comparison.median_time(version, i):.2f} ms" for i, p in enumerate(PARTS))
            print(f"{version}: {times}; {scale * comparison.median_distance(version):.2f} {unit} (medians of all stops)")
        gains = ", ".join(f"L{p} {scale * comparison.gained(i):.2f}" for i, p in enumerate(PARTS))
        print(f"shorter by, median of the runs, in {unit}: {gains}")

    def check(self, comparison):
        self.failures += comparison.problems()
        enough = comparison.shorter() >= 0.9 * len(comparison.runs) or self.options.any_speed
        self.expect(enough, "the port stops earlier in less than 9 of 10 runs")

    def save(self, comparison):
        """stops.csv with every stop, results.json with the machine, and the pictures."""
        prefix = os.path.join(self.options.scratch, self.experiment.package)
        stops = [dict(run=number, version=version, **dataclasses.asdict(stop),
                      **{f"T{p}": time for p, time in zip(PARTS, stop.times)},
                      **{f"L{p}": length for p, length in zip(PARTS, stop.lengths)})
                 for number, run in enumerate(comparison.runs, 1) for version in VERSIONS for stop in run[version]]
        with open(prefix + ".csv", "w", newline="", encoding="utf-8") as file:
            table = csv.DictWriter(file, stops[0])
            table.writeheader()
            table.writerows(stops)
        with open(prefix + ".json", "w", encoding="utf-8") as file:
            json.dump({"experiment": dataclasses.asdict(self.experiment), "machine": machine(), "stops": stops}, file,
                      indent=1)
        pictures = draw(comparison, prefix, self.experiment.title, self.experiment.unit, self.experiment.scale)
        print("written:", *[prefix + ".csv", prefix + ".json"] + pictures, sep="\n  ")


def machine():
    return {"system": platform.platform(), "cores": os.cpu_count(), "load_average": os.getloadavg()}


def parse_options():
    parser = argparse.ArgumentParser()
    parser.add_argument("experiment", choices=EXPERIMENTS)
    for name in ("scratch", "original", "ported"):
        parser.add_argument(name)
    parser.add_argument("--port-report", required=True)
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--stops", type=int, default=3, help="in each run; the one with the median distance counts")
    parser.add_argument("--any-speed", action="store_true", help="do not fail when the port does not stop earlier")
    return parser.parse_args()


def main():
    options = parse_options()
    shutil.rmtree(os.path.join(options.scratch, "runs"), ignore_errors=True)
    application = Application(options)
    application.check_report()
    comparison = application.measure()
    application.show_summary(comparison)
    application.check(comparison)
    application.save(comparison)
    for failure in application.failures:
        print("FAILED:", failure)
    return 1 if application.failures else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
    except (RuntimeError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"error: {error}")
