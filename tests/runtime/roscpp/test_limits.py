# SPDX-License-Identifier: BSD-3-Clause
"""What is scarce (descriptors, memory, room in a record) costs speed and a line in the log, never a message."""
import os

from topic_case import Listener, TopicCase, main


class Descriptors(TopicCase):
    def crowd(self, limit=1024, **parameters):
        return self.node("crowd", "crowd", parameters, runner=["prlimit", f"--nofile={limit}:{limit}"])

    def event(self, node, event, timeout=60):
        self.ros.wait_until(lambda: f'"event": "{event}"' in node.log() or not node.alive(), timeout,
                            event)
        found = [line for line in Listener(node).lines() if line.get("event") == event]
        self.assertTrue(found, node.tail())
        return found[0]

    def test_more_topics_than_descriptors(self):
        """roscpp advertises 1100 topics with 15 descriptors."""
        crowd = self.crowd(topics=1100, count=0)
        self.assertEqual(self.event(crowd, "advertised")["topics"], 1100)

    def test_a_subscriber_that_came_when_there_were_none_is_invited_when_there_are(self):
        listener = self.listen(queue=100)
        scarce = self.node("scarce", "scarce", {})
        self.assertEqual(scarce.wait(150), 0, scarce.tail())
        events = {line["event"]: line["happened"] for line in Listener(scarce).lines()}
        self.assertEqual(events, {"shared without descriptors": False, "shared with some": True})
        self.assert_got(listener, range(10), shared=True)

    def test_a_sandbox_that_forbids_to_ask_for_random_numbers(self):
        listener = self.listen(queue=100)
        scarce = self.node("scarce", "scarce", {"lacks": "entropy"})
        self.assertEqual(scarce.wait(150), 0, scarce.tail())
        self.assertEqual([line["happened"] for line in Listener(scarce).lines()], [True])
        self.assert_got(listener, range(10), shared=True)

    def publish_all(self, count, limit):
        """Each topic's messages arrive. Returns the crowd, and how many topics share memory."""
        listener = self.node("listener", "listener", {"topics": " ".join(f"image{i}" for i in range(count))})
        crowd = self.crowd(limit, topics=count, subscribers=count)
        shared = self.event(crowd, "all published", 120)["shared"]
        heard = Listener(listener)
        self.wait_for(heard, 20 * count, 30)
        for i in range(count):
            self.assertEqual(heard.numbers(f"image{i}"), list(range(20)))
        self.assertTrue(all(m["right"] for m in heard.messages()))
        return crowd, shared

    def test_topics_that_roscpp_manages(self):
        """More connections than a descriptor each would allow."""
        self.assertEqual(self.publish_all(400, 1024)[1], 400)

    def test_topics_that_roscpp_just_manages(self):
        """roscpp alone uses most descriptors: TZC shares what fits beside it, and there is a line in the log that says what to do."""
        crowd, shared = self.publish_all(400, 520)
        self.assertGreater(shared, 20)
        self.assertLess(shared, 400)
        warnings = [line for line in crowd.log().splitlines() if "WARN" in line and "TZC" in line]
        self.assertTrue(1 <= len(warnings) <= 4, crowd.log())
        for warning in warnings:  # of connections that stay there, and of those that find no descriptor for their first message
            self.assertTrue("stay on TCPROS" in warning or "goes back to TCPROS" in warning, warning)
            for word in ("descriptors", "520", "ulimit -n"):
                self.assertIn(word, warning)


def reading_threads(pid):
    """The threads of a process that read shared messages."""
    names = []
    for task in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{task}/comm", encoding="ascii") as name:
            names.append(name.read().strip())
    return names.count("tzc-reader")


class Threads(TopicCase):
    def readers_of(self, count, **parameters):
        listener = self.node("listener", "listener", dict({"topics": " ".join(f"image{i}" for i in range(count))}, **parameters))
        crowd = self.node("crowd", "crowd", {"topics": count, "subscribers": count})
        self.ros.wait_until(lambda: '"all published"' in crowd.log() or not crowd.alive(), 60, "all published")
        self.assertIn(f'"shared": {count}', crowd.log())
        heard = Listener(listener)
        self.wait_for(heard, 20 * count, 30)
        for i in range(count):
            self.assertEqual(heard.numbers(f"image{i}"), list(range(20)))
        return reading_threads(listener.pid)

    def test_one_thread_reads_all_topics(self):
        self.assertEqual(self.readers_of(30), 1)

    def test_direct_callbacks_have_one_each(self):
        self.assertEqual(self.readers_of(4, mode="direct"), 4)


class Records(TopicCase):
    def test_more_arrays_than_a_record_can_name(self):
        """They travel serialized, in their place among the others, with one warning."""
        process = self.node("scattered", "listener", {"mode": "listen"})
        listener = Listener(process)
        self.wait_for_subscribers(self.name("cloud"), 1)
        talker = self.node("scattered", "talker", {"mode": "talk", "channels": "3 4096 4097 5000 3"})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.wait_for(listener, 5)
        self.assertEqual([m["channels"] for m in listener.messages()], [3, 4096, 4097, 5000, 3])
        self.assertTrue(all(m["right"] for m in listener.messages()))
        self.assert_seq_as_tcpros(listener)
        counters = self.counters(talker)
        self.assertEqual((counters["shared"], counters["serialized"], counters["dropped"]), (3, 2, 0))
        warnings = [line for line in talker.log().splitlines() if "WARN" in line and "TZC" in line]
        self.assertEqual(len(warnings), 1, talker.log())
        for word in (self.name("cloud"), "4096 blocks", "allocate"):
            self.assertIn(word, warnings[0])

    def test_arrays_of_strings_and_of_messages_that_have_some(self):
        """They go through shared memory whatever their length, to a subscriber on TCPROS as ever."""
        listeners = [Listener(self.node("paths", "listener", {"mode": "listen"})),
                     Listener(self.node("paths", "plain", {"mode": "listen", "plain": True}))]
        self.wait_for_subscribers(self.name("path"), 2)
        lengths = [0, 3, 5, 100, 1000, 20000, 3]
        talker = self.node("paths", "talker", {"mode": "talk", "poses": " ".join(map(str, lengths)), "subscribers": 2})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        for listener in listeners:
            self.wait_for(listener, len(lengths))
            self.assertEqual([m["poses"] for m in listener.messages()], lengths)
            self.assertTrue(all(m["right"] for m in listener.messages()))
            self.assert_seq_as_tcpros(listener)
        counters = self.counters(talker)
        self.assertEqual((counters["shared"], counters["serialized"]), (len(lengths), 0))


if __name__ == "__main__":
    main()
