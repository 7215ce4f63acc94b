# SPDX-License-Identifier: BSD-3-Clause
"""A subscriber that stops, dies or keeps everything costs the others nothing."""
import json
import os

from topic_case import TZC_RUN, Listener, TopicCase, main


class StoppedPeers(TopicCase):
    def scene(self, scene, **parameters):
        stopper = self.node("stopper", "stopper", dict(parameters, scene=scene))
        self.assertEqual(stopper.wait(120), 0, stopper.tail())
        return {line["event"]: line["value"] for line in Listener(stopper).lines() if "event" in line}

    def test_a_stopped_node_does_not_delay_the_offers_to_others(self):
        """It is called about 12 topics and answers none of the calls; each is given up after 2 s."""
        topics = " ".join(f"image{i}" for i in range(12))
        stopped, healthy = [self.node("listener", name, {"topics": topics}) for name in ("stopped", "healthy")]
        for i in range(12):
            self.wait_for_subscribers(self.name(f"image{i}"), 2)
        events = self.scene("offers", pid=stopped.pid)
        self.assertLess(events["seconds until the healthy one is shared"], 6 * self.slowness())
        self.assertIn("both are shared", events)
        self.assertTrue(healthy.alive())

    def test_nothing_is_serialized_for_a_subscriber_that_was_killed(self):
        stopped, healthy = self.listen(), self.listen()
        events = self.scene("killed", pid=stopped.process.pid)
        self.assertEqual(events, {"serialized for the dead": 0})
        self.assert_got(healthy, range(51), shared=True)

    def test_publishing_goes_on_while_a_broken_channel_is_emptied(self):
        """roscpp's publish locks are not held while messages are serialized for TCPROS."""
        listener = self.listen(queue=1000)
        self.assertEqual(self.scene("return"), {"published meanwhile": 1})
        self.assert_got(listener, range(301))
        self.assert_seq_as_tcpros(listener)

    def test_a_move_that_finds_no_memory_is_tried_again(self):
        listener = self.listen(queue=1000)
        self.assertEqual(self.scene("memory"), {"refused": 1})
        self.assert_got(listener, range(301))
        self.assert_seq_as_tcpros(listener)

    def test_a_broken_channel_that_never_gets_empty_keeps_no_other_link_from_moving(self):
        self.listen(queue=10)
        self.listen(name="other", topic="other", remaps=("image:=other",))
        self.assertEqual(self.scene("endless"), {"another topic is shared meanwhile": 1})


class Hoarders(TopicCase):
    def test_a_subscriber_that_keeps_everything_takes_the_memory_from_nobody(self):
        """It holds half of the memory, and copies what comes then; a warning says so."""
        keeper, listener = self.listen("keep", queue=1000), self.listen(queue=1000)
        counters = self.talk(count=120, rate=100, subscribers=2, bytes=100000, memory=64 * 105000)
        self.assert_got(listener, range(120), shared=True)
        self.assert_got(keeper, range(120))
        shared = [m["shared"] for m in keeper.messages()]
        held = sum(shared)
        self.assertEqual(shared, held * [True] + (120 - held) * [False])
        self.assertTrue(20 <= held <= 40, held)
        self.assertEqual((counters["exhausted"], counters["serialized"], counters["dropped"]), (0, 0, 0))
        warnings = [line for line in keeper.process.log().splitlines() if "WARN" in line and "TZC" in line]
        self.assertEqual(len(warnings), 1, keeper.process.log())
        for word in (self.name("image"), self.name("talker"), f"holds {held} messages", "copied", "~tzc/memory_size"):
            self.assertIn(word, warnings[0])

    def test_a_subscriber_in_the_publishers_process_that_keeps_everything_takes_the_memory_from_nobody(self):
        listener = self.listen(queue=1000)
        for keep in (False, True):
            keeper = self.node("own_reader", f"own{int(keep)}", dict(
                {"tzc/memory_size": 64 * 105000}, ported=True, keep=keep, count=120, bytes=100000, subscribers=2, shared=1))
            self.assertEqual(keeper.wait(60), 0, keeper.tail())
            self.assert_got(Listener(keeper), range(120))
            warnings = [line for line in keeper.log().splitlines() if "WARN" in line and "TZC" in line]
            self.assertEqual(len(warnings), int(keep), keeper.log())
        self.assert_got(listener, [*range(120), *range(120)], shared=True)
        for word in (self.name("image"), "in its publisher's process hold", "copied", "~tzc/memory_size"):
            self.assertIn(word, warnings[0])

    def test_messages_that_wait_for_a_callback_take_the_memory_from_nobody(self):
        """All of them wait at once. What was copied keeps nothing of the publisher's memory."""
        waiting, listener = self.listen(spinner="afterwards", queue=1000), self.listen(queue=1000)
        counters = self.talk(count=120, rate=100, subscribers=2, bytes=100000, memory=64 * 105000)
        self.assert_got(listener, range(120), shared=True)
        self.assert_got(waiting, range(120))
        held = sum(m["shared"] for m in waiting.messages())
        self.assertTrue(20 <= held <= 40, held)
        self.assertEqual((counters["exhausted"], counters["serialized"], counters["dropped"]), (0, 0, 0))

    def test_serialized_messages_that_wait_for_a_callback_take_the_memory_from_nobody(self):
        """A program that is not ported publishes by reference: what roscpp serialized is copied once, and shared."""
        waiting, listener = self.listen(spinner="afterwards", queue=1000), self.listen(queue=1000)
        counters = os.path.join(self.scratch, f"counters{self.ns[1:]}")
        talker = self.start_talker("plain", count=120, rate=100, subscribers=2, bytes=100000, runner=TZC_RUN, settle=2,
                                   env={"TZC_STATISTICS": counters}, **{"tzc/memory_size": 64 * 105000})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(120), shared=True)
        self.assert_got(waiting, range(120))
        held = sum(m["shared"] for m in waiting.messages())
        self.assertTrue(20 <= held <= 40, held)
        with open(counters) as lines:
            mine = [line for line in map(json.loads, lines) if line["topic"] == self.name("image")][0]
        self.assertEqual((mine["copied_bytes"], mine["exhausted"], mine["dropped"]), (120 * 100000, 0, 0))

    def test_one_that_keeps_everything_of_two_topics_warns_of_each(self):
        """Though one place in the code warns of both, and at most once a minute."""
        keeper = self.listen("keep", queue=1000, topic="left", topics="left right")
        self.wait_for_subscribers(self.name("right"), 1)
        self.talk(count=60, topics="left right", bytes=100000, memory=64 * 105000)
        for topic in ("left", "right"):
            self.assert_got(keeper, range(60), topic=topic)
        for topic in ("left", "right"):
            warnings = [line for line in self.warnings(keeper.process) if f"{self.name(topic)}: this node holds" in line]
            self.assertEqual(len(warnings), 1, keeper.process.log())


if __name__ == "__main__":
    main()
