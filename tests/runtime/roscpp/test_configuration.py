# SPDX-License-Identifier: BSD-3-Clause
"""Every row of docs/configuration.md does what it says, as a ROS parameter and from the environment."""
import json
import os
import re
import signal
import sys

from topic_case import Listener, TopicCase, main

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from master_proxy import MasterProxy  # noqa: E402


class Configuration(TopicCase):
    def in_both_ways(self, name, value, check):
        """`check` is called with a node's extra arguments that set `name`: by parameter, then by environment."""
        for how, arguments in (("parameter", {f"tzc/{name}": value}),
                               ("environment", {"env": {"TZC_" + name.upper(): value}})):
            self.forget()
            with self.subTest(f"{name} {value} by {how}"):
                check(**arguments)
        self.forget()

    def forget(self):
        """Parameters outlive the nodes that brought them."""
        self.ros.stop_since(self.before)
        if self.ros.master.hasParam("/tzc_test", self.ns)[2]:
            self.ros.master.deleteParam("/tzc_test", self.ns)


class Switches(Configuration):
    def assert_plain(self, listener, talker, count=20):
        self.assert_got(listener, range(count), shared=False)
        self.assertEqual(talker.wait(60), 0, talker.tail())

    def test_a_publisher_that_is_off(self):
        self.in_both_ways("disable", "1",
                          lambda **how: self.assert_plain(self.listen(), self.start_talker(count=20, shared=0, **how)))

    def test_a_subscriber_that_is_off(self):
        self.in_both_ways("disable", "1",
                          lambda **how: self.assert_plain(self.listen(**how), self.start_talker(count=20, shared=0)))

    def test_a_parameter_wins_over_the_environment(self):
        listener = self.listen()
        self.talk(count=20, env={"TZC_DISABLE": "1"}, **{"tzc/disable": "0"})
        self.assert_got(listener, range(20), shared=True)

    def listen_to(self, *topics, env=None, **parameters):
        listener = self.node("listener", "listener", {"topics": " ".join(topics), **parameters}, env=env)
        for topic in topics:
            self.wait_for_subscribers(self.name(topic), 1)
        return Listener(listener)

    def assert_off(self, off, on, listener):
        for topic in off:
            self.assert_got(listener, range(20), shared=False, topic=topic)
        self.assert_got(listener, range(20), shared=True, topic=on)

    def test_topics_that_are_off(self):
        names = f"{self.name('left')}, {self.name('right')}"

        def check(listener=None, talker=None):
            heard = self.listen_to("left", "middle", "right", **(listener or {}))
            self.talk(count=20, topics="left middle right", settle=1, **(talker or {}))
            self.assert_off(("left", "right"), "middle", heard)
        self.in_both_ways("disable_topics", names, lambda **how: check(talker=how))
        self.in_both_ways("disable_topics", names, lambda **how: check(listener=how))

    def test_topics_as_a_list(self):
        names = [self.name("left"), self.name("right")]
        self.ros.master.setParam("/tzc_test", self.name("talker/tzc/disable_topics"), names)
        listener = self.listen_to("left", "middle", "right")
        self.talk(count=20, topics="left middle right", settle=1)
        self.assert_off(("left", "right"), "middle", listener)


