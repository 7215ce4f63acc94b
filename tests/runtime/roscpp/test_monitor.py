# SPDX-License-Identifier: BSD-3-Clause
"""What tzc-monitor shows of real nodes, and that they do not notice it."""
import json
import os
import re
import signal
import struct
import subprocess
import sys
import unittest

from terminal import Terminal
from topic_case import TopicCase, main

MONITOR = os.environ.get("TZC_MONITOR", "tzc-monitor")
DIAGNOSTICS = os.environ.get("TZC_DIAGNOSTICS", "tzc-diagnostics")
ROSPY = [sys.executable, os.path.join(os.path.dirname(os.path.abspath(__file__)), "nodes", "rospy_node.py")]


# What is published, as hexadecimal digits: Python may have no diagnostic_msgs.
RAW_ECHO = """
import rospy
rospy.init_node("echo", anonymous=True)
rospy.Subscriber("/diagnostics", rospy.AnyMsg, lambda message: print(message._buff.hex(), flush=True))
rospy.spin()
"""


class MonitorCase(TopicCase):
    def setUp(self):
        super().setUp()
        self.ns = f"/monitored_{os.getpid()}{self.ns}"  # the monitor sees the nodes of other test runs, too

    def monitor(self, *arguments):
        """Runs it to its end; (status, standard output, standard error)."""
        done = subprocess.run([MONITOR, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120,
                              stdin=subprocess.DEVNULL, check=False)
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def seen(self):
        """This test's topic as its publisher's node shows it, with that node; None when it shows none."""
        status, output, _ = self.monitor("--json", "--interval", "0", "--topic", self.name("image"))
        nodes = json.loads(output)["nodes"]
        self.assertEqual(status, 0 if nodes else 1)
        return next((dict(node["topics"][0], node=node) for node in nodes if node["topics"]), None)

    def subscription(self, node):
        """This test's topic as a subscriber of it shows it; None when it shows none."""
        nodes = json.loads(self.monitor("--json", "--interval", "0", "--topic", self.name("image"))[1])["nodes"]
        return next((one["subscriptions"][0] for one in nodes
                     if one["node"] == self.name(node) and one["subscriptions"]), None)

    def wait_until_received(self, node, condition, what):
        looks = []

        def holds():
            looks.append(self.subscription(node))
            return looks[-1] is not None and condition(looks[-1])
        self.ros.wait_until(holds, 20, what)
        return looks[-1]

    def wait_until_seen(self, condition, what):
        """The first look that meets the condition."""
        looks = []

        def holds():
            looks.append(self.seen())
            return looks[-1] is not None and condition(looks[-1])
        self.ros.wait_until(holds, 20, what)
        return looks[-1]

    def connection(self, look, node):
        return next((one for one in look["connections"] if one["subscriber"] == self.name(node)), None)

    def rate_in(self, table):
        """The topic's MSG/S; "-" when its node was too slow to update its page between two looks."""
        return re.search(rf"^  {self.name('image')} +(\S+)", table, re.M).group(1)

    def table_with_rate(self):
        tables = []

        def has_rate():
            status, table, _ = self.monitor("--once", "--topic", self.name("image"))
            self.assertEqual(status, 0)
            tables.append(table)
            return self.rate_in(table) != "-"
        self.ros.wait_until(has_rate, 20, "a rate")
        return tables[-1]

    def wait_until_shared(self, node):
        def is_shared(look):
            connection = self.connection(look, node)
            return connection is not None and connection["transport"] == "shared"
        return self.wait_until_seen(is_shared, f"{node} to be shown as shared")


class Monitor(MonitorCase):
    def test_shared_and_plain_connections_with_their_reasons(self):
        self.listen(name="viewer")
        self.listen("plain", name="plain")
        self.ros.start(ROSPY + [f"__ns:={self.ns}", "__name:=python"], name="python")
        self.wait_for_subscribers(self.name("image"), 3)
        talker = self.start_talker(count=0, rate=50, subscribers=3, shared=1)
        self.wait_until_shared("viewer")
        look = self.wait_until_seen(
            lambda look: "tzcOffer" in (self.connection(look, "python") or {}).get("reason", "") and
            "has not attached" in (self.connection(look, "plain") or {}).get("reason", "") and look["messages"] > 0,
            "both reasons")
        self.assertEqual((look["node"]["node"], look["node"]["pid"], look["node"]["state"]),
                         (self.name("talker"), talker.pid, "running"))
        self.assertEqual((look["type"], look["copied_bytes"]), ("sensor_msgs/Image", 0))
        self.assertGreaterEqual(look["memory"]["size"], 100000)
        self.assertLessEqual(look["memory"]["used"], look["memory"]["committed"])
        self.assertEqual(self.connection(look, "viewer")["reason"], "")
        for plain in ("plain", "python"):
            self.assertEqual(self.connection(look, plain)["transport"], "TCPROS")
            self.assertGreater(self.connection(look, plain)["messages"], 0)

        table = self.table_with_rate()
        self.assertRegex(table, rf"-> {self.name('viewer')} +shared ")
        self.assertRegex(table, rf"-> {self.name('plain')} +TCPROS .*has not attached {self.name('image')}")
        self.assertTrue(0 < float(self.rate_in(table)) < 75, table)
        self.assertNotIn("\x1b", table)

        status, why, _ = self.monitor("--why", self.name("viewer"), self.name("image"))
        self.assertEqual((status, why), (0, f"{self.name('talker')} sends {self.name('image')} to "
                                            f"{self.name('viewer')} through shared memory.\n"))
        _, why, _ = self.monitor("--why", self.name("python"), self.name("image"))
        self.assertIn("over TCPROS: the node at http", why)
        self.assertIn("tzc-run", why)
        _, why, _ = self.monitor("--why", self.name("talker"), self.name("image"))
        self.assertEqual(len(why.splitlines()), 3, why)
        status, why, trouble = self.monitor("--why", self.name("nobody"), self.name("image"))
        self.assertEqual((status, why), (1, ""))
        self.assertIn(f"is published by {self.name('talker')}, which has no connection to", trouble)
        self.finish(talker)

    def test_a_stopped_node_is_shown_as_stopped(self):
        viewer = self.listen(name="viewer")
        talker = self.start_talker(count=0, rate=50)
        self.wait_until_shared("viewer")
        viewer.process.popen.send_signal(signal.SIGSTOP)
        self.wait_until_seen(lambda look: self.connection(look, "viewer")["stopped"], "the viewer to be shown as stopped")
        talker.popen.send_signal(signal.SIGSTOP)
        look = self.wait_until_seen(lambda look: look["node"]["state"] == "stopped", "the talker to be shown as stopped")
        self.assertEqual(self.connection(look, "viewer")["transport"], "shared")
        _, table, _ = self.monitor("--once", "--interval", "0", "--topic", self.name("image"))
        self.assertRegex(table, rf"{self.name('talker')}  process {talker.pid}  stopped, as of \d+ s ago")
        talker.popen.send_signal(signal.SIGCONT)
        viewer.process.popen.send_signal(signal.SIGCONT)
        self.wait_until_seen(lambda look: look["node"]["state"] == "running" and
                             not self.connection(look, "viewer")["stopped"], "both to run")
        self.finish(talker)

    def test_memory_of_the_node_has_a_row(self):
        self.listen(name="viewer")
        self.start_talker("of_node", count=0, rate=50, subscribers=1, shared=1)
        look = self.wait_until_seen(lambda look: look["shared"] > 0, "messages")
        rows = []

        def has_row():
            nodes = json.loads(self.monitor("--json", "--interval", "0")[1])["nodes"]
            rows.extend(row for node in nodes if node["pid"] == look["node"]["pid"] for row in node["topics"]
                        if row["topic"] == "(no topic)")
            return rows
        self.ros.wait_until(has_row, 20, "the row")
        self.assertEqual((look["copied_bytes"], look["memory"]["size"], rows[-1]["messages"]), (0, 0, 0))
        self.assertGreater(rows[-1]["memory"]["size"], 100000)

    def test_memory_that_runs_out_is_counted(self):
        """A stopped subscriber takes nothing: its queue keeps every block that the memory has."""
        viewer = self.listen(name="viewer")
        talker = self.start_talker(count=0, rate=50, memory=4 * 105000)
        self.wait_until_shared("viewer")
        viewer.process.popen.send_signal(signal.SIGSTOP)
        look = self.wait_until_seen(lambda look: look["exhausted"] > 0, "the memory to run out")
        self.assertGreater(self.connection(look, "viewer")["in_flight"], 0)
        self.assertGreater(look["memory"]["used"], 2 * 100000)
        viewer.process.popen.send_signal(signal.SIGCONT)
        self.finish(talker)

    def test_what_a_subscriber_keeps_is_shown_as_held(self):
        self.listen("keep", name="keeper")
        self.start_talker(count=5, rate=50, linger=300)
        look = self.wait_until_seen(lambda look: (self.connection(look, "keeper") or {}).get("held") == 5,
                                    "five blocks to be held")
        self.assertEqual(look["memory"]["blocks"], 5)
        look = self.wait_until_seen(lambda look: self.connection(look, "keeper")["oldest_held_s"] > 1,
                                    "blocks that are held for more than a second")
        self.assertGreaterEqual(self.connection(look, "keeper")["shared_bytes"], 5 * 100000)
        _, table, _ = self.monitor("--once", "--interval", "0", "--topic", self.name("image"))
        self.assertRegex(table, rf"-> {self.name('keeper')} .* holds 5 for up to \d+ s, lost 0")

    def test_a_subscriber_shows_what_it_got_and_how_long_that_took(self):
        self.listen("keep", name="keeper")
        talker = self.start_talker(count=7, rate=20, linger=300)
        look = self.wait_until_received("keeper", lambda look: look["messages"] == 7, "seven messages")
        self.assertEqual((look["publisher"], look["transport"], look["pid"], look["lost"], look["stopped"]),
                         (self.name("talker"), "shared", talker.pid, 0, False))
        self.assertEqual(look["held_messages"], 7)
        self.assertGreaterEqual(look["held_bytes"], 700000)
        self.assertGreaterEqual(look["shared_bytes"], 700000)
        self.assertLess(look["bytes"], 100000)
        # The record with which the connection begins was taken, too.
        self.assertIn(sum(bucket["messages"] for bucket in look["latency"]), (7, 8))
        self.assertTrue(all(bucket["below_us"] < 60e6 for bucket in look["latency"]), look["latency"])
        _, table, _ = self.monitor("--once", "--interval", "0", "--topic", self.name("image"))
        self.assertRegex(table, rf"<- {self.name('image')} from {self.name('talker')} +shared +- +latency < \S+ [um]?s "
                                r"\(99%: < \S+ [um]?s\), holds 7 \(\S+\), lost 0")

    def test_a_subscriber_on_tcpros_shows_that_too(self):
        self.listen(name="both", topics="image depth", topic="depth")
        talker = self.start_talker(count=0, rate=50, shared=0, settle=0.1, topics="image depth",
                                   **{"tzc/disable_topics": self.name("image")})
        look = self.wait_until_received("both", lambda look: look["messages"] > 0, "messages over TCPROS")
        self.assertEqual((look["transport"], look["publisher"], look["latency"]), ("TCPROS", self.name("talker"), []))
        self.finish(talker)

    def test_switched_off(self):
        """No page: nothing to see, and one descriptor less."""
        self.listen(name="viewer")
        talker = self.start_talker(count=0, rate=50, **{"tzc/statistics_page": 0})
        self.ros.wait_until(lambda: self.shared_transports(self.name("talker")), 20, "the upgrade")
        expected = f"{self.name('viewer')} gets {self.name('image')} from {self.name('talker')} through shared memory.\n"
        self.ros.wait_until(lambda: self.monitor("--why", self.name("viewer"), self.name("image"))[:2] == (0, expected), 20,
                            "the viewer's own page to show it")
        status, _, trouble = self.monitor("--why", self.name("talker"), self.name("image"))
        self.assertEqual(status, 1)
        self.assertIn("No process of this user publishes", trouble)
        self.assertEqual(pages_of(talker.pid), [])
        self.finish(talker)


    def test_a_topic_that_is_switched_off_says_so(self):
        self.listen(name="viewer")
        self.listen(name="plain", topics="depth", topic="depth")
        talker = self.start_talker(count=0, rate=50, settle=0.1, topics="image depth",
                                   **{"tzc/disable_topics": self.name("depth")})
        self.wait_until_shared("viewer")
        self.ros.wait_until(lambda: self.monitor("--why", self.name("plain"), self.name("depth"))[0] == 0, 20,
                            "the topic that is switched off")
        _, why, _ = self.monitor("--why", self.name("plain"), self.name("depth"))
        self.assertEqual(why, f"{self.name('talker')} sends {self.name('depth')} to {self.name('plain')} over TCPROS: "
                              "the publisher's ~tzc/disable_topics names this topic. "
                              "Take the topic from that parameter, or from TZC_DISABLE_TOPICS, to share it.\n")
        self.finish(talker)

    def test_a_topic_that_the_subscriber_switched_off_says_so(self):
        self.listen(name="viewer", **{"tzc/disable_topics": self.name("image")})
        talker = self.start_talker(count=0, rate=50, shared=0)
        self.ros.wait_until(
            lambda: "the subscriber's ~tzc/disable_topics names" in self.monitor("--why", self.name("viewer"), self.name("image"))[1],
            20, "the reason")
        self.finish(talker)


@unittest.skipUnless(os.path.exists(DIAGNOSTICS), "tzc-diagnostics was not built, as CMake has said")
class Diagnostics(MonitorCase):
    def test_problems_and_counts_are_on_the_topic(self):
        viewer = self.listen(name="viewer")
        talker = self.start_talker(count=0, rate=50)
        self.wait_until_shared("viewer")
        viewer.process.popen.send_signal(signal.SIGSTOP)
        self.ros.start([DIAGNOSTICS, f"__ns:={self.ns}", "__name:=watch", "_period:=0.5"], name="watch")
        echo = self.ros.start([sys.executable, "-c", RAW_ECHO], name="echo")
        # A status begins with its level and its name.
        ok, error = (bytes([level]) + struct.pack("<I", len(name)) + name.encode() for level, name in
                     ((0, f"tzc: {self.name('talker')}"), (2, f"tzc: {self.name('viewer')}")))

        def is_there():
            said = [bytes.fromhex(line) for line in echo.log().split("\n")[:-1] if set(line) <= set("0123456789abcdef")]
            return any(error in one and f"process {viewer.process.pid}".encode() in one for one in said) and \
                any(ok in one or b"\x01" + ok[1:] in one for one in said)
        self.ros.wait_until(is_there, 20, "the talker's status and the stopped viewer's")
        viewer.process.popen.send_signal(signal.SIGCONT)
        self.finish(talker)


    def test_a_period_that_is_none(self):
        for period in ("abc", "-1", "0", "1e10", "nan"):
            status, output = self.ros.run([DIAGNOSTICS, f"__ns:={self.ns}", f"_period:={period}"], timeout=20)
            self.assertEqual((status, "from 0.1 to 3600" in output), (2, True), output)


class Observed(MonitorCase):
    def test_monitors_that_are_killed_change_nothing(self):
        """Ten of them in terminals, killed without a warning: the node keeps its threads, descriptors and messages."""
        listener = self.listen(name="viewer", queue=1000)
        talker = self.start_talker(count=0, rate=50)
        self.wait_until_shared("viewer")
        before = {pid: resources(pid) for pid in (talker.pid, listener.process.pid)}
        self.assertEqual(len(pages_of(talker.pid)), 1)
        monitors = [Terminal(MONITOR) for _ in range(10)]
        for monitor in monitors:
            self.ros.wait_until(lambda: self.name("image") in monitor.screen(), 20, "a monitor")
        for monitor in monitors:
            monitor.process.kill()
            monitor.close()
        for pid, (threads, descriptors) in before.items():
            threads_now, descriptors_now = resources(pid)
            self.assertLessEqual(threads_now, threads)  # fewer: idle ones end
            self.assertLessEqual(descriptors_now, descriptors)
        last = self.finish(talker)["last"]
        self.assertEqual(listener.numbers(), list(range(last + 1)))
        self.assertTrue(all(message["shared"] for message in listener.messages()))

    def test_nobody_else_can_write_to_a_page(self):
        self.listen(name="viewer")
        talker = self.start_talker(count=0, rate=50)
        self.wait_until_shared("viewer")
        page, = pages_of(talker.pid)
        with open(page, "r+b", buffering=0) as file:
            self.assertRaises(PermissionError, file.write, b"x")
            self.assertRaises(PermissionError, file.truncate, 0)
        self.finish(talker)


class CommandLine(MonitorCase):
    def test_statuses(self):
        status, _, trouble = self.monitor("--once", "--interval", "0", "--topic", "/no/such/topic")
        self.assertEqual(status, 1)
        self.assertRegex(trouble, "tzc-monitor: no process of this user (publishes or receives /no/such/topic|uses TZC)")
        for wrong in (["--no-such-option"], ["--why", "/node"], ["--interval", "0.01"], ["--interval", "nan"], ["--topic="], ["--why", "/a", "/b", "--json"]):
            self.assertEqual(self.monitor(*wrong)[0], 2, wrong)
        status, output, _ = self.monitor("--help")
        self.assertEqual(status, 0)
        self.assertIn("Examples:", output)
        self.assertRegex(self.monitor("--version")[1], r"^tzc-monitor \d+\.\d+\.\d+\n$")

    def test_the_terminal_is_as_before_after_a_signal(self):
        for end in (signal.SIGINT, signal.SIGTERM):
            terminal = Terminal(MONITOR)
            self.ros.wait_until(lambda: "TOPIC" in terminal.screen(), 20, "the first screen")
            terminal.process.send_signal(end)
            self.assertEqual(terminal.process.wait(60), 0)
            screen = terminal.screen()
            self.assertTrue(screen.startswith(Terminal.ENTER), screen[:40])
            self.assertTrue(screen.endswith(Terminal.LEAVE), screen[-40:])
            terminal.close()

    def test_the_terminal_is_the_shell_s_while_the_monitor_is_stopped(self):
        terminal = Terminal(MONITOR)
        self.ros.wait_until(lambda: "TOPIC" in terminal.screen(), 20, "the first screen")
        terminal.process.send_signal(signal.SIGTSTP)
        self.ros.wait_until(lambda: state_of(terminal.process.pid) == "T", 20, "the stop")
        before = terminal.screen()
        self.assertTrue(before.endswith(Terminal.LEAVE), before[-40:])
        terminal.process.send_signal(signal.SIGCONT)
        self.ros.wait_until(lambda: "TOPIC" in terminal.screen()[len(before):], 20, "another screen")
        self.assertTrue(terminal.screen()[len(before):].startswith(Terminal.ENTER))
        terminal.process.send_signal(signal.SIGINT)
        self.assertEqual(terminal.process.wait(60), 0)
        self.assertTrue(terminal.screen().endswith(Terminal.LEAVE))
        terminal.close()

    def test_in_the_background_it_waits_and_can_be_ended(self):
        """As after the shell's `tzc-monitor &` and `kill %1`, which lets a stopped job go on."""
        terminal = Terminal("setsid", "--ctty", "--wait", "bash", "-mc", '"$0" & echo "job $!"; while kill -0 $! 2>/dev/null; do sleep 0.1; done', MONITOR, is_whole=True)
        self.ros.wait_until(lambda: "job " in terminal.screen(), 20, "the job")
        job = int(re.search(r"job (\d+)", terminal.screen()).group(1))
        self.ros.wait_until(lambda: state_of(job) == "T", 20, "the stop")
        for end in (signal.SIGTERM, signal.SIGCONT):
            os.kill(job, end)
        self.assertEqual(terminal.process.wait(60), 0)
        self.assertNotIn(Terminal.ENTER, terminal.screen())
        terminal.close()


def state_of(pid):
    """R, S, T and so on, by /proc/PID/stat."""
    with open(f"/proc/{pid}/stat") as file:
        return file.read().rpartition(")")[2].split()[0]


def pages_of(pid):
    folder = f"/proc/{pid}/fd"
    return [f"{folder}/{number}" for number in os.listdir(folder)
            if os.readlink(f"{folder}/{number}") == "/memfd:tzc-statistics (deleted)"]


def resources(pid):
    return len(os.listdir(f"/proc/{pid}/task")), set(os.listdir(f"/proc/{pid}/fd"))


if __name__ == "__main__":
    main()
