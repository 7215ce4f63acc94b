# SPDX-License-Identifier: BSD-3-Clause
"""Reads traces that TZC_TRACE makes, and finds the steps of each message in them."""
import collections
import glob
import json

ORDER = ("publish", "publish by roscpp", "wake", "take", "callback")


def events_of(path):
    """All whole lines; the last one of a process that was killed may be cut."""
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    return [json.loads(line.rstrip(",")) for line in lines if line.startswith("{") and line.endswith(("},", "}"))]


def is_strict_json(path):
    with open(path, encoding="ascii") as file:
        try:
            return isinstance(json.load(file), list)
        except ValueError:
            return False


def load(pattern):
    return [event for path in glob.glob(pattern) for event in events_of(path)]


class Trace:
    def __init__(self, events):
        self.events = events
        self.steps = collections.defaultdict(dict)  # of a message: category -> slice
        self.flows = collections.defaultdict(lambda: collections.defaultdict(list))  # of a message: phase -> points
        for event in events:
            if event["ph"] == "X":
                self.steps[event["args"]["message"]].setdefault(event["cat"], event)
            elif event["ph"] in "stf":
                self.flows[event["id"]][event["ph"]].append(event)

    def names(self, kind):
        return {event["args"]["name"] for event in self.events if event["ph"] == "M" and event["name"] == kind}

    def slices(self, category):
        return [event for event in self.events if event["ph"] == "X" and event["cat"] == category]

    def left_out(self):
        return max((event["args"]["events"] for event in self.events if event["ph"] == "C"), default=0)

    def complete(self, *categories):
        """The messages that have all these steps."""
        return {message: steps for message, steps in self.steps.items() if all(one in steps for one in categories)}

    def check_order(self, test, message):
        """Each step begins after the one before it, and a flow leads through those of different threads."""
        steps = [self.steps[message][one] for one in ORDER if one in self.steps[message]]
        begins = [step["ts"] for step in steps]
        test.assertEqual(begins, sorted(begins), steps)
        for step in steps:
            test.assertGreaterEqual(step["dur"], 0)
        points = self.flows[message]
        test.assertEqual((len(points["s"]), len(points["f"])), (1, 1), (message, dict(points)))
        for point in points["s"] + points["t"] + points["f"]:  # a point binds to a slice that encloses it
            test.assertTrue(any(step["pid"] == point["pid"] and step["tid"] == point["tid"] and
                                step["ts"] <= point["ts"] <= step["ts"] + step["dur"] for step in steps), (point, steps))