class Memory(Configuration):
    def assert_warned(self, talker, *words, never=()):
        """Once, not for each message."""
        warnings = self.warnings(talker)
        self.assertEqual(len(warnings), 1, talker.log())
        for word in (self.name("image"), "no shared memory for a message of 100", *words):
            self.assertIn(word, warnings[0])
        for word in never:
            self.assertNotIn(word, warnings[0])

    def test_a_memory_size_wins_over_the_code(self):
        """Too small for a single message: they travel whole."""
        def check(**how):
            listener = self.listen()
            talker = self.start_talker(count=20, memory=4000000, bytes=100000, **how)
            self.assertEqual(talker.wait(60), 0, talker.tail())
            self.assertGreaterEqual(self.counters(talker)["exhausted"], 20)
            self.assert_got(listener, range(20), shared=False)
            self.assert_warned(talker, "larger than the whole memory, which has room for 53248 bytes", "sent serialized",
                               "Set ~tzc/memory_size to", "(now 50000)", never=("older messages", "in use", "subscriber"))
        self.in_both_ways("memory_size", "50000", check)

    def test_a_ceiling_for_the_process(self):
        """Too low for a single message, whatever the memory size: they travel whole, and the warning names it."""
        def check(**how):
            listener = self.listen()
            talker = self.start_talker(count=20, memory=4000000, bytes=1000000, **how)
            self.assertEqual(talker.wait(60), 0, talker.tail())
            self.assertGreaterEqual(self.counters(talker)["exhausted"], 20)
            self.assert_got(listener, range(20), shared=False)
            self.assert_warned(talker, "may have 500000 in all", "~tzc/memory_ceiling", "sent serialized",
                               never=("memory_size", "older messages", "by 0 blocks"))
        self.in_both_ways("memory_ceiling", "500000", check)

    def test_a_ceiling_that_leaves_no_room_for_a_connection(self):
        listener = self.listen()
        talker = self.start_talker(count=20, shared=0, settle=2, **{"tzc/memory_ceiling": "1000"})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=False)
        warnings = self.warnings(talker)
        self.assertEqual(len(warnings), 1, talker.log())
        for word in (self.name("image"), "stay on TCPROS for now", "may have 1000 in all", "~tzc/memory_ceiling"):
            self.assertIn(word, warnings[0])

    def talk_to_one_that_stands_still(self, **how):
        """It keeps two messages, as one in a callback and one that waits for it; the queue fills. The talker's counters and
        warnings."""
        listener = self.listen("keep", queue=2)
        talker = self.start_talker(count=102, pause=2, bytes=1048600, queue=30, **how)
        self.wait_for(listener, 2)
        listener.process.popen.send_signal(signal.SIGSTOP)
        talker.popen.send_signal(signal.SIGUSR2)
        self.last_published(talker)
        listener.process.popen.send_signal(signal.SIGCONT)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        counters, warnings = self.counters(talker), self.warnings(talker)
        self.forget()
        return counters, warnings

    def test_the_size_that_a_warning_advises_is_enough(self):
        _, warnings = self.talk_to_one_that_stands_still(memory=4000000)
        self.assertEqual(len(warnings), 1, warnings)
        advised = re.search(r"Set ~tzc/memory_size to (\w+) or more", warnings[0]).group(1)
        counters, warnings = self.talk_to_one_that_stands_still(**{"tzc/memory_size": advised})
        self.assertEqual((counters["exhausted"], warnings), (0, []), advised)

    def test_topics_without_memory_are_each_warned_about(self):
        """Though one place in the code warns of all of them, and at most once a minute."""
        listener = self.listen(topic="left", topics="left right")
        self.wait_for_subscribers(self.name("right"), 1)
        talker = self.start_talker(count=20, topics="left right", shared=0, **{"tzc/memory_size": str(1 << 50)})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        for topic in ("left", "right"):
            self.assert_got(listener, range(20), shared=False, topic=topic)
            warnings = [line for line in self.warnings(talker) if f"{self.name(topic)} stays on TCPROS" in line]
            self.assertEqual(len(warnings), 1, talker.log())

    def test_more_memory_than_an_integer_parameter_can_say(self):
        for size in ("4294967296", "4294967296.0"):
            with self.subTest(size):
                self.forget()
                listener = self.listen()
                talker = self.start_talker(count=20, memory=1000, bytes=100000, **{"tzc/memory_size": size})
                self.assertEqual(talker.wait(60), 0, talker.tail())
                self.assertNotIn("must be a whole number", talker.log())
                self.assert_got(listener, range(20), shared=True)

    def test_without_memory_messages_are_dropped(self):
        def check(**how):
            listener = self.listen()
            talker = self.start_talker(count=20, memory=50000, bytes=100000, **how)
            self.assertEqual(talker.wait(60), 0, talker.tail())
            self.assertEqual(self.counters(talker)["dropped"], 20)
            self.assert_got(listener, [])
            self.assert_warned(talker, "dropped", "~tzc/on_exhausted", "~tzc/memory_size")
        self.in_both_ways("on_exhausted", "drop", check)

    def stops(self, kept, **arguments):
        """Does memory for a third of the messages end with that third, when a subscriber keeps the first ones? (It must not,
        or hardly, on a machine where the other subscriber stands still for a moment.)"""
        keeper = self.node("keeper", "keeper", {"keep": kept, "outlive": os.getpid()})
        self.wait_for_subscribers(self.name("image"), 1)
        listener = self.listen(queue=1000)
        counters = self.talk(count=300, rate=200, subscribers=2, bytes=20000, memory=2000000, **arguments)
        self.assertTrue(keeper.alive(), keeper.tail())
        keeper.kill()  # it does not end when it is asked to
        self.assert_got(listener, range(300))
        self.assertTrue(counters["exhausted"] < 100 or counters["exhausted"] > 180, counters)
        return counters["exhausted"] > 180

    def test_policies(self):
        """worst_effort stops at the message that is kept, the others pass it over."""
        self.in_both_ways("policy", "worst_effort", lambda **how: self.assertTrue(self.stops(1, **how)))
        for policy in ("medium_effort", "best_effort"):
            self.in_both_ways("policy", policy, lambda **how: self.assertFalse(self.stops(1, **how)))

    def test_a_policy_of_the_code_and_a_parameter_that_wins_over_it(self):
        self.assertTrue(self.stops(1, policy="worst_effort"))
        self.forget()
        self.assertFalse(self.stops(1, policy="worst_effort", **{"tzc/policy": "medium_effort"}))

    def test_attempts(self):
        """Kept messages cost no other message its memory, however few of them one allocate looks at."""
        for attempts in ("1", "50"):
            self.in_both_ways("policy_attempts", attempts, lambda **how: self.assertFalse(self.stops(3, **how)))

    def resident(self, **arguments):
        """Bytes of its shared memory that a talker of small messages has touched."""
        talker = self.start_talker(count=0, bytes=5000, memory=32000000, **arguments)
        listener = self.listen()
        self.ros.wait_until(lambda: any(m["shared"] for m in listener.messages()), 20, "a shared message")
        with open(f"/proc/{talker.pid}/smaps") as smaps:
            mappings = [text.splitlines() for text in smaps.read().replace("\nVmFlags", "\0").split("\0")]
        sizes = {key: sum(int(line.split()[1]) for lines in mappings for line in lines if line.startswith(key)
                          and any("/memfd:" in other for other in lines)) for key in ("Size:", "Rss:")}
        self.assertGreater(1024 * sizes["Size:"], 32000000)
        return 1024 * sizes["Rss:"]

    def test_prefault(self):
        self.in_both_ways("prefault", "all", lambda **how: self.assertGreater(self.resident(**how), 32000000))
        for value in ("none", "on_first_use"):
            self.in_both_ways("prefault", value, lambda **how: self.assertLess(self.resident(**how), 8000000))


