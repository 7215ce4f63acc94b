# SPDX-License-Identifier: BSD-3-Clause
"""A TCPROS connection becomes a shared one, and back: real nodes, a real roscore."""
import signal
import time

from topic_case import TopicCase, main


class Upgrade(TopicCase):
    def test_twin_is_shared_without_a_copy(self):
        listener = self.listen()
        counters = self.talk(count=50)
        self.assert_got(listener, range(50), shared=True)
        self.assert_seq_as_tcpros(listener)
        self.assertEqual(counters["copied_bytes"], 0)
        self.assertEqual(counters["shared"], 50)

    def test_twin_by_pointer(self):
        listener = self.listen()
        counters = self.talk("twin_pointer", count=20)
        self.assert_got(listener, range(20), shared=True)
        self.assertEqual(counters["copied_bytes"], 0)

    def test_stock_message_is_copied_once(self):
        for mode in ("stock", "stock_pointer"):
            with self.subTest(mode):
                listener = self.listen()
                counters = self.talk(mode, count=20, bytes=100000)
                self.assert_got(listener, range(20), shared=True)
                self.assertEqual(counters["copied_bytes"], 20 * 100000)
                listener.process.stop()

    def test_attached_to_a_topic_that_others_advertised(self):
        shared, plain = self.listen(), self.listen("plain")
        counters = self.talk("attached", count=50, subscribers=2, shared=1)
        self.assert_got(shared, range(50), shared=True)
        self.assert_got(plain, range(50), shared=False)
        self.assert_seq_as_tcpros(shared)
        self.assertEqual(counters["shared"], 50)

    def test_attached_latched(self):
        self.start_talker("attached", count=1, latch=True, subscribers=0, linger=300)
        listener = self.listen()
        self.assert_got(listener, range(1))

    def test_attached_for_another_type_goes_on_as_before(self):
        listener = self.listen()
        counters = self.talk("attached_wrong", count=20)
        self.assert_got(listener, range(20), shared=False)
        self.assertEqual(counters["shared"], 0)

    def test_published_with_a_publisher_that_stays_roscpps(self):
        for mode in ("foreign", "foreign_pointer", "foreign_twin", "foreign_attached", "foreign_attached_pointer"):
            with self.subTest(mode):
                first, plain = self.listen(), self.listen("plain")
                talker = self.start_talker(mode, count=0, rate=50, subscribers=2, settle=0)
                self.wait_for_shared(first, 20)
                late = self.listen()
                self.wait_for_shared(late, 20)
                last = self.finish(talker)["last"]
                self.assert_got(first, range(last + 1))
                self.assert_got(plain, range(last + 1), shared=False)
                self.assert_got(late, range(late.numbers()[0], last + 1))
                self.assert_seq_as_tcpros(first)
                for listener in (first, late):
                    self.assert_moved(listener)
                for listener in (first, plain, late):
                    listener.process.stop()

    def test_a_publisher_that_stays_roscpps_ends_its_topic(self):
        for mode in ("foreign", "foreign_attached"):
            with self.subTest(mode):
                listener = self.listen()
                talker = self.start_talker(mode, count=0, rate=50, settle=0, give_up="true", linger=300)
                self.wait_for_shared(listener, 20)
                self.assertEqual(self.ros.publishers(self.name("image")), [self.name("talker")])
                talker.popen.send_signal(signal.SIGUSR1)
                self.ros.wait_until(lambda: "all published" in talker.log(), 20, "the end")
                self.ros.wait_until(lambda: self.ros.publishers(self.name("image")) == [], 20, "the topic's end")
                self.assertEqual(self.shared_transports(self.name("talker")), [])
                for process in (listener.process, talker):
                    process.stop()

    def test_a_publisher_that_stays_roscpps_leaves_its_topic_to_another(self):
        """Whether the program attaches it with each message, or did so once."""
        for mode in ("foreign_handover", "foreign_attached_handover"):
            with self.subTest(mode):
                self.ros.stop_since(self.before)
                first = self.listen()
                talker = self.start_talker(mode, count=0, half=100, rate=50, settle=0)
                self.wait_for_shared(first, 20)
                self.wait_for_number(first, 150)
                late = self.listen()
                self.wait_for_shared(late, 20)
                last = self.finish(talker)["last"]
                self.assert_got(first, range(last + 1))
                self.assert_got(late, range(late.numbers()[0], last + 1))
                for listener in (first, late):
                    self.assert_moved(listener)

    def test_a_topic_that_is_advertised_anew_is_attached_anew(self):
        listener = self.listen()
        talker = self.start_talker("foreign_again", count=0, half=100, rate=50, settle=0)
        self.ros.wait_until(lambda: sum(m["shared"] for m in listener.messages() if m["number"] < 100) >= 20, 60, "a move")
        self.ros.wait_until(lambda: sum(m["shared"] for m in listener.messages() if m["number"] >= 100) >= 20, 60, "another")
        self.finish(talker)
        self.assertTrue(all(m["right"] for m in listener.messages()))
        self.assertEqual(listener.numbers(), sorted(set(listener.numbers())))

    def test_eight_subscribers(self):
        listeners = [self.listen() for _ in range(8)]
        self.talk(count=50, subscribers=8)
        for listener in listeners:
            self.assert_got(listener, range(50), shared=True)

    def test_plain_listener_stays_on_tcpros(self):
        plain, shared = self.listen("plain"), self.listen()
        self.talk(count=50, subscribers=2, shared=1)
        self.assert_got(plain, range(50), shared=False)
        self.assert_got(shared, range(50), shared=True)
        self.assert_seq_as_tcpros(plain)

    def test_plain_talker_reaches_a_ported_listener(self):
        listener = self.listen()
        talker = self.start_talker("plain", count=30)
        talker.wait(30)
        self.assert_got(listener, range(30), shared=False)

    def test_callbacks_that_may_write_get_their_own_copy(self):
        writers = [self.listen(mode) for mode in ("value", "mutable", "event", "filter")]
        reader = self.listen("reference")
        counters = self.talk(count=30, subscribers=5)
        self.assertEqual(counters["copied_bytes"], 0)
        for writer in writers:
            self.assert_got(writer, range(30))
        self.assert_got(reader, range(30), shared=True)

    def test_an_exception_of_a_direct_callback_ends_the_process_whatever_brought_the_message(self):
        for callback, words in (("direct_throw", "as callbacks do"), ("direct_no_memory", "bad_alloc")):
            for mode in ("plain", "twin"):
                with self.subTest(callback=callback, mode=mode):
                    listener = self.listen(callback)
                    talker = self.start_talker(mode, count=0)
                    self.assertEqual(listener.process.wait(20), -signal.SIGABRT, listener.process.tail())
                    self.assertIn(words, listener.process.log())
                    talker.stop()

    def test_direct_dispatch(self):
        listener = self.listen("direct")
        self.talk(count=50)
        self.assert_got(listener, range(50), shared=True)

    def test_late_attach(self):
        listener = self.listen("late_attach")
        self.talk(count=50)
        self.assert_got(listener, range(50), shared=True)

    def test_late_joiner(self):
        talker = self.start_talker(count=0, rate=50, subscribers=0, settle=0)
        listener = self.listen()
        self.wait_for_shared(listener, 50)
        self.assert_got(listener, range(listener.numbers()[0], self.finish(talker)["last"] + 1))
        self.assert_moved(listener)

    def test_upgrade_under_traffic_loses_nothing(self):
        for _ in range(2):
            listener = self.listen(queue=5000)
            self.talk(count=1500, rate=1000, settle=0, bytes=5000, queue=5000)
            self.assert_got(listener, range(1500))
            self.assert_seq_as_tcpros(listener)
            listener.process.stop()

    def test_off_switch(self):
        listener = self.listen()
        talker = self.start_talker(count=20, shared=0, env={"TZC_DISABLE": "1"})
        talker.wait(30)
        self.assert_got(listener, range(20), shared=False)


