# SPDX-License-Identifier: BSD-3-Clause
"""What happens while roscpp holds its own mutexes, in the order or for the time that roscpp may (nodes/locks.cpp)."""
from topic_case import Listener, TopicCase, main


class Locks(TopicCase):
    def scene(self, scene):
        return Listener(self.node("locks", "locks", {"scene": scene}))

    def events(self, scene):
        """What a scene says happened, when it has ended."""
        self.assertEqual(scene.process.wait(60), 0, scene.process.tail())
        return {line["event"]: line["happened"] for line in scene.lines() if "event" in line}

    def test_a_connection_that_ends_while_roscpps_queue_is_sent(self):
        shared, plain = self.listen(queue=100), self.listen("plain", name="plain", queue=100)
        self.assertEqual(self.events(self.scene("queued")), {"removed the link": True})
        for listener in (shared, plain):
            self.assert_got(listener, range(10))
            self.assert_seq_as_tcpros(listener)

    def test_a_connection_that_ends_while_its_subscriber_is_greeted(self):
        plain = self.listen("plain", queue=100)
        self.assertEqual(self.events(self.scene("alone")), {"removed the link": True})
        self.assert_got(plain, range(10))

    def test_a_node_that_waits_for_the_master_serves_its_subscribers(self):
        first = self.listen(queue=100)
        scene = self.scene("away")
        self.ros.wait_until(lambda: any(line.get("event") == "ready" for line in scene.lines()), 60, "the scene")
        second = self.listen(name="second", queue=100)
        self.assertEqual(self.events(scene), {"ready": True, "the second subscriber is shared": True})
        for listener in (first, second):
            self.assert_got(listener, range(10), shared=True)


if __name__ == "__main__":
    main()