class Mistakes(Configuration):
    def test_what_cannot_be_understood_is_said_once(self):
        """And the node goes on without it."""
        listener = self.listen()
        talker = self.start_talker(count=20, **{"tzc/memorysize": 1000, "tzc/policy": "besteffort", "tzc/tries": 5})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=True)
        warnings = [line for line in talker.log().splitlines() if "WARN" in line and "TZC" in line]
        self.assertEqual(len(warnings), 3, talker.log())
        for words in (("~tzc/memorysize", "not a parameter", "did you mean ~tzc/memory_size?"),
                      ("~tzc/policy cannot be 'besteffort'", "best_effort, medium_effort or worst_effort"),
                      ("~tzc/tries is now called ~tzc/upgrade_attempts",)):
            self.assertTrue(any(all(word in line for word in words) for line in warnings), words)

    def test_sizes_and_places_that_cannot_be_meant_are_said(self):
        self.ros.master.setParam("/tzc_test", self.name("talker/tzc"), "64M")
        listener = self.listen()
        talker = self.start_talker(count=20, memory=-1, env={"TZC_STATISTICS": "/nowhere/at_all", "TZC_MEMROY_SIZE": "64M"})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=True)
        warnings = self.warnings(talker)
        self.assertEqual(len(warnings), 4, talker.log())
        for words in (("~tzc is '64M'", "~tzc/memory_size"), ("TZC_MEMROY_SIZE", "did you mean TZC_MEMORY_SIZE?"),
                      (self.name("image"), "18446744073709551615 bytes cannot be meant"),
                      ("TZC_STATISTICS=/nowhere/at_all", "No such file or directory")):
            self.assertTrue(any(all(word in line for word in words) for line in warnings), (words, warnings))

    def test_a_size_with_a_suffix(self):
        listener = self.listen()
        counters = self.talk(count=20, bytes=100000, memory=50000, **{"tzc/memory_size": "4M"})
        self.assertEqual(counters["exhausted"], 0)
        self.assert_got(listener, range(20), shared=True)