class Death(TopicCase):
    def test_killed_publisher_and_its_successor(self):
        listener = self.listen()
        talker = self.start_talker(count=0, rate=200)
        self.wait_for(listener, 50)
        talker.kill()
        before = len(listener.numbers())
        self.talk(count=50)
        self.assertEqual(listener.numbers()[-50:], list(range(50)))
        self.assertLess(before, len(listener.numbers()))
        self.assertTrue(all(message["right"] for message in listener.messages()))

    def test_killed_subscriber_disturbs_nobody(self):
        victim, survivor = self.listen(), self.listen(answers="had")
        talker = self.start_talker(count=400, rate=200, subscribers=2, echo="had", ahead=50)
        self.wait_for(victim, 50)
        victim.process.kill()
        talker.wait(30)
        self.assert_got(survivor, range(400), shared=True)

    def test_stopped_subscriber_disturbs_nobody(self):
        sleeper, survivor = self.listen(), self.listen(answers="had")
        talker = self.start_talker(count=600, rate=200, subscribers=2, memory=4000000, queue=20, echo="had", ahead=10)
        self.wait_for(sleeper, 50)
        sleeper.process.popen.send_signal(signal.SIGSTOP)
        time.sleep(1.5)
        sleeper.process.popen.send_signal(signal.SIGCONT)
        talker.wait(30)
        self.assert_got(survivor, range(600), shared=True)
        self.wait_for_number(sleeper, 599)
        numbers = sleeper.numbers()
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(numbers[-1], 599)
        self.assertTrue(all(message["right"] for message in sleeper.messages()))


if __name__ == "__main__":
    main()
