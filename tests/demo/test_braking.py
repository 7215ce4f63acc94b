# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/demo --red-light and --rotation make of measured moments."""
import dataclasses
import os
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
from braking import Comparison, Stop, middle, read_stops  # noqa: E402
from braking_plot import draw  # noqa: E402

HEADER = "published,received,detected,braking,standstill,speed,distance\n"


def stop(transport=0.010, **changed):
    """At 0.6 m/s, braking with 1.5 m/s2: 20 ms to the image, then the transport, 5 ms detection, 1 ms to the robot."""
    braking = 0.020 + transport + 0.005 + 0.001
    valid = Stop(published=0.020, received=0.020 + transport, detected=0.025 + transport, braking=braking,
                 standstill=braking + 0.4, speed=0.6, distance=0.6 * braking + 0.12)
    return dataclasses.replace(valid, **changed)


def comparison(*transports):
    """Runs of one stop in each version: (original's transport, port's)."""
    return Comparison([{"original": [stop(before)], "ported": [stop(after)]} for before, after in transports])


class AStop(unittest.TestCase):
    def test_is_split_into_times_that_follow_each_other(self):
        for time, expected in zip(stop().times, (0.020, 0.010, 0.005, 0.401)):
            self.assertAlmostEqual(time, expected)

    def test_is_split_into_the_lengths_that_the_robot_moves_in_them(self):
        for length, expected in zip(stop().lengths, (0.012, 0.006, 0.003, 0.1206)):
            self.assertAlmostEqual(length, expected)

    def test_has_parts_that_make_the_distance(self):
        self.assertEqual(stop().problems(), [])

    def test_has_a_problem_when_the_parts_do_not_make_the_distance(self):
        self.assertIn("the robot says 0.14200", stop(distance=0.142).problems()[0])

    def test_has_a_problem_when_the_image_was_published_before_the_line(self):
        self.assertEqual(stop(published=-0.001).problems(), ["T1 is negative"])

    def test_has_a_problem_when_the_robot_braked_for_something_else(self):
        early = stop(braking=0.030, standstill=0.430, distance=0.6 * 0.030 + 0.12)
        self.assertEqual(early.problems(), ["the robot braked before the light was detected"])

    def test_is_read_as_it_was_written(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write(HEADER + "0.02,0.03,0.035,0.036,0.436,0.6,0.1416\n")
            file.flush()
            self.assertEqual(read_stops(file.name), [stop()])

    def test_is_the_middle_one_by_distance(self):
        stops = [stop(0.030), stop(0.001), stop(0.010)]
        self.assertIs(middle(stops), stops[2])


class AComparison(unittest.TestCase):
    def test_counts_the_runs_in_which_the_port_stops_earlier(self):
        self.assertEqual(comparison((0.010, 0.001), (0.010, 0.011), (0.012, 0.001)).shorter(), 2)

    def test_does_not_count_a_tie(self):
        self.assertEqual(comparison((0.010, 0.010)).shorter(), 0)

    def test_says_which_part_became_shorter(self):
        gains = [comparison((0.010, 0.001)).gained(part) for part in range(4)]
        for gain, expected in zip(gains, (0, 0.0054, 0, 0)):
            self.assertAlmostEqual(gain, expected)

    def test_without_a_shorter_transport_has_a_problem(self):
        self.assertIn("T2 of the port", comparison((0.010, 0.010)).problems()[0])
        self.assertEqual(comparison((0.010, 0.001)).problems(), [])

    def test_names_the_run_and_the_version_of_a_problem(self):
        runs = comparison((0.010, 0.001), (0.010, 0.001))
        runs.runs[1]["ported"] = [stop(0.001, distance=0.5)]
        self.assertTrue(runs.problems()[0].startswith("run 2, ported: L1 to L4 make"))


class ThePicture(unittest.TestCase):
    def test_is_drawn_as_svg_and_png(self):
        with tempfile.TemporaryDirectory() as folder:
            svg, png = draw(comparison((0.010, 0.001), (0.012, 0.001)), os.path.join(folder, "stops"), "A title", "mm", 1000)
            text = "".join(xml.etree.ElementTree.parse(svg).getroot().itertext())
            for label in ("A title", "/ mm", "L1 camera", "L2 transport", "L3 detection", "L4 braking", "port"):
                self.assertIn(label, text)
            with open(png, "rb") as file:
                self.assertEqual(file.read(4), b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
