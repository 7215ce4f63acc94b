# SPDX-License-Identifier: BSD-3-Clause
"""Traces of nodes: shared, on TCPROS, by tzc-run, and joined by tzc-monitor."""
import json
import os
import signal
import subprocess
import unittest

from topic_case import TZC_RUN, TopicCase, main
from trace_file import Trace, events_of, is_strict_json, load

MONITOR = os.environ.get("TZC_MONITOR", "tzc-monitor")
SHARED = ("publish", "wake", "take", "callback")
TCPROS = ("publish by roscpp", "callback")


class Traces(TopicCase):
    def setUp(self):
        super().setUp()
        self.file = os.path.join(self.scratch, f"trace{self.ns.replace('/', '_')}")
        self.env = {"TZC_TRACE": self.file}

    def trace(self):
        return Trace(load(self.file + ".*"))

    def end(self, listener):
        """Ctrl-C; its trace is whole then."""
        listener.process.popen.send_signal(signal.SIGINT)
        listener.process.wait(20)
        self.assertTrue(is_strict_json(f"{self.file}.{listener.process.pid}"))

    def check(self, categories, count, trace=None):
        """So many messages have these steps, in order."""
        trace = trace or self.trace()
        messages = trace.complete(*categories)
        self.assertGreaterEqual(len(messages), count, trace.events[:20])
        for message in messages:
            trace.check_order(self, message)
        for category in categories:
            self.assertEqual({one["name"] for one in trace.slices(category)}, {f"{category} {self.name('image')}"})
        self.assertEqual(trace.left_out(), 0)
        return trace

    def test_from_publish_to_callback_across_processes(self):
        listener = self.listen(env=self.env, name="viewer")
        self.talk(count=20, rate=100, env=self.env)
        self.assert_got(listener, range(20), shared=True)
        self.end(listener)
        trace = self.check(SHARED, 20)
        self.assertEqual(trace.names("process_name") & {self.name("talker"), self.name("viewer")},
                         {self.name("talker"), self.name("viewer")})
        self.assertIn("tzc-reader", trace.names("thread_name"))
        names = [(event["pid"], event["args"]["name"]) for event in trace.events if event["name"] == "process_name"]
        self.assertEqual(len(names), len(set(names)), "each name is written once")

    def test_each_subscriber_has_a_flow_of_its_own(self):
        listeners = [self.listen(mode, env=self.env, name=f"viewer_{mode}") for mode in ("pointer", "direct", "value")]
        self.talk(count=10, rate=50, subscribers=3, env=self.env)
        for listener in listeners:
            self.assert_got(listener, range(10))
            self.end(listener)
        trace = self.check(SHARED, 30)
        for listener in listeners:
            of_it = [one for one in trace.slices("callback") if one["pid"] == listener.process.pid]
            self.assertEqual(len(of_it), 10)

    def test_a_subscriber_that_stays_on_tcpros(self):
        """What is shared beside it keeps its own flow."""
        plain = self.listen(env=dict(self.env, TZC_DISABLE="1"), name="plain")
        shared = self.listen(env=self.env, name="shared")
        self.talk(count=20, rate=100, subscribers=2, shared=1, env=self.env)
        self.assert_got(plain, range(20), shared=False)
        self.assert_got(shared, range(20), shared=True)
        self.end(plain)
        self.end(shared)
        self.check(SHARED, 20)
        self.check(TCPROS, 20)

    def test_a_publisher_that_is_not_ported_and_subscribers_by_tzc_run(self):
        listener = self.listen("plain", env=self.env, name="viewer", runner=TZC_RUN)
        talker = self.start_talker("plain", count=0, rate=100, env=self.env, runner=TZC_RUN)
        self.ros.wait_until(lambda: len(self.trace().complete(*SHARED)) >= 10, 20, "ten messages")
        self.finish(talker)
        self.end(listener)
        trace = self.trace()
        for message in trace.complete(*SHARED):
            trace.check_order(self, message)

    def test_serialized_messages_keep_their_flow(self):
        """No memory: they go whole, through the same channel."""
        listener = self.listen(env=self.env)
        self.talk("stock", count=10, rate=50, memory=4096, env=self.env)
        self.assert_got(listener, range(10), shared=False)
        self.end(listener)
        self.check(SHARED, 10)

    def test_a_killed_node_leaves_a_readable_file(self):
        listener = self.listen(env=self.env)
        talker = self.start_talker(count=0, rate=100, env=self.env)
        self.ros.wait_until(lambda: len(self.trace().complete(*SHARED)) >= 5, 20, "five messages")
        talker.popen.send_signal(signal.SIGKILL)
        listener.process.popen.send_signal(signal.SIGKILL)
        for process in (talker, listener.process):
            process.popen.wait(20)
            self.assertGreater(len(events_of(f"{self.file}.{process.pid}")), 5)
            self.assertFalse(is_strict_json(f"{self.file}.{process.pid}"))
        self.check(SHARED, 5)

    @unittest.skipUnless(os.path.exists(MONITOR), "tzc-monitor was not built, as CMake has said")
    def test_traces_are_joined(self):
        listener = self.listen(env=self.env)
        talker = self.start_talker(count=0, rate=100, env=self.env)
        self.ros.wait_until(lambda: len(self.trace().complete(*SHARED)) >= 5, 20, "five messages")
        self.finish(talker)
        self.end(listener)
        files = [f"{self.file}.{process.pid}" for process in (talker, listener.process)]
        with open(files[0], "a", encoding="ascii") as cut:
            cut.write('{"ph":"X","na')
        joined = subprocess.run([MONITOR, "--join-trace", *files], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                timeout=20, check=False)
        self.assertEqual(joined.returncode, 0, joined.stderr)
        self.assertIn(f"{files[0]}: 1 lines are no events", joined.stderr.decode())
        self.check(SHARED, 5, Trace(json.loads(joined.stdout)))
        nothing = subprocess.run([MONITOR, "--join-trace", "/no/such/file"], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, timeout=20, check=False)
        self.assertEqual((nothing.returncode, nothing.stdout), (2, b""))
        self.assertIn("cannot read /no/such/file: No such file or directory", nothing.stderr.decode())


if __name__ == "__main__":
    main()
