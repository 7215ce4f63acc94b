# SPDX-License-Identifier: BSD-3-Clause
"""What a braking distance is made of, for scripts/demo --red-light and --rotation. docs/applications.md defines T1 to L4."""
import csv
import dataclasses
import statistics

PARTS = ("1", "2", "3", "4")
VERSIONS = ("original", "ported")


@dataclasses.dataclass
class Stop:
    """One stop of the robot. Moments are seconds since it crossed the line; lengths are metres, or radians."""
    published: float
    received: float
    detected: float
    braking: float
    standstill: float
    speed: float
    distance: float  # as the simulated robot found it, which knows nothing of the images

    @property
    def times(self):
        """T1 to T4: they follow each other from the line to standstill."""
        moments = (0.0, self.published, self.received, self.detected, self.standstill)
        return tuple(end - start for start, end in zip(moments, moments[1:]))

    @property
    def lengths(self):
        """L1 to L4: how far the robot moves in T1 to T4. In T4 it brakes evenly once the command arrives."""
        t1, t2, t3, _ = self.times
        at_speed, slowing = self.braking - self.detected, self.standstill - self.braking
        return (self.speed * t1, self.speed * t2, self.speed * t3, self.speed * (at_speed + slowing / 2))

    def problems(self):
        """What a stop cannot be like, in words; none for a valid one."""
        found = [f"T{part} is negative" for part, time in zip(PARTS, self.times) if time < 0]
        if self.braking < self.detected:
            found.append("the robot braked before the light was detected")
        if abs(sum(self.lengths) - self.distance) > 1e-4:
            found.append(f"L1 to L4 make {sum(self.lengths):.5f}, the robot says {self.distance:.5f}")
        return found


def read_stops(path):
    """The stops in a file that stopwatch_node wrote, in their order."""
    with open(path, encoding="utf-8") as lines:
        return [Stop(**{name: float(value) for name, value in row.items()}) for row in csv.DictReader(lines)]


def middle(stops):
    """The stop with the median distance (the upper one of two): its parts add up, which medians of parts do not."""
    return sorted(stops, key=lambda stop: stop.distance)[len(stops) // 2]


@dataclasses.dataclass
class Comparison:
    """The stops of both versions, by run."""
    runs: list  # of {version: [Stop]}

    def middles(self, version):
        return [middle(run[version]) for run in self.runs]

    def every(self, version):
        return [stop for run in self.runs for stop in run[version]]

    def median_time(self, version, part):
        """Of every stop: T1 to T4 for part 0 to 3."""
        return statistics.median(stop.times[part] for stop in self.every(version))

    def median_distance(self, version):
        return statistics.median(stop.distance for stop in self.every(version))

    def shorter(self):
        """The number of runs in which the port stops earlier."""
        return sum(1 for original, ported in zip(*map(self.middles, VERSIONS)) if ported.distance < original.distance)

    def gained(self, part):
        """How much shorter a part is with the port, median over the runs."""
        return statistics.median(original.lengths[part] - ported.lengths[part]
                                 for original, ported in zip(*map(self.middles, VERSIONS)))

    def problems(self):
        """What cannot be, or contradicts that shared memory was used, in words."""
        found = [f"run {number}, {version}: {problem}" for number, run in enumerate(self.runs, 1)
                 for version in VERSIONS for stop in run[version] for problem in stop.problems()]
        if self.median_time("ported", 1) >= self.median_time("original", 1):
            found.append("T2 of the port is not shorter than the original's, in the median of all stops")
        return found
