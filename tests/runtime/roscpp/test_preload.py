# SPDX-License-Identifier: BSD-3-Clause
"""tzc-run: shared memory for programs that were never ported."""
import json
import os

from topic_case import TZC_RUN, TopicCase, main


class Preload(TopicCase):
    def test_unported_listener_gets_shared_messages(self):
        listener = self.listen("plain", runner=TZC_RUN)
        counters = self.talk(count=50)
        self.assert_got(listener, range(50), shared=True)
        self.assertEqual(counters["copied_bytes"], 0)

    def test_unported_talker_sends_shared_messages(self):
        """With roscpp's one serialization, whose bytes are copied once."""
        listener = self.listen()
        counters = os.path.join(self.scratch, "counters")
        talker = self.start_talker("plain", count=50, bytes=100000, runner=TZC_RUN, env={"TZC_STATISTICS": counters})
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50))
        self.assert_seq_as_tcpros(listener)
        with open(counters) as lines:
            mine = [line for line in map(json.loads, lines) if line["topic"] == self.name("image")]
        self.assertEqual(len(mine), 1)
        self.assertTrue(50 * 100000 <= mine[0]["copied_bytes"] < 50 * 100200, mine)

    def test_both_unported(self):
        listener = self.listen("plain", runner=TZC_RUN)
        talker = self.start_talker("plain", count=0, rate=50, runner=TZC_RUN)
        self.wait_for(listener, 50)
        self.assertEqual(self.shared_transports(self.name("talker")), [self.name("image")])
        talker.stop()
        self.assert_got(listener, range(len(listener.numbers())))

    def test_a_program_that_is_not_roscpp_runs_as_ever(self):
        status, output = self.ros.run(TZC_RUN + ["rostopic", "list"])
        self.assertEqual(status, 0, output)
        self.assertIn("/rosout", output)

    def test_help_and_wrong_use(self):
        self.assertEqual(self.ros.run(TZC_RUN + ["--help"])[0], 0)
        self.assertEqual(self.ros.run(TZC_RUN)[0], 2)


if __name__ == "__main__":
    main()
