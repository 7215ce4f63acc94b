# SPDX-License-Identifier: BSD-3-Clause
"""Ported and unported nodelets in one manager: loaded, unloaded, loaded again; intraprocess pointers as ever."""
import os

from topic_case import NODES, Listener, TopicCase, main

NODELETS = os.path.join(os.path.dirname(NODES.rstrip("/")), "nodelets")


class Nodelets(TopicCase):
    session_env = {"ROS_PACKAGE_PATH": os.pathsep.join(filter(None, [
        NODELETS, os.environ.get("ROS_PACKAGE_PATH", "/usr/share")]))}

    def manage(self):
        manager = self.ros.start(["/usr/lib/nodelet/nodelet", "manager", "__name:=manager", f"__ns:={self.ns}"],
                                 name="manager")
        return Listener(manager)

    def load(self, kind, name, **parameters):
        loader = self.ros.start(["/usr/lib/nodelet/nodelet", "load", f"tzc_test_nodelets/{kind}", "manager",
                                 f"__name:={name}", f"__ns:={self.ns}"] +
                                [f"_{key}:={value}" for key, value in parameters.items()], name=name)
        side = self.ros.publishers if kind == "Talker" else self.ros.subscribers
        self.ros.wait_until(lambda: side(self.name("image")), 20, f"{name} to be loaded")
        return loader

    def assert_followed(self, numbers, at_least):
        self.assertGreaterEqual(len(numbers), at_least)
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))

    def wait_for_shared(self, listener, count, topic=None, after=0):
        """So many of the messages after the first ones come through shared memory; how long a move takes is the
        machine's affair. Once moved they all do."""
        def shared():
            return [m["shared"] for m in listener.messages(topic)[after:]]
        self.ros.wait_until(lambda: sum(shared()) >= count, 20, f"{count} shared messages")
        self.assertEqual(shared()[-count:], count * [True])

    def test_intraprocess_pointers_between_ported_and_unported(self):
        for mode in ("stock_pointer", "plain"):
            manager = self.manage()
            self.load("Listener", "ported")
            self.load("Listener", "unported", ported="false")
            self.load("Talker", "talker", mode=mode)
            for who in ("ported", "unported"):
                self.wait_for(manager, 30, topic=self.name(who))
            seen_by = [manager.messages(self.name(who)) for who in ("ported", "unported")]
            last = max(seen[-1]["number"] for seen in seen_by)
            # Its line may come after those of who has it already.
            self.ros.wait_until(lambda: manager.messages("published")[-1]["number"] >= last, 20, f"message {last} to be noted")
            published = {m["number"]: m["address"] for m in manager.messages("published")}
            for seen in seen_by:
                self.assert_followed([m["number"] for m in seen], 30)
                self.assertTrue(all(m["right"] for m in seen))
                self.assertEqual([m for m in seen if m["address"] != published[m["number"]]], [], "copied")
            self.ros.stop_since(self.before)

    def test_twin_inside_and_outside_of_the_manager(self):
        manager = self.manage()
        outside, plain = self.listen(), self.listen("plain")
        self.load("Listener", "ported")
        self.load("Listener", "unported", ported="false")
        self.load("Talker", "talker")
        for listener, topic in ((manager, self.name("ported")), (manager, self.name("unported")), (outside, None)):
            self.wait_for_shared(listener, 30, topic)
            seen = listener.messages(topic)
            self.assert_followed([m["number"] for m in seen], 30)
            self.assertTrue(all(m["right"] for m in seen))
        self.wait_for(plain, 20)
        self.assert_followed(plain.numbers(), 20)
        self.assertTrue(all(m["right"] for m in plain.messages()))
        self.assertTrue(not any(m["shared"] for m in plain.messages()))

    def test_a_writer_beside_the_talker_spoils_nothing(self):
        """A lone callback that may write gets a copy of its own, also in the publisher's process."""
        for mode, how in (("twin", "mutable"), ("twin", "filter"), ("stock", "mutable")):
            with self.subTest(mode=mode, how=how):
                manager, outside = self.manage(), self.listen()
                self.load("Writer", "writer", mode=how)
                self.wait_for_subscribers(self.name("image"), 2)
                self.load("Talker", "talker", mode=mode)
                self.wait_for_shared(outside, 30)
                self.wait_for(manager, 30, topic=self.name("writer"))
                self.assertTrue(manager.process.alive(), manager.process.tail())
                for seen in (outside.messages(), manager.messages(self.name("writer"))):
                    self.assert_followed([m["number"] for m in seen], 30)
                    self.assertTrue(all(m["right"] for m in seen), "some bytes are wrong")
                self.ros.stop_since(self.before)

    def test_loaded_unloaded_loaded_again(self):
        manager = self.manage()
        outside = self.listen()
        for _ in range(3):
            talker = self.load("Talker", "talker")
            seen = len(outside.numbers())
            self.wait_for_shared(outside, 20, after=seen)
            talker.stop()
            self.ros.wait_until(lambda: not self.ros.publishers(self.name("image")), 20, "talker to be unloaded")
        self.assertTrue(manager.process.alive(), manager.process.tail())
        lives = [m["number"] for m in outside.messages()]
        restarts = [i for i in range(1, len(lives)) if lives[i] != lives[i - 1] + 1]
        self.assertEqual(len(restarts), 2, "each life counts from the start, without a gap")
        self.assertTrue(all(m["right"] for m in outside.messages()))

    def test_listener_loaded_again(self):
        manager = self.manage()
        talker = self.start_talker(count=0, rate=100, subscribers=0)
        for life in range(3):
            listener = self.load("Listener", f"listener{life}")
            self.wait_for_shared(manager, 20, topic=self.name(f"listener{life}"))
            mine = manager.messages(self.name(f"listener{life}"))
            self.assert_followed([m["number"] for m in mine], 20)
            self.assertTrue(all(m["right"] for m in mine))
            listener.stop()
            self.ros.wait_until(lambda: not self.ros.subscribers(self.name("image")), 20, "listener to be unloaded")
        self.assertTrue(manager.process.alive() and talker.alive())


if __name__ == "__main__":
    main()
