# SPDX-License-Identifier: BSD-3-Clause
"""Nodes with another version of TZC, and a roscpp that TZC does not know: TCPROS, nothing lost, one line in the log."""
import os
import shutil
import subprocess
import sys
import xmlrpc.client

from topic_case import NODES, TopicCase, main

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))
from master_proxy import MasterProxy  # noqa: E402


def tzc_warnings(process):
    return [line for line in process.log().splitlines() if "WARN" in line and "TZC" in line]


class OtherVersion(TopicCase):
    """The publisher's offers reach the subscriber with another number in front, as those of another release would. Each of
    the two is then a node of this version that has met one of another."""

    def setUp(self):
        super().setUp()
        self.nodes = []
        self.master = MasterProxy(self.ros.uri)
        self.addCleanup(self.master.__exit__)
        self.master.__enter__()

    def node_proxy(self, uri, version):
        """Stands in front of a node, and gives offers that version."""
        proxy = MasterProxy(uri)
        self.addCleanup(proxy.__exit__)
        proxy.__enter__()
        self.nodes.append(proxy)

        def offer_again(_, __, parameters):
            with xmlrpc.client.ServerProxy(uri) as node:
                return node.tzcOffer(version, *parameters[1:])
        proxy.first("tzcOffer", 1000, offer_again)
        return proxy.uri

    def start_talker_of_version(self, version, **parameters):
        def lookup(master, _, arguments):
            with xmlrpc.client.ServerProxy(self.ros.uri) as real:  # the test's own is for one thread
                code, status, uri = real.lookupNode(*arguments)
            return [code, status, self.node_proxy(uri, version)]
        self.master.first("lookupNode", 1000, lookup)
        return self.start_talker(shared=0, env={"ROS_MASTER_URI": self.master.uri}, **parameters)

    def offers(self):
        return sum(proxy.calls("tzcOffer") for proxy in self.nodes)

    def assert_one_line(self, process, peer):
        warnings = tzc_warnings(process)
        self.assertEqual(len(warnings), 1, process.log())
        for word in (peer, "another version of TZC", self.name(""), "stay on TCPROS", "build both nodes", "share/doc/tzc/versions.md"):
            self.assertIn(word, warnings[0])

    def meet(self, version):
        """Two topics from a talker to two listeners."""
        first, second = self.listen(name="first"), self.listen(name="second")
        talker = self.start_talker_of_version(version, count=100, rate=50, subscribers=2, settle=2)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        for listener in (first, second):
            self.assert_got(listener, range(100), shared=False)
            self.assert_seq_as_tcpros(listener)
            self.assert_one_line(listener.process, self.name("talker"))
        self.assertEqual(self.offers(), 2, "an offer that was refused was made again")
        warnings = tzc_warnings(talker)
        self.assertEqual(len(warnings), 2, talker.log())
        for name in ("first", "second"):
            self.assertEqual(len([line for line in warnings if self.name(name) in line]), 1, talker.log())

    def test_a_newer_one(self):
        self.meet(2_000_000_000)

    def test_an_older_one(self):
        """The first releases sent their protocol's number alone."""
        self.meet(1)

    def test_one_line_for_several_topics(self):
        listener = self.node("listener", "listener", {"topics": "left middle right"})
        for topic in ("left", "middle", "right"):
            self.wait_for_subscribers(self.name(topic), 1)
        talker = self.start_talker_of_version(7, count=20, topics="left middle right", settle=2)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assertEqual(self.offers(), 3)
        self.assert_one_line(listener, self.name("talker"))
        self.assert_one_line(talker, self.name("listener"))


class UnknownRoscpp(TopicCase):
    """roscpp itself under the name of a version that TZC does not know."""

    def library_of_version(self, version):
        """The folder with a copy of the roscpp that the nodes run on."""
        linked = subprocess.run(["ldd", os.path.join(NODES, "talker")], stdout=subprocess.PIPE, check=True).stdout.decode()
        soname, path = [(line.split()[0], line.split()[2]) for line in linked.splitlines() if "libroscpp.so" in line][0]
        folder = os.path.join(self.scratch, f"roscpp-{version}")
        os.makedirs(folder, exist_ok=True)
        library = os.path.join(folder, f"libroscpp.so.{version}")
        shutil.copy(os.path.realpath(path), library)
        os.symlink(library, os.path.join(folder, soname))
        return folder

    def publish_on(self, version, shared):
        env = {"LD_LIBRARY_PATH": f"{self.library_of_version(version)}:{os.environ.get('LD_LIBRARY_PATH', '')}"}
        listener = self.listen()
        talker = self.start_talker(count=50, rate=100, shared=int(shared), env=env)
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(listener, range(50), shared=shared)
        return listener, talker, env

    def test_an_unknown_version_stays_on_tcpros_with_one_line(self):
        listener, talker, env = self.publish_on("1.18.0", shared=False)
        warnings = tzc_warnings(talker)
        self.assertEqual(len(warnings), 1, talker.log())
        for word in ("every topic", "stays on TCPROS", "roscpp 1.18.0", "1.15.9 to 1.17", "libroscpp.so.1.18.0"):
            self.assertIn(word, warnings[0])
        self.assertEqual(tzc_warnings(listener.process), [])

    def test_nor_does_a_subscriber_on_it_come_to_shared_memory(self):
        env = {"LD_LIBRARY_PATH": self.library_of_version("1.19.3")}
        for mode in ("pointer", "direct"):
            with self.subTest(mode):
                listener = self.listen(mode, env=env)
                talker = self.start_talker(count=50, rate=100, shared=0)
                self.assertEqual(talker.wait(60), 0, talker.tail())
                self.assert_got(listener, range(50), shared=False)
                self.assertEqual(len(tzc_warnings(listener.process)), 1, listener.process.log())
                self.assertEqual(tzc_warnings(talker), [])
                listener.process.stop()

    def test_a_version_that_is_known_is_used(self):
        """By its number: the copy alone changes nothing."""
        _, talker, _ = self.publish_on("1.17.4", shared=True)
        self.assertEqual(tzc_warnings(talker), [])


if __name__ == "__main__":
    main()
