#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Nodes of the release before and of this one on one graph: TCPROS, nothing lost, one line in the log of each.

usage: release_before.py NODES_BEFORE    (TZC_TEST_NODES: this release's; scripts/test.d/full/8-release-before)
"""
import os
import sys

import topic_case
from topic_case import TopicCase, main

BEFORE = sys.argv.pop(1)


class ReleaseBefore(TopicCase):
    def node(self, program, name, parameters, remaps=(), env=None, runner=()):
        """Nodes whose name begins so are of the release before."""
        folder = BEFORE if name.startswith("before") else topic_case.NODES
        command = [os.path.join(folder, program), f"__name:={name}", f"__ns:={self.ns}"]
        command += [f"_{key}:={value}" for key, value in parameters.items()]
        return self.ros.start(command, name=name, env=env)

    def lines_about(self, process, peer):
        return [line for line in process.log().splitlines() if "TZC" in line and self.name(peer) in line]

    def meet(self, talker_name, stranger_name, kin_name):
        """A talker, a listener of the other release, and one of its own, which gets shared memory all the same."""
        stranger, kin = self.listen(name=stranger_name), self.listen(name=kin_name)
        talker = self.start_talker(name=talker_name, count=100, rate=50, subscribers=2, shared=1)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(stranger, range(100), shared=False)
        self.assert_got(kin, range(100), shared=True)
        for process, peer in ((stranger.process, talker_name), (talker, stranger_name)):
            lines = self.lines_about(process, peer)
            self.assertEqual(len(lines), 1, process.log())
            self.assertIn("another version of TZC", lines[0])

    def test_a_talker_of_the_release_before(self):
        self.meet("before_talker", "listener", "before_listener")

    def test_a_listener_of_the_release_before(self):
        self.meet("talker", "before_listener", "listener")


if __name__ == "__main__":
    main()
