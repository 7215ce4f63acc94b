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
            self.assertEqual(self.counters(talker)["copied_bytes"], 0)
        self.wait_for(listener, 150)
        messages = listener.messages()
        self.assertEqual(len(messages), 150)
        self.assertTrue(all(message["right"] and message["shared"] for message in messages))
        for i in range(3):
            mine = [(m["number"], m["seq"]) for m in messages if m["number"] // 1000 == i]
            self.assertEqual(mine, [(1000 * i + k, k) for k in range(50)])

    def test_several_topics_of_a_node(self):
        topics = ["image", "left/image", "right/image"]
        listener = self.listen(topics=" ".join(topics))
        counters = self.talk(topics=" ".join(topics), count=50)
        self.assertEqual(counters["copied_bytes"], 0)
        for topic in topics:
            self.assert_got(listener, range(50), shared=True, topic=topic)

    def test_memory_of_a_publisher_that_is_not_advertised(self):
        """A message that one of two publishers sends is built with the other one, which is not advertised: no copy."""
        self.assert_shared_without_a_copy("stranger")

    def test_memory_of_the_node(self):
        """A message that is built where its publisher is not known: no copy."""
        self.assert_shared_without_a_copy("of_node")

    def assert_shared_without_a_copy(self, mode):
        listener = self.listen()
        counters = self.talk(mode, count=50)
        self.assert_got(listener, range(50), shared=True)
        self.assertEqual((counters["shared"], counters["copied_bytes"]), (50, 0))


class Unreliable(TopicCase):
    def test_who_asks_for_udpros_gets_it(self):
        unreliable, shared = self.listen("unreliable", queue=200), self.listen(queue=200)
        talker = self.start_talker(count=50, rate=50, bytes=5000, subscribers=2, shared=1, queue=200, linger=3)
        self.ros.wait_until(lambda: self.transports(self.name("talker")) == {"UDPROS", "TZC"}, 20, "both transports")
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(unreliable, range(50), shared=False)
        self.assert_got(shared, range(50), shared=True)
        self.assert_seq_as_tcpros(unreliable)


class TwoPublishersOfANode(TopicCase):
    def test_the_ported_one_ends_and_the_plain_one_goes_on(self):
        """Who is on shared memory stays there, and gets what roscpp has serialized as views, too."""
        shared, plain = self.listen(queue=1000), self.listen("plain", queue=1000)
        talker = self.start_talker("handover", count=100, subscribers=2, shared=1, queue=200)
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(shared, range(100), shared=True)
        self.assert_got(plain, range(100), shared=False)
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
        """Each gets everything from its first message to the talker's last one, with the talker's numbers."""
        first = self.listen()
        talker = self.start_talker(count=0, rate=100)
        self.wait_for(first, 50)
        late = [self.listen() for _ in range(2)]
        for listener in late:
            self.ros.wait_until(lambda: any(m["shared"] for m in listener.messages()), 60, "its move")
        end = self.finish(talker)["last"] + 1
        self.assert_got(first, range(end), shared=True)
        for listener in late:
            self.assert_got(listener, range(listener.numbers()[0], end))
            self.assert_seq_as_tcpros(listener, listener.numbers()[0])
            self.assert_moved(listener)

    def test_restarted_talker(self):
        listener = self.listen()
        for restart in range(3):
            self.talk(first=100 * restart, count=20)
        self.assert_got(listener, [100 * i + k for i in range(3) for k in range(20)], shared=True)

    def test_restarted_listener(self):
        talker = self.start_talker(count=0, rate=100)
        for _ in range(3):
            listener = self.listen(name="listener")
            self.wait_for_shared(listener, 50)
            self.assertEqual(listener.process.stop(), 0)
            first = listener.numbers()[0]
            self.assert_got(listener, range(first, first + len(listener.numbers())))
            self.assert_seq_as_tcpros(listener, first)
            self.assert_moved(listener)
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
        end = self.finish(talker)["last"] + 1
        self.assert_got(listener, range(end), shared=True)
        newcomer = self.listen()
        self.talk(count=20)
        self.assert_got(newcomer, range(20), shared=True)


if __name__ == "__main__":
    main()
