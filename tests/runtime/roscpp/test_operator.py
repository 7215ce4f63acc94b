# SPDX-License-Identifier: BSD-3-Clause
"""An operator's first look at a graph in which three nodes are in trouble: tzc-monitor's list of problems names these
three, says why and what to do, and nothing else. TZC_TRIAL_PAIRS: so many pairs of nodes that are well beside them."""
import os
import re
import signal

from test_monitor import MonitorCase
from topic_case import main

HEALTHY_PAIRS = int(os.environ.get("TZC_TRIAL_PAIRS", "2"))
BYTES = 100000


class Operator(MonitorCase):
    def pair(self, name, mode="pointer", shared=1, **parameters):
        """A camera and its viewer on a topic of their own; the viewer."""
        topic = f"{name}/image"
        viewer = self.listen(mode, name=f"{name}_viewer", remaps=[f"image:={topic}"], topic=topic)
        self.start_talker(name=f"{name}_camera", remaps=[f"image:={topic}"], count=0, rate=20, bytes=BYTES, shared=shared,
                          **parameters)
        return viewer

    def is_shared(self, name):
        """A process that stops before it is connected has no page, and nobody's page tells of it."""
        status, why, _ = self.monitor("--why", self.name(f"{name}_viewer"), self.name(f"{name}/image"))
        return status == 0 and "through shared memory" in why

    def problems(self):
        """What the list says of this test's nodes, by its kinds, and the line above it."""
        _, screen, _ = self.monitor("--once")
        found = re.findall(rf"^  (\w+) +(.*{self.ns}/.*)$", screen.partition("PROBLEMS\n")[2].partition("\n\n")[0], re.M)
        return {kind: text for kind, text in found}, len(found), screen.splitlines()[0]

    def test_three_nodes_in_trouble_are_found_in_one_look(self):
        for number in range(HEALTHY_PAIRS):
            self.pair(f"well{number}")
        self.pair("unported", mode="plain", shared=0)
        self.pair("hoarding", mode="keep", memory=4 * (BYTES + 5000))
        stopped = self.pair("frozen").process
        self.ros.wait_until(lambda: self.is_shared("frozen"), 20, "the viewer that will stop")
        stopped.popen.send_signal(signal.SIGSTOP)
        looks = []

        def all_are_named():
            looks.append(self.problems())
            texts, lines, _ = looks[-1]
            return set(texts) == {"stopped", "memory", "TCPROS"} and lines == 3  # on a busy machine others are late at times
        try:
            self.ros.wait_until(all_are_named, 60, "these three problems alone")
        except RuntimeError as late:
            self.fail(f"{late}; the last look: {looks[-1]}")
        finally:
            stopped.popen.send_signal(signal.SIGCONT)
        texts, _, summary = looks[-1]
        self.assertRegex(texts["stopped"], rf"^{self.name('frozen_viewer')} \(process {stopped.pid}\) is stopped")
        self.assertIn(f"kill -CONT {stopped.pid}", texts["stopped"])
        self.assertIn(f"{self.name('hoarding_camera')} has no shared memory left", texts["memory"])
        self.assertRegex(texts["memory"], rf"{self.name('hoarding_viewer')} holds \d+ blocks.*Raise ~tzc/memory_size")
        self.assertRegex(texts["TCPROS"], rf"^{self.name('unported_camera')} .* to {self.name('unported_viewer')} over TCPROS: "
                                          rf"{self.name('unported_viewer')} has not attached .* use tzc::subscribe")
        self.assertRegex(summary, r"^\d+ nodes, \d+ connections \(\d+ shared, .*1 stopped, .*\bmemory.*\bTCPROS\.$")


if __name__ == "__main__":
    main()
