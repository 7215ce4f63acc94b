# SPDX-License-Identifier: BSD-3-Clause
"""tzc's publishers and subscriptions take the place of roscpp's: every overload, every property, every name."""
from topic_case import Listener, TopicCase, main


class Publisher(TopicCase):
    def seen(self, plain):
        process = self.node("drop_in", "drop_in", {"plain": plain})
        self.assertEqual(process.wait(60), 0, process.tail())
        return [(line["what"], line["value"]) for line in Listener(process).lines()]

    def test_a_node_sees_no_difference(self):
        plain, ours = self.seen("true"), self.seen("false")
        self.assertGreater(len(plain), 40)
        self.assertNotIn("in vain", [what for what, _ in plain])
        self.assertEqual(ours, plain)


class Overloads(TopicCase):
    def test_every_overload_of_subscribe(self):
        """As many images, as right, and in shared memory wherever the callback cannot write to them."""
        lister = self.node("overloads", "lister", {"list": "true"})
        self.assertEqual(lister.wait(20), 0, lister.tail())
        overloads = {line["overload"]: line["shared"] for line in Listener(lister).lines()}
        self.assertGreater(len(overloads), 30)
        listener = Listener(self.node("overloads", "overloads", {}))
        for topic in overloads:
            self.wait_for_subscribers(self.name(topic), 1)
        shapeless = "shape_shifter"  # which cannot be shared
        self.talk(topics=" ".join(set(overloads) - {shapeless}), count=20, bytes=5000)
        self.talk(topics=shapeless, count=20, bytes=2000, shared=0)
        for topic, shared in overloads.items():
            with self.subTest(topic):
                if topic == "tracked_gone":
                    self.assertEqual(listener.numbers(topic), [])
                else:
                    self.assert_got(listener, range(20), shared=shared, topic=topic)


class Filters(TopicCase):
    WAYS = ("time", "exact", "approximate", "cache", "sequencer", "chain", "again")

    def test_all_that_message_filters_has(self):
        """Seven ways, each of which sees every image; in shared memory but for message_filters' own subscriber."""
        for plain in ("true", "false"):
            with self.subTest(plain=plain):
                self.ros.stop_since(self.before)
                filters = Listener(self.node("filters", "filters", {"plain": plain}))
                self.wait_for_subscribers(self.name("second"), 1)
                camera = self.node("camera", "camera", {"count": 50})
                self.wait_for(filters, 40, timeout=30, callback="sequencer")  # which holds back the last ones
                for way in self.WAYS:
                    if way not in ("sequencer", "approximate"):
                        self.assert_got(filters, range(50), callback=way, shared=plain == "false")
                    else:
                        numbers = filters.numbers(callback=way)
                        self.assertEqual(numbers, list(range(len(numbers))))
                        self.assertGreaterEqual(len(numbers), 40)
                self.assertEqual(filters.numbers(callback="never"), [])
                names = [line for line in filters.lines() if "resolved" in line]
                self.assertEqual(names, [{"topic": self.name("second"), "resolved": self.name("second")}])
                self.assertEqual(camera.wait(30), 0, camera.tail())


class Pictures(TopicCase):
    """A type with a hand-written serializer, whose partial form no other node could read."""

    def show(self, **parameters):
        talker = self.node("picture", "talker", parameters)
        self.assertEqual(talker.wait(40), 0, talker.tail())
        return self.counters(talker)

    def test_published(self):
        for topic_type in ("picture", "image"):
            for way in ("reference", "pointer"):
                with self.subTest(topic_type=topic_type, way=way):
                    self.ros.stop_since(self.before)
                    shared, plain = self.listen(), self.listen("plain")
                    self.show(topic_type=topic_type, way=way)
                    for listener in (shared, plain):
                        self.assert_got(listener, range(20))
                        self.assert_seq_as_tcpros(listener)

    def test_listened_to(self):
        process = self.node("picture", "viewer", {"role": "listener"})
        self.wait_for_subscribers(self.name("image"), 1)
        self.talk(count=20, shared=0)
        self.assert_got(Listener(process), range(20))

    def test_a_stock_view_of_a_twin_is_published_without_a_copy(self):
        listener = self.listen()
        counters = self.show(topic_type="image", way="view")
        self.assertEqual(counters["copied_bytes"], 0)
        self.assert_got(listener, range(20), shared=True)


class Swapped(TopicCase):
    """Two names, each remapped to the other: a name that is remapped twice would end where it began."""
    SWAP = ("left:=right", "right:=left")

    def listen_to_both(self, remaps=()):
        listener = self.node("listener", "listener", {"topics": "left right"}, remaps)
        for topic in ("left", "right"):
            self.wait_for_subscribers(self.name(topic), 1)
        return Listener(listener)

    def test_a_publishers_names(self):
        for mode in ("twin", "stock_pointer", "attached"):
            with self.subTest(mode):
                self.ros.stop_since(self.before)
                listener = self.listen_to_both()
                talker = self.start_talker(mode, topics="left right", first=0, count=20, remaps=self.SWAP)
                self.assertEqual(talker.wait(60), 0, talker.tail())
                for topic in ("left", "right"):
                    self.assert_got(listener, range(20), shared=True, topic=topic)
                only = self.start_talker(mode, topics="left", first=100, count=20, remaps=self.SWAP)
                self.assertEqual(only.wait(60), 0, only.tail())
                self.assert_got(listener, list(range(20)) + list(range(100, 120)), shared=True, topic="right")
                self.assert_got(listener, range(20), shared=True, topic="left")

    def test_a_subscribers_names(self):
        listener = self.listen_to_both(self.SWAP)
        self.talk(topics="left", first=100, count=20)
        self.assert_got(listener, range(100, 120), shared=True, topic="right")
        self.assert_got(listener, [], topic="left")


if __name__ == "__main__":
    main()
