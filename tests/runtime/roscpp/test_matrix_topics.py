# SPDX-License-Identifier: BSD-3-Clause
"""Ported to ported: how many, under which names, in which order they start, and who comes back."""
from topic_case import TopicCase, main


class Many(TopicCase):
    def test_eight_subscribers(self):
        listeners = [self.listen() for _ in range(8)]
        counters = self.talk(count=50, subscribers=8)
        for listener in listeners:
            self.assert_got(listener, range(50), shared=True)
            self.assert_seq_as_tcpros(listener)
        self.assertEqual(counters["copied_bytes"], 0)

    def test_several_publishers_on_a_topic(self):
        listener = self.listen()
        talkers = [self.start_talker(name=f"talker{i}", first=1000 * i, count=50) for i in range(3)]
        for talker in talkers:
            self.assertEqual(talker.wait(40), 0, talker.tail())
        messages = listener.messages()
        self.assertTrue(all(message["right"] and message["shared"] for message in messages))
        for i in range(3):
            mine = [m["number"] for m in messages if m["number"] // 1000 == i]
            self.assertEqual(mine, list(range(1000 * i, 1000 * i + 50)))

    def test_several_topics_of_a_node(self):
        topics = ["image", "left/image", "right/image"]
        listener = self.listen(topics=" ".join(topics))
        self.talk(topics=" ".join(topics), count=50)
        for topic in topics:
            self.assert_got(listener, range(50), shared=True, topic=topic)


class Unreliable(TopicCase):
    def test_who_asks_for_udpros_gets_it(self):
        unreliable, shared = self.listen("unreliable", queue=200), self.listen(queue=200)
        talker = self.start_talker(count=50, rate=50, bytes=1000, subscribers=2, shared=1, queue=200, linger=3)
        self.ros.wait_until(lambda: self.transports(self.name("talker")) == {"UDPROS", "TZC"}, 20, "both transports")
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(unreliable, range(50), shared=False)
        self.assert_got(shared, range(50), shared=True)
        self.assert_seq_as_tcpros(unreliable)


class TwoPublishersOfANode(TopicCase):
    def test_the_ported_one_ends_and_the_plain_one_goes_on(self):
        """Who is on shared memory stays there."""
        shared, plain = self.listen(queue=1000), self.listen("plain", queue=1000)
        talker = self.start_talker("handover", count=100, subscribers=2, shared=1, queue=200)
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(shared, range(100))
        self.assert_got(plain, range(100), shared=False)
        self.assertEqual([m["number"] for m in shared.messages() if m["shared"]], list(range(50)))
        self.assert_seq_as_tcpros(shared)


class Names(TopicCase):
    def test_remapped(self):
        listener = self.listen(remaps=["image:=camera/picture"], topic="camera/picture")
        self.talk(remaps=["image:=camera/picture"], count=20)
        self.assert_got(listener, range(20), shared=True)

    def test_remapped_on_one_side(self):
        listener = self.listen(remaps=["picture:=image"], topics="picture")
        self.talk(count=20)
        self.assert_got(listener, range(20), shared=True)

    def test_private_name(self):
        listener = self.listen(topics=self.name("talker/image"), topic="talker/image")
        self.talk(topics="~image", count=20)
        self.assert_got(listener, range(20), shared=True)

    def test_namespace_pushed_down(self):
        listener = self.listen(topics="deep/er/image", topic="deep/er/image")
        self.talk(remaps=[f"__ns:={self.ns}/deep/er"], count=20)
        self.assert_got(listener, range(20), shared=True)

    def test_names_that_only_differ_in_separators(self):
        listener = self.listen(topics="a/b_c a_b/c", topic="a/b_c")
        self.start_talker(name="first", topics="a/b_c", count=20).wait(30)
        self.start_talker(name="second", topics="a_b/c", first=100, count=20).wait(30)
        self.assert_got(listener, range(20), shared=True, topic="a/b_c")
        self.assert_got(listener, range(100, 120), shared=True, topic="a_b/c")


class ComingAndGoing(TopicCase):
    def test_talker_first(self):
        talker = self.start_talker(count=50)
        self.ros.wait_until(lambda: self.ros.publishers(self.name("image")), 20, "the talker")
        listener = self.listen()
        talker.wait(30)
        self.assert_got(listener, range(50), shared=True)

    def test_late_joiners(self):
        first = self.listen()
        talker = self.start_talker(count=0, rate=100)
        self.wait_for(first, 50)
        second = self.listen()
        self.wait_for(second, 50)
        talker.stop()
        self.assert_got(first, range(len(first.numbers())), shared=True)
        start = second.numbers()[0]
        self.assert_got(second, range(start, start + len(second.numbers())))
        self.assertTrue(all(message["shared"] for message in second.messages()[20:]))

    def test_restarted_talker(self):
        listener = self.listen()
        for restart in range(3):
            self.talk(first=100 * restart, count=20)
        self.assert_got(listener, [100 * i + k for i in range(3) for k in range(20)], shared=True)

    def test_restarted_listener(self):
        talker = self.start_talker(count=0, rate=100)
        for _ in range(3):
            listener = self.listen(name="listener")
            self.wait_for(listener, 50)
            self.assertEqual(listener.process.stop(), 0)
            numbers = listener.numbers()
            self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
            self.assertTrue(all(message["right"] for message in listener.messages()))
            self.assertTrue(listener.messages()[-1]["shared"])
        self.assertTrue(talker.alive())


class Roscore(TopicCase):
    def test_restarted_roscore(self):
        """What is connected stays connected; who starts later finds whoever registers anew, as with plain ROS."""
        listener = self.listen()
        talker = self.start_talker(count=0, rate=100)
        self.wait_for(listener, 30)
        self.ros.restart_core()
        seen = len(listener.numbers())
        self.wait_for(listener, seen + 100)
        talker.stop()
        self.assert_got(listener, range(len(listener.numbers())), shared=True)
        newcomer = self.listen()
        self.talk(count=20)
        self.assert_got(newcomer, range(20), shared=True)


if __name__ == "__main__":
    main()
