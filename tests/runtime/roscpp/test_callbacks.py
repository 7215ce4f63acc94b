# SPDX-License-Identifier: BSD-3-Clause
"""Callbacks of every kind, spinners and queues; subscriptions that end in their own callback; messages that outlive."""
import time

from topic_case import Listener, TopicCase, main


class Callbacks(TopicCase):
    def several(self, callbacks):
        process = self.node("several", "several", {"callbacks": callbacks})
        self.ros.wait_until(lambda: '"ready"' in process.log(), 20, "all callbacks")
        return Listener(process)

    def test_readers_in_one_process_share(self):
        listener = self.several("pointer event plain")
        self.talk(count=30)
        for callback in ("pointer", "event", "plain"):
            self.assert_got(listener, range(30), shared=True, callback=callback)
        self.assertEqual({m["publisher"] for m in listener.messages(callback="event")}, {self.name("talker")})

    def test_different_types_in_one_process(self):
        listener = self.several("pointer shape_shifter event")
        self.talk(count=30)
        for callback in ("pointer", "event"):
            self.assert_got(listener, range(30), shared=True, callback=callback)
        self.assert_got(listener, range(30), callback="shape_shifter")

    def test_only_another_type(self):
        """A process that attached the topic for images and only has a ShapeShifter callback."""
        listener = self.several("attach shape_shifter")
        self.assertEqual(self.talk(count=30)["shared"], 30)
        self.assert_got(listener, range(30), callback="shape_shifter")

    def test_a_writer_spoils_nothing_for_readers(self):
        listener = self.several("mutable pointer value")
        self.talk(count=30)
        for callback in ("mutable", "pointer", "value"):
            self.assert_got(listener, range(30), callback=callback)

    def test_spinners_and_queues(self):
        listeners = {spinner: self.listen(spinner=spinner) for spinner in ("spin", "tzc", "multi", "async", "own", "tzc_multi", "tzc_async",
                                                                     "tzc_own")}
        counters = self.talk(count=100, rate=200, subscribers=8)
        self.assertEqual((counters["shared"], counters["copied_bytes"]), (800, 0))
        for listener in listeners.values():
            self.assert_got(listener, range(100), shared=True)

    def test_bursts_come_in_order_whoever_spins(self):
        """Of several messages that a guest reads at once the first is called past the queue, and is the first."""
        listeners = [self.listen(spinner=spinner, queue=2000) for spinner in ("tzc", "tzc_multi", "tzc_async")]
        self.talk(count=2000, rate=100000, subscribers=3, queue=2000)
        for listener in listeners:
            self.assert_got(listener, range(2000), shared=True)


class Ends(TopicCase):
    def keep(self, **parameters):
        keeper = self.node("keeper", "keeper", dict({"keep": 5}, **parameters))
        self.wait_for_subscribers(self.name("image"), 1)
        return keeper

    def test_messages_outlive_subscriber_and_publisher(self):
        talker = self.start_talker(count=0, rate=100, subscribers=2, queue=10)
        keeper = self.keep(outlive=talker.pid)
        bystander = self.listen()
        self.wait_for(bystander, 60)  # far more than the talker's memory holds: blocks would have been reused
        self.assertTrue(keeper.alive() and not Listener(keeper).lines())
        talker.kill()
        self.assertEqual(keeper.wait(30), 0, keeper.tail())
        self.assert_got(Listener(keeper), range(5), shared=True)

    def test_subscriber_destroyed_in_its_own_callback(self):
        for direct in ("false", "true"):
            keeper = self.keep(direct=direct)
            talker = self.start_talker(name=f"talker_{direct}", count=0, rate=100)
            self.assertEqual(keeper.wait(30), 0, keeper.tail())
            self.assert_got(Listener(keeper), range(5), shared=True)
            self.assertTrue(talker.alive())
            talker.stop()

    def test_messages_in_a_static_object_of_a_callback_are_read_at_exit(self):
        talker = self.start_talker(count=0, rate=100)
        keeper = self.keep(at_exit="true")
        self.assertEqual(keeper.wait(30), 0, keeper.tail())
        self.assert_got(Listener(keeper), range(5), shared=True)
        self.assertTrue(talker.alive())

    def test_shutdown_in_a_callback(self):
        for direct in ("false", "true"):
            keeper = self.keep(shutdown="true", direct=direct)
            talker = self.start_talker(name=f"talker_{direct}", count=0, rate=100)
            self.assertEqual(keeper.wait(30), 0, keeper.tail())
            self.assert_got(Listener(keeper), range(5), shared=True)
            talker.stop()

    def test_nodes_end_quickly_while_messages_flow(self):
        listener = self.listen()
        talker = self.start_talker(count=0, rate=500)
        self.wait_for(listener, 100)
        for process in (listener.process, talker):
            begin = time.monotonic()
            self.assertEqual(process.stop(), 0, process.tail())
            self.assertLess(time.monotonic() - begin, 2 * self.slowness())


if __name__ == "__main__":
    main()
