# SPDX-License-Identifier: BSD-3-Clause
"""A failed upgrade is retried: no subscriber stays on TCPROS by accident."""
import os
import sys

from topic_case import Listener, TopicCase, main

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from master_proxy import MasterProxy  # noqa: E402
from ros_session import ReservedPort  # noqa: E402


class Tries(TopicCase):
    def assert_comes_to_shared_memory(self, listener, talker, timeout=30):
        """In the end, and without a gap."""
        self.ros.wait_until(lambda: any(m["shared"] for m in listener.messages()), timeout,
                            "messages in shared memory")
        self.wait_for(listener, len(listener.numbers()) + 20)
        self.assertEqual(talker.stop(), 0)
        messages = listener.messages()
        moved = [m["shared"] for m in messages].index(True)
        self.assert_got(listener, range(messages[0]["number"], messages[0]["number"] + len(messages)))
        self.assertTrue(all(m["shared"] for m in messages[moved:]))
        return messages


class SlowMaster(Tries):
    """The publisher's master is one whose answers are late, wrong or missing, when it asks where the subscriber is."""

    def setUp(self):
        super().setUp()
        self.proxy = MasterProxy(self.ros.uri)
        self.addCleanup(self.proxy.__exit__)
        self.proxy.__enter__()

    def start_talker_under(self, count, rule, **parameters):
        self.proxy.first("lookupNode", count, rule)
        env = {"ROS_MASTER_URI": self.proxy.uri, **parameters.pop("env", {})}
        return self.start_talker(**dict({"count": 0, "rate": 50, "settle": 0}, **parameters), env=env)

    def test_a_master_that_does_not_know_the_subscriber_yet(self):
        listener = self.listen()
        talker = self.start_talker_under(4, MasterProxy.unknown)
        self.assert_comes_to_shared_memory(listener, talker)
        self.assertEqual(self.proxy.calls("lookupNode"), 5)

    def test_a_talker_of_these_tests_begins_when_its_subscriber_is_on_shared_memory(self):
        """However late: half a second was a guess, which a busy machine proved wrong."""
        listener = self.listen()
        self.proxy.first("lookupNode", 3, MasterProxy.unknown)
        talker = self.start_talker(count=20, env={"ROS_MASTER_URI": self.proxy.uri})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=True)
        self.assertEqual(self.proxy.calls("lookupNode"), 4)

    def test_a_master_that_hangs_up(self):
        listener = self.listen()
        talker = self.start_talker_under(2, MasterProxy.hang_up)
        self.assert_comes_to_shared_memory(listener, talker)

    def test_a_master_that_does_not_answer_in_time(self):
        """And waiting for it costs next to no processor time."""
        listener = self.listen()
        talker = self.start_talker_under(1, MasterProxy.wait_for_another)
        self.ros.wait_until(lambda: self.proxy.calls("lookupNode") == 1, 20, "the first question")
        before = self.processor_seconds(talker)
        self.ros.wait_until(lambda: self.proxy.calls("lookupNode") == 2, 20, "the second question")
        spent = self.processor_seconds(talker) - before
        self.assert_comes_to_shared_memory(listener, talker)
        self.assertLess(spent, 0.8, "seconds of processor time while it waited for 2 s")

    @staticmethod
    def processor_seconds(process):
        with open(f"/proc/{process.pid}/stat") as stat:
            user, system = stat.read().rsplit(")", 1)[1].split()[11:13]
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")

    def test_a_subscriber_that_cannot_be_reached_yet(self):
        listener = self.listen()
        port = ReservedPort()
        self.addCleanup(port.close)
        nobody = f"http://127.0.0.1:{port.number}/"
        talker = self.start_talker_under(5, lambda *_: [1, "", nobody])
        self.assert_comes_to_shared_memory(listener, talker, timeout=40)

    def test_some_tries_are_followed_by_one_warning_and_more_tries(self):
        """It says what, where, why and what to do. Who subscribes later is not concerned."""
        listener = self.listen()
        talker = self.start_talker_under(5, MasterProxy.unknown, env={"TZC_UPGRADE_ATTEMPTS": "3"})
        self.ros.wait_until(lambda: "stays on TCPROS" in talker.log(), 20, "the warning")
        self.assertFalse(any(m["shared"] for m in listener.messages()))
        newcomer = self.listen()
        self.ros.wait_until(lambda: any(m["shared"] for m in newcomer.messages()), 20, "the newcomer's move")
        self.assert_comes_to_shared_memory(listener, talker)
        self.assertEqual(self.proxy.calls("lookupNode"), 7)
        warnings = [line for line in talker.log().splitlines() if "WARN" in line and "TZC" in line]
        self.assertEqual(len(warnings), 1, talker.log())
        for word in (self.name("image"), "/listener_", "after 3 tries", self.proxy.uri, "unknown node", "rosnode info",
                     "asked again, at last every five minutes", "when it subscribes anew"):
            self.assertIn(word, warnings[0])


class Moves(Tries):
    def race(self, race, **parameters):
        racer = self.node("racer", "racer", dict(parameters, race=race))
        self.assertEqual(racer.wait(60), 0, racer.tail())
        return {line["event"]: line["happened"] for line in Listener(racer).lines() if "event" in line}

    def test_a_publisher_that_takes_longer_to_move_than_the_subscriber_would_wait(self):
        listener = self.listen()
        self.assertEqual(self.race("slow_move"), {"parked": True, "returned": False})
        self.assert_got(listener, range(10), shared=True)

    def test_a_broken_channel_is_followed_by_another(self):
        listener = self.listen(queue=1000)
        hoarder = self.node("hoarder", "hoarder", {"segments": 300, "then": 0, "until_shared": 50})
        self.assertEqual(hoarder.wait(90), 0, hoarder.tail())
        messages = listener.messages()
        self.assert_got(listener, range(len(messages)))
        self.assert_seq_as_tcpros(listener)
        shared = [m["shared"] for m in messages]
        returned = shared.index(False)
        self.assertGreaterEqual(returned, 200)
        self.assertIn(True, shared[returned:])
        self.assertTrue(all(shared[-40:]))

    def test_a_late_attachment_whose_publisher_does_not_answer_in_time(self):
        talker = self.start_talker(count=0, rate=50, subscribers=0, settle=0)
        self.ros.wait_until(lambda: self.ros.publishers(self.name("image")), 20, "the talker")
        racer = self.node("racer", "racer", {"race": "late_attach", "pid": talker.pid})
        listener = Listener(racer)
        self.assert_comes_to_shared_memory(listener, talker)
        self.assertFalse(listener.messages()[0]["shared"])

    def test_a_channel_that_ends_before_the_subscriber_has_noted_it(self):
        listener = Listener(self.node("racer", "racer", {"race": "cut_short"}))
        talker = self.start_talker(count=0, rate=50, settle=0)
        self.ros.wait_until(lambda: "cut" in listener.process.log(), 30, "the channel's end")
        before = len(listener.messages())
        self.ros.wait_until(lambda: len(listener.messages()) > before + 50 and all(m["shared"] for m in listener.messages()[-20:]),
                            40, "messages in shared memory again")
        self.assertEqual(talker.stop(), 0)
        messages = listener.messages()
        self.assert_got(listener, range(messages[0]["number"], messages[0]["number"] + len(messages)))


if __name__ == "__main__":
    main()
