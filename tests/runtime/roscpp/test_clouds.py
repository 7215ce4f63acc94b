# SPDX-License-Identifier: BSD-3-Clause
"""PCL clouds, published as they are."""
import itertools

from topic_case import Listener, TopicCase, main

POINTS = 1000
BYTES = 16 * POINTS  # PointXYZ is padded


class Clouds(TopicCase):
    def listen(self, **parameters):
        listener = self.node("clouds", "cloud_listener", dict(parameters, role="listener"))
        self.wait_for_subscribers(self.name("points"), 1)
        return Listener(listener)

    def talk(self, env=None, **parameters):
        talker = self.node("clouds", "cloud_talker", dict({"points": POINTS}, **parameters), env=env)
        self.assertEqual(talker.wait(40), 0, talker.tail())
        return self.counters(talker)

    def test_copied_once(self):
        for topic_type, pointer in itertools.product(("cloud", "message", "attached"), ("false", "true")):
            with self.subTest(topic_type=topic_type, pointer=pointer):
                self.ros.stop_since(self.before)
                listener = self.listen()
                counters = self.talk(topic_type=topic_type, pointer=pointer)
                self.assertEqual(counters["copied_bytes"], 50 * BYTES)
                self.assertEqual(counters["serialized"], 0)
                self.assert_got(listener, range(50), shared=True)
                if topic_type != "cloud":  # whose header.seq roscpp leaves alone
                    self.assert_seq_as_tcpros(listener)

    def test_callbacks_that_take_clouds(self):
        for how in ("as_cloud", "filter"):
            with self.subTest(how=how):
                self.ros.stop_since(self.before)
                listener = self.listen(**{how: "true"})
                counters = self.talk()
                self.assertEqual((counters["copied_bytes"], counters["serialized"]), (50 * BYTES, 0))
                self.assert_got(listener, range(50))

    def test_without_memory_they_travel_whole_and_in_order(self):
        """Memory for three clouds, and a subscriber that keeps all it gets."""
        for pointer in ("false", "true"):
            with self.subTest(pointer=pointer):
                self.ros.stop_since(self.before)
                listener = self.listen(keep="true")
                counters = self.talk(pointer=pointer, memory=4 * BYTES)
                self.assert_got(listener, range(50))
                self.assertGreater(counters["exhausted"], 0)
                shared = [message["shared"] for message in listener.messages()]
                self.assertTrue(any(shared) and not all(shared))

    def test_without_memory_they_are_dropped_when_told_to(self):
        listener = self.listen(keep="true")
        counters = self.talk(env={"TZC_ON_EXHAUSTED": "drop"}, memory=4 * BYTES)
        self.assertGreater(counters["dropped"], 0)
        self.assertEqual(len(listener.numbers()) + counters["dropped"], 50)


if __name__ == "__main__":
    main()
