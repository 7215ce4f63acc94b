# SPDX-License-Identifier: BSD-3-Clause
"""100 upgrades under 2 kHz traffic: no message twice, none out of order, none lost that plain ROS would deliver."""
import json
import os
import statistics

from topic_case import TopicCase, main


class ManyUpgrades(TopicCase):
    HOPS = int(os.environ.get("TZC_HOPS", 100))
    PATIENCE = float(os.environ.get("TZC_PATIENCE", 10))  # seconds for a hop; ThreadSanitizer takes many

    SLOWEST = float(os.environ.get("TZC_SLOWEST", 0.8))  # of 2 kHz, on a machine that has nothing else to do

    def hop(self, talker_parameters, **parameters):
        talker = self.start_talker("twin", count=0, rate=2000, bytes=5000, subscribers=0, settle=0, memory=200000000,
                                   **dict({"queue": 10000}, **talker_parameters))
        hopper = self.node("hopper", "hopper", parameters)
        self.assertEqual(hopper.wait(110 + self.PATIENCE), 0, hopper.tail())
        self.assertTrue(talker.alive(), talker.tail())
        lines = [line for line in hopper.log().splitlines() if line.startswith("{")]
        return [json.loads(line) for line in lines]

    def assert_complete(self, hops):
        self.assertEqual(len(hops), self.HOPS, hops)
        self.assertEqual([hop["jumps"] for hop in hops if hop["jumps"]], [], "lost, doubled or out of order")
        self.assertEqual([hop["misnumbered"] for hop in hops if hop["misnumbered"]], [], "[number, header.seq]")
        self.assertTrue(all(hop["right"] for hop in hops))
        # Not the mean: a machine that stands still for a second shows in few hops, and its load tells nothing of it.
        rate = statistics.median((hop["count"] - 1) / max(hop["seconds"], 1e-9) for hop in hops)
        self.assertGreater(rate, 2000 * self.SLOWEST / self.slowness(), "the traffic")

    def test_up(self):
        hops = self.hop({}, hops=self.HOPS, shared=50, patience=self.PATIENCE)
        self.assert_complete(hops)
        self.assertEqual([hop for hop in hops if hop["shared"] < 50], [], "not upgraded")
        before = sum(hop["count"] - hop["shared"] for hop in hops)
        self.assertGreater(before, self.HOPS / 2, "the upgrades met no traffic on TCPROS")

    def test_up_and_down_again(self):
        """The subscriber runs out of descriptors, so that it cannot take the next segment; the process lives on."""
        hops = self.hop({"fresh": 20}, hops=self.HOPS, shared=50, returned=50, patience=self.PATIENCE)
        self.assert_complete(hops)
        self.assertEqual([hop for hop in hops if hop["shared"] < 50 or hop["returned"] < 50], [], "not both ways")


if __name__ == "__main__":
    main()
