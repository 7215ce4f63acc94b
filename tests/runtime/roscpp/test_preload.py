# SPDX-License-Identifier: BSD-3-Clause
"""tzc-run: shared memory for programs that were never ported."""
import json
import os
import shutil

from topic_case import TZC_RUN, Listener, TopicCase, main


class Preload(TopicCase):
    def test_unported_listener_gets_shared_messages(self):
        listener = self.listen("plain", runner=TZC_RUN)
        counters = self.talk(count=50)
        self.assert_got(listener, range(50), shared=True)
        self.assertEqual(counters["copied_bytes"], 0)

    def test_a_filter_that_gives_messages_other_memory_has_its_own(self):
        """message_filters' subscriber says that it only reads; what is registered with it may write."""
        listener = self.listen("stock_filter", runner=TZC_RUN)
        self.assertEqual(self.talk(count=50)["shared"], 50)
        self.assert_got(listener, range(50), shared=False)
        self.assertTrue(listener.process.alive(), listener.process.tail())

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

    def assert_alternates(self, mode="plain_alternating", runner=TZC_RUN, **how):
        """What is published by reference waits in roscpp's queue, which what is published by pointer must not overtake."""
        listener = self.listen(queue=2000)
        talker = self.start_talker(mode, count=1000, bytes=5000, rate=1000000, queue=2000, settle=1, runner=runner,
                                   linger=5, **how)
        self.assertEqual(self.last_published(talker), 999)
        self.assertEqual(self.shared_transports(self.name("talker")), [self.name("image")])
        self.assert_got(listener, range(1000))
        self.assert_seq_as_tcpros(listener)
        self.assertEqual(talker.wait(60), 0, talker.tail())

    def test_by_reference_and_by_pointer_in_turn(self):
        self.assert_alternates()

    def test_by_reference_and_by_pointer_in_turn_beside_a_callback_of_the_same_process(self):
        self.assert_alternates(beside=True, subscribers=2)

    def test_by_reference_and_by_pointer_in_turn_with_an_attached_publisher(self):
        self.assert_alternates("foreign_attached_alternating", runner=())

    def test_options_that_advertise_a_second_topic(self):
        twice = self.node("twice", "twice", {}, runner=TZC_RUN)
        self.assertEqual(twice.wait(30), 0, twice.tail())
        self.assertEqual(Listener(twice).lines(), [{"event": "a callback is in them", "happened": False}])

    def test_both_unported(self):
        listener = self.listen("plain", runner=TZC_RUN)
        talker = self.start_talker("plain", count=0, rate=50, runner=TZC_RUN)
        self.wait_for(listener, 50)
        self.assertEqual(self.shared_transports(self.name("talker")), [self.name("image")])
        talker.stop()
        self.assert_got(listener, range(len(listener.numbers())))

    def talk_with_too_little_memory(self, **how):
        """An unmodified talker whose messages find no memory; it, and its counters."""
        counters = os.path.join(self.scratch, f"counters{self.ns[1:]}")
        talker = self.start_talker("plain", count=20, bytes=100000, runner=TZC_RUN, env={"TZC_STATISTICS": counters},
                                   settle=2, **{"tzc/memory_size": "1000"}, **how)
        self.assertEqual(talker.wait(30), 0, talker.tail())
        with open(counters) as lines:
            return talker, [line for line in map(json.loads, lines) if line["topic"] == self.name("image")][0]

    def assert_warned(self, talker, *words):
        warnings = self.warnings(talker)
        self.assertEqual(len(warnings), 1, talker.log())
        for word in (self.name("image"), "no shared memory for a message of 100", "larger than the whole memory",
                     "Set ~tzc/memory_size to", "(now 1000)", *words):
            self.assertIn(word, warnings[0])

    def test_too_little_memory_is_warned_about(self):
        listener = self.listen()
        talker, counters = self.talk_with_too_little_memory()
        self.assert_got(listener, range(20), shared=False)
        self.assertEqual((counters["exhausted"], counters["dropped"]), (20, 0))
        self.assert_warned(talker, "sent serialized")

    def test_what_finds_no_memory_is_dropped_if_that_is_set(self):
        """For subscribers on shared memory, as with a ported talker; those on TCPROS need none of it."""
        listener, plain = self.listen(), self.listen("plain")
        talker, counters = self.talk_with_too_little_memory(subscribers=2, **{"tzc/on_exhausted": "drop"})
        self.assert_got(plain, range(20))
        self.assert_got(listener, [])
        self.assertEqual((counters["exhausted"], counters["dropped"]), (20, 20))
        self.assert_warned(talker, "dropped, as ~tzc/on_exhausted says")

    def test_a_program_that_is_not_roscpp_runs_as_ever(self):
        status, output = self.ros.run(TZC_RUN + ["rostopic", "list"])
        self.assertEqual(status, 0, output)
        self.assertIn("/rosout", output)

    def test_help_and_wrong_use(self):
        self.assertEqual(self.ros.run(TZC_RUN + ["--help"])[0], 0)
        self.assertEqual(self.ros.run(TZC_RUN)[0], 2)
        for wrong in (["-c", "env"], ["--guard", "-c", "env"], ["--guard"], ["--guard=quietly", "env"]):
            self.assertEqual(self.ros.run(TZC_RUN + wrong)[0], 2, wrong)
        self.assertIn("usage: tzc-run", self.ros.run(TZC_RUN + ["--guard", "--help"])[1])

    def test_options_end_before_the_command(self):
        for words in (["--guard"], ["--guard", "--"], ["--guard=abort", "--guard"]):
            status, output = self.ros.run(TZC_RUN + words + ["env"])
            self.assertEqual(status, 0, output)
            self.assertRegex(output, r"(?m)^TZC_GUARD=1$")
        self.assertEqual(self.ros.run(TZC_RUN + ["--", "-no-such-command"])[0], 127)

    def test_a_path_that_nothing_can_be_preloaded_from(self):
        for name in ("a blank", "a:colon"):
            folder = os.path.join(self.scratch, name)
            for part in ("bin", "lib"):
                os.makedirs(os.path.join(folder, part))
            tool = shutil.copy(TZC_RUN[0], os.path.join(folder, "bin"))
            with open(os.path.join(folder, "lib/libtzc_preload.so"), "w"):
                pass
            status, output = self.ros.run([tool, "env"])
            self.assertEqual((status, "preloads nothing from a path" in output), (2, True), output)


if __name__ == "__main__":
    main()
