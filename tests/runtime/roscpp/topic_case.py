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
import sys
import tempfile
import time
import unittest
import xmlrpc.client

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from ros_session import RosSession  # noqa: E402

NODES = os.environ.get("TZC_TEST_NODES", ".")
TZC_RUN = [os.environ.get("TZC_RUN", "tzc-run")]


def shared_memory_files():
    """What a runtime could have left behind for others to trip over."""
    return sorted(f"{folder}/{name}" for folder in ("/dev/shm", tempfile.gettempdir())
                  for name in os.listdir(folder) if "tzc" in name and "tzc_test" not in name)


class Listener:
    def __init__(self, process):
        self.process = process

    def messages(self):
        return [json.loads(line) for line in self.process.log().splitlines()
                if line.startswith("{") and line.endswith("}")]

    def numbers(self):
        return [message["number"] for message in self.messages()]


class TopicCase(unittest.TestCase):
    maxDiff = 2000

    def setUp(self):
        self.scratch = tempfile.mkdtemp(prefix="tzc_test_")
        self.left_before = shared_memory_files()
        self.ros = RosSession(self.scratch)
        self.ros.__enter__()

    def tearDown(self):
        self.ros.__exit__()
        self.assertEqual(shared_memory_files(), self.left_before, "something was left behind")
        shutil.rmtree(self.scratch, ignore_errors=True)

    def node(self, program, name, parameters, remaps=(), env=None, runner=()):
        command = list(runner) + [os.path.join(NODES, program)]
        command += [f"__name:={name}"] if name else []
        command += [f"_{key}:={value}" for key, value in parameters.items()] + list(remaps)
        return self.ros.start(command, name=name or program, env=env)

    def listen(self, mode="pointer", name=None, remaps=(), env=None, runner=(), **parameters):
        before = len(self.ros.subscribers("/image"))
        process = self.node("listener", name, dict(parameters, mode=mode), remaps, env, runner)
        if not remaps:
            self.ros.wait_until(lambda: len(self.ros.subscribers("/image")) > before, 20, "the listener")
        return Listener(process)

    def start_talker(self, mode="twin", name="talker", remaps=(), env=None, runner=(), **parameters):
        # The upgrade takes a few ms; tests of it set settle to 0.
        return self.node("talker", name, dict({"settle": 0.5}, mode=mode, **parameters), remaps, env, runner)

    def talk(self, mode="twin", timeout=60, **parameters):
        """Runs a talker to its end; its counters."""
        talker = self.start_talker(mode, **parameters)
        self.assertEqual(talker.wait(timeout), 0, talker.tail())
        return json.loads([line for line in talker.log().splitlines() if line.startswith("{")][-1])

    def wait_for(self, listener, count, timeout=20):
        self.ros.wait_until(lambda: len(listener.numbers()) >= count, timeout,
                            f"{count} messages (there are {len(listener.numbers())})")

    def assert_got(self, listener, numbers, shared=None, timeout=10):
        """Exactly these messages, in order, with the right bytes; shared: where they must have lain."""
        expected = list(numbers)
        try:
            self.wait_for(listener, len(expected), timeout)
        except RuntimeError:
            pass  # the comparison says more
        time.sleep(0.1)  # room for a message too many
        messages = listener.messages()
        self.assertEqual([message["number"] for message in messages], expected)
        self.assertTrue(all(message["right"] for message in messages), "some bytes are wrong")
        if shared is not None:
            wrong = [message["number"] for message in messages if message["shared"] != shared]
            self.assertEqual(wrong, [], f"messages that were {'not ' if shared else ''}in shared memory")

    def shared_transports(self, node):
        """Topics that a node sends through shared memory, by its own word (getBusInfo)."""
        code, _, uri = self.ros.master.lookupNode("/tzc_test", node)
        if code != 1:
            return []
        try:
            with xmlrpc.client.ServerProxy(uri) as proxy:
                _, _, connections = proxy.getBusInfo("/tzc_test")
        except OSError:
            return []  # it has ended
        return [topic for _, _, _, transport, topic, *_ in connections if transport == "TZC"]

    def assert_seq_as_tcpros(self, listener, first=0):
        seqs = [message["seq"] for message in listener.messages()]
        self.assertEqual(seqs, list(range(first, first + len(seqs))))


def main():
    unittest.main(verbosity=2)
