# SPDX-License-Identifier: BSD-3-Clause
"""Nodes that die, stop or are killed under load, and memory that is full: no other node suffers."""
import signal
import time

from topic_case import TopicCase, main


class Killed(TopicCase):
    def test_killed_publisher_among_others(self):
        listener = self.listen(queue=1000)
        victim = self.start_talker(name="victim", count=0, rate=200, subscribers=1)
        self.wait_for(listener, 50)
        other = self.start_talker(name="other", first=1000000, count=300, rate=200)
        self.wait_for_number(listener, 1000050)
        victim.kill()
        self.assertEqual(other.wait(30), 0)
        self.wait_for_number(listener, 1000299)
        messages = listener.messages()
        self.assertTrue(all(m["right"] for m in messages))
        for numbers, first in (([m["number"] for m in messages if m["number"] < 1000000], 0),
                               ([m["number"] for m in messages if m["number"] >= 1000000], 1000000)):
            self.assertEqual(numbers, list(range(first, first + len(numbers))))
        self.assertEqual([m["number"] for m in messages][-1], 1000299)
        self.assertEqual(sum(m["number"] >= 1000000 for m in messages), 300)
        self.assertTrue(all(m["shared"] for m in messages))

    def test_killed_subscribers_disturb_nobody(self):
        victims, survivor = [self.listen() for _ in range(2)], self.listen(queue=1000, answers="had")
        talker = self.start_talker(count=500, rate=200, subscribers=3, queue=100, echo="had", ahead=50)
        for victim in victims:
            self.wait_for(victim, 50)
            victim.process.kill()
        self.assertEqual(talker.wait(40), 0)
        self.assert_got(survivor, range(500), shared=True)

    def test_rosnode_kill(self):
        victim, survivor = self.listen(name="victim"), self.listen()
        talker = self.start_talker(count=0, rate=100, subscribers=2)
        self.wait_for(victim, 30)
        self.assertEqual(self.ros.run(["rosnode", "kill", self.name("victim")])[0], 0)
        self.assertEqual(victim.process.wait(10), 0)
        seen = len(survivor.numbers())
        self.wait_for(survivor, seen + 50)
        self.assertEqual(self.ros.run(["rosnode", "kill", self.name("talker")])[0], 0)
        self.assertEqual(talker.wait(10), 0)
        messages = survivor.messages()
        self.assertEqual([m["number"] for m in messages], list(range(len(messages))))
        self.assertTrue(all(m["right"] and m["shared"] for m in messages))

    def test_killed_publisher_comes_back(self):
        listener = self.listen()
        for life in range(3):
            talker = self.start_talker(first=1000 * life, count=0, rate=100)
            self.ros.wait_until(lambda: listener.numbers() and listener.numbers()[-1] >= 1000 * life + 20, 20, "a life")
            talker.kill()
        for life in range(3):
            mine = [m for m in listener.messages() if m["number"] // 1000 == life]
            self.assertEqual([m["number"] for m in mine], list(range(1000 * life, 1000 * life + len(mine))))
            self.assertTrue(all(m["right"] for m in mine))
        self.assertTrue(mine[-1]["shared"])


class Stopped(TopicCase):
    def test_subscriber_stopped_for_five_seconds(self):
        sleeper, survivor = self.listen(queue=2000), self.listen(queue=1000, answers="had")
        plain = self.listen("plain", queue=1000, answers="had")
        talker = self.start_talker(count=1400, rate=200, subscribers=3, shared=2, memory=30000000, queue=100,
                                   echo="had", echoes=2, ahead=50)
        self.wait_for(sleeper, 50)
        sleeper.process.popen.send_signal(signal.SIGSTOP)
        time.sleep(5)
        sleeper.process.popen.send_signal(signal.SIGCONT)
        self.assertEqual(talker.wait(60), 0)
        self.assert_got(survivor, range(1400), shared=True)
        self.assert_got(plain, range(1400), shared=False)
        self.wait_for_number(sleeper, 1399)
        numbers = sleeper.numbers()
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(numbers[-1], 1399)
        self.assertTrue(all(m["right"] and m["shared"] and m["seq"] == m["number"] for m in sleeper.messages()))
        counters = self.counters(talker)
        self.assertGreater(counters["revoked"], 0)
        self.assertEqual(counters["revoked"], 1400 - len(numbers), "what it lost is counted")
        self.assertEqual((counters["exhausted"], counters["copied_bytes"]), (0, 0))

    def test_stopped_publisher_goes_on(self):
        listener = self.listen()
        talker = self.start_talker(count=300, rate=100)
        self.wait_for(listener, 50)
        talker.popen.send_signal(signal.SIGSTOP)
        time.sleep(2)
        talker.popen.send_signal(signal.SIGCONT)
        self.assertEqual(talker.wait(40), 0)
        self.assert_got(listener, range(300), shared=True)


class Full(TopicCase):
    """Memory for three messages, and a subscriber that keeps all it gets. Both have had a message before the next one is
    published: best_effort would take back what a busy machine has them take late."""
    BYTES = 100000

    def with_full_memory(self, policy, on_exhausted):
        self.ros.stop_since(self.before)  # the policy before
        listeners = [self.listen(mode, queue=1000, answers="had") for mode in ("keep", "pointer")]
        env = {"TZC_POLICY": policy, "TZC_ON_EXHAUSTED": on_exhausted}
        counters = self.talk(count=60, rate=200, subscribers=2, env=env, memory=400000, bytes=self.BYTES, queue=100,
                             echo="had", echoes=2)
        return listeners, counters

    def test_every_policy_delivers_serialized_and_in_order(self):
        """No policy takes memory from a subscriber that holds it; a message that finds no memory travels whole."""
        for policy in ("best_effort", "medium_effort", "worst_effort"):
            with self.subTest(policy):
                listeners, counters = self.with_full_memory(policy, "deliver")
                room = 60 - counters["exhausted"]
                self.assertIn(room, (2, 3))
                for listener in listeners:
                    self.assert_got(listener, range(60))
                    self.assertEqual([m["shared"] for m in listener.messages()], room * [True] + (60 - room) * [False])
                    self.assert_seq_as_tcpros(listener)
                self.assertEqual([counters[count] for count in ("shared", "serialized", "dropped", "revoked")],
                                 [2 * room, 2 * (60 - room), 0, 0])

    def test_every_policy_drops_when_told_to(self):
        for policy in ("best_effort", "medium_effort", "worst_effort"):
            with self.subTest(policy):
                listeners, counters = self.with_full_memory(policy, "drop")
                room = 60 - counters["dropped"]
                self.assertIn(room, (2, 3))
                for listener in listeners:
                    self.assert_got(listener, range(room), shared=True)
                self.assertEqual([counters[count] for count in ("shared", "serialized", "exhausted", "revoked")],
                                 [2 * room, 0, 60 - room, 0])


class Revoked(TopicCase):
    def test_best_effort_takes_back_what_a_stopped_subscriber_has_not_read(self):
        """Memory for 20 messages: the stopped one finds the newest of them, and is counted out of the others."""
        sleeper, survivor = self.listen(queue=1000), self.listen(queue=1000, answers="had")
        talker = self.start_talker(count=300, rate=100, subscribers=2, queue=50, memory=20 * 105000,
                                   env={"TZC_POLICY": "best_effort"}, echo="had", ahead=5)
        self.wait_for(sleeper, 20)
        sleeper.process.popen.send_signal(signal.SIGSTOP)
        self.wait_for(survivor, 200)
        # What the sleeper finds fills the memory until its callbacks have had it; the talker waits for that.
        talker.popen.send_signal(signal.SIGSTOP)
        sleeper.process.popen.send_signal(signal.SIGCONT)
        self.wait_for_number(sleeper, survivor.numbers()[-1] - 1)
        talker.popen.send_signal(signal.SIGCONT)
        self.assertEqual(talker.wait(40), 0, talker.tail())
        counters = self.counters(talker)
        self.assert_got(survivor, range(300), shared=True)
        self.wait_for_number(sleeper, 299)
        numbers = sleeper.numbers()
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(numbers[-1], 299)
        self.assertTrue(all(m["right"] and m["shared"] for m in sleeper.messages()))
        self.assertGreater(counters["revoked"], 100)
        self.assertEqual(counters["revoked"], 300 - len(numbers))
        self.assertEqual((counters["exhausted"], counters["serialized"], counters["copied_bytes"]), (0, 0, 0))


class TooManySegments(TopicCase):
    def test_a_subscriber_that_cannot_take_another_segment_goes_back_to_tcpros(self):
        listener = self.listen(queue=1000)
        hoarder = self.node("hoarder", "hoarder", {"segments": 300, "then": 100})
        self.assertEqual(hoarder.wait(60), 0, hoarder.tail())
        messages = listener.messages()
        numbers = [m["number"] for m in messages]
        self.assertEqual(numbers, list(range(400)))
        self.assertTrue(all(m["right"] for m in messages))
        self.assert_seq_as_tcpros(listener)
        self.assertEqual(self.shared(messages[:200]), 200)
        self.assertEqual(self.shared(messages[-100:]), 0)

    @staticmethod
    def shared(messages):
        return sum(m["shared"] for m in messages)


if __name__ == "__main__":
    main()