class Others(Configuration):
    def test_tries(self):
        def check(env=None, **parameters):
            with MasterProxy(self.ros.uri) as proxy:
                proxy.first("lookupNode", 100, MasterProxy.unknown)
                self.listen()
                talker = self.start_talker(count=0, env={"ROS_MASTER_URI": proxy.uri, **(env or {})}, **parameters)
                self.ros.wait_until(lambda: "stays on TCPROS after 2 tries" in talker.log(), 20, "the warning")
                self.ros.wait_until(lambda: proxy.calls("lookupNode") > 2, 20, "the next try")
                talker.stop()
        self.in_both_ways("upgrade_attempts", "2", check)

    def test_statistics(self):
        path = os.path.join(self.scratch, "statistics")
        for life in range(2):
            listener = self.listen(topic="left", topics="left right")
            self.wait_for_subscribers(self.name("right"), 1)
            self.talk(topics="left right", count=20, env={"TZC_STATISTICS": path})
            listener.process.stop()
            with open(path) as lines:
                counters = [json.loads(line) for line in lines]
            self.assertEqual(sorted(line["topic"] for line in counters),
                             sorted([self.name("left"), self.name("right")] * (life + 1)))
            for line in counters:
                self.assertEqual((line["messages"], line["shared"], line["copied_bytes"]), (20, 20, 0))

    def test_what_cannot_be_is_said_and_ignored(self):
        values = {"policy": "no_effort", "policy_attempts": "-1", "memory_size": "much", "prefault": "some", "on_exhausted": "1"}
        listener = self.listen()
        talker = self.start_talker(count=20, **{f"tzc/{name}": value for name, value in values.items()})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=True)
        for name, value in values.items():
            warnings = [line for line in talker.log().splitlines() if "WARN" in line and f"~tzc/{name} " in line]
            self.assertEqual(len(warnings), 1, name)
            self.assertIn(f"'{value}'", warnings[0])

    def test_a_line_for_each_upgrade_at_debug_level_and_silence_otherwise(self):
        loud = os.path.join(self.scratch, "rosconsole.config")
        with open(loud, "w") as config:
            config.write("log4j.logger.ros=INFO\nlog4j.logger.ros.tzc=DEBUG\n")
        env = {"ROSCONSOLE_CONFIG_FILE": loud}
        listener, quiet = self.listen(env=env), self.listen()
        talker = self.start_talker(count=20, subscribers=2, env=env)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(20), shared=True)
        arrivals = [line for line in listener.process.log().splitlines() if "comes through shared memory" in line]
        self.assertEqual(len(arrivals), 1, listener.process.tail())
        for word in ("DEBUG", self.name("image"), self.name("talker")):
            self.assertIn(word, arrivals[0])
        moves = [line for line in talker.log().splitlines() if "TZC" in line and "shared memory" in line]
        self.assertEqual(len(moves), 2, talker.tail())
        self.assertNotIn("TZC", quiet.process.log())


if __name__ == "__main__":
    main()
