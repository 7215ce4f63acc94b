# SPDX-License-Identifier: BSD-3-Clause
"""A small language for tests of one topic: talkers, listeners, and what the listeners must have seen.

    class Basic(TopicCase):
        def test_shared(self):
            listener = self.listen()
            self.talk(count=50)
            self.assert_got(listener, range(50), shared=True)
"""
import json
import os
import shutil
import signal
import sys
import tempfile
import time
import unittest
import xmlrpc.client

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from leftovers import left_behind  # noqa: E402
from ros_session import RosSession  # noqa: E402

NODES = os.environ.get("TZC_TEST_NODES", ".")
TZC_RUN = [os.environ.get("TZC_RUN", "tzc-run")]


class Listener:
    def __init__(self, process):
        self.process = process

    def lines(self):
        return [json.loads(line) for line in self.process.log().splitlines()
                if line.startswith("{") and line.endswith("}")]

    def messages(self, topic=None, callback=None):
        """All, or those that came on a topic (its name as it was subscribed) or to one of several callbacks."""
        return [line for line in self.lines() if "number" in line and topic in (None, line.get("topic"))
                and callback in (None, line.get("callback"))]

    def numbers(self, topic=None, callback=None):
        return [message["number"] for message in self.messages(topic, callback)]


class TopicCase(unittest.TestCase):
    """One roscore for each class; each test has a namespace of its own, `self.ns`, with its topic `image` in it."""
    maxDiff = 2000
    tests_so_far = 0
    session_env = {}

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.mkdtemp(prefix="tzc_test_")
        cls.ros = RosSession(cls.scratch, cls.session_env)
        cls.addClassCleanup(shutil.rmtree, cls.scratch, ignore_errors=True)
        cls.addClassCleanup(cls.ros.__exit__)
        cls.ros.__enter__()

    def setUp(self):
        TopicCase.tests_so_far += 1
        self.ns = f"/t{TopicCase.tests_so_far}"
        self.left_before = left_behind()
        self.before = self.ros.mark()

    def tearDown(self):
        self.ros.stop_since(self.before)
        try:  # tests that run beside this one have such files for a moment
            self.ros.wait_until(lambda: left_behind() <= self.left_before, 5, "nothing to be left behind")
        except RuntimeError:
            self.fail(f"left behind: {left_behind() - self.left_before}")

    @staticmethod
    def slowness():
        """How much longer things may take than on an idle machine."""
        return max(1.0, os.getloadavg()[0] / os.cpu_count())

    def name(self, relative):
        """A name in this test's namespace."""
        return f"{self.ns}/{relative}"

    def node(self, program, name, parameters, remaps=(), env=None, runner=()):
        command = list(runner) + [os.path.join(NODES, program)]
        command += [f"__name:={name}"] if name else []
        command += [f"_{key}:={value}" for key, value in parameters.items()] + [f"__ns:={self.ns}", *remaps]
        return self.ros.start(command, name=name or program, env=env)

    def listen(self, mode="pointer", name=None, remaps=(), env=None, runner=(), topic="image", **parameters):
        """A listener that the master knows. `topic`: relative name of what it listens to in the end."""
        before = len(self.ros.subscribers(self.name(topic)))
        process = self.node("listener", name, dict(parameters, mode=mode), remaps, env, runner)
        self.ros.wait_until(lambda: len(self.ros.subscribers(self.name(topic))) > before, 20, "the listener")
        return Listener(process)

    def wait_for_subscribers(self, topic, count):
        self.ros.wait_until(lambda: len(self.ros.subscribers(topic)) >= count, 20, f"{count} subscribers of {topic}")

    def start_talker(self, mode="twin", name="talker", remaps=(), env=None, runner=(), **parameters):
        """A talker that begins when its subscribers are there, and so many on shared memory (`shared`) as there are
        subscribers, unless it is told otherwise; tests of the move itself set settle to 0 instead."""
        if "settle" not in parameters:
            is_plain = mode in ("plain", "attached_wrong")
            parameters.setdefault("shared", 0 if is_plain else parameters.get("subscribers", 1))
        if not parameters.get("shared", 0):
            parameters.setdefault("settle", 0.5)  # time for a move that must not happen
        # The queue is for a machine that is busy with others.
        return self.node("talker", name, dict({"queue": 200}, mode=mode, **parameters), remaps, env, runner)

    def talk(self, mode="twin", timeout=60, **parameters):
        """Runs a talker to its end; its counters."""
        talker = self.start_talker(mode, **parameters)
        self.assertEqual(talker.wait(timeout), 0, talker.tail())
        return self.counters(talker)

    def finish(self, talker, timeout=30):
        """Tells a talker without an end that it is enough; its counters, with the last number."""
        talker.popen.send_signal(signal.SIGUSR1)
        self.assertEqual(talker.wait(timeout), 0, talker.tail())
        return self.counters(talker)

    def last_published(self, talker):
        """The number of the last message of a talker that stays for a while."""
        self.ros.wait_until(lambda: "all published" in talker.log(), 60, "all messages to be published")
        return self.counters(talker)["last"]

    @staticmethod
    def counters(talker):
        """What a talker that came to its end has counted."""
        return json.loads([line for line in talker.log().splitlines() if line.startswith("{")][-1])

    def wait_for(self, listener, count, timeout=20, topic=None, callback=None):
        self.ros.wait_until(lambda: len(listener.numbers(topic, callback)) >= count, timeout, f"{count} messages")

    def wait_for_shared(self, listener, count):
        """A listener that connected while its talker published has moved, and got so many messages since."""
        self.ros.wait_until(lambda: sum(m["shared"] for m in listener.messages()) >= count, 60, "its move")

    def wait_for_number(self, listener, number):
        self.ros.wait_until(lambda: number in listener.numbers(), 20, f"message {number}")

    def assert_got(self, listener, numbers, shared=None, timeout=10, topic=None, callback=None):
        """Exactly these messages, in order, with the right bytes; shared: where they must have lain."""
        expected = list(numbers)
        try:
            self.wait_for(listener, len(expected), timeout, topic, callback)
        except RuntimeError:
            pass  # the comparison says more
        time.sleep(0.1)  # time for a message too many
        messages = listener.messages(topic, callback)
        self.assertEqual([message["number"] for message in messages], expected)
        self.assertTrue(all(message["right"] for message in messages), "some bytes are wrong")
        if shared is not None:
            wrong = [message["number"] for message in messages if message["shared"] != shared]
            self.assertEqual(wrong, [], f"messages that were {'not ' if shared else ''}in shared memory")

    def connections(self, node):
        """(transport, topic) of each connection of a node, by its own word (getBusInfo)."""
        code, _, uri = self.ros.master.lookupNode("/tzc_test", node)
        if code != 1:
            return []
        try:
            with xmlrpc.client.ServerProxy(uri) as proxy:
                _, _, connections = proxy.getBusInfo("/tzc_test")
        except OSError:
            return []  # it has ended
        return [(transport, topic) for _, _, _, transport, topic, *_ in connections]

    def shared_transports(self, node):
        """Topics that a node sends through shared memory."""
        return [topic for transport, topic in self.connections(node) if transport == "TZC"]

    def transports(self, node, topic="image"):
        """The transports of a node's connections of one topic."""
        return {transport for transport, name in self.connections(node) if name == self.name(topic)}

    @staticmethod
    def warnings(process):
        """TZC's, of a node's log."""
        return [line for line in process.log().splitlines() if "WARN" in line and "TZC" in line]

    def assert_moved(self, listener):
        """Its messages came over TCPROS up to one of them, and through shared memory from there on."""
        shared = [message["shared"] for message in listener.messages()]
        self.assertIn(True, shared)
        self.assertEqual(shared, sorted(shared))

    def assert_seq_as_tcpros(self, listener, first=0):
        seqs = [message["seq"] for message in listener.messages()]
        self.assertEqual(seqs, list(range(first, first + len(seqs))))


def main():
    unittest.main(verbosity=2)
