# SPDX-License-Identifier: BSD-3-Clause
"""The races of the move between TCPROS and shared memory, each held at the turn that once went wrong."""
from topic_case import Listener, TopicCase, main


class Races(TopicCase):
    def race(self, race, program="racer", **parameters):
        """A publisher that holds its threads (nodes/racer.cpp, mover.cpp) and comes to its end; what it says happened."""
        racer = self.node(program, program, dict(parameters, race=race))
        self.assertEqual(racer.wait(60), 0, racer.tail())
        return self.events(Listener(racer))

    @staticmethod
    def events(racer):
        return {line["event"]: line["happened"] for line in racer.lines() if "event" in line}

    def test_a_message_by_reference_is_not_overtaken_at_the_move(self):
        listener = self.listen()
        events = self.race("by_reference")
        self.assertEqual(events, {"moved in between": False, "parked": True})
        self.assert_got(listener, range(10))
        self.assertEqual([m["shared"] for m in listener.messages()], [False] + 9 * [True])
        self.assert_seq_as_tcpros(listener)

    def test_more_messages_than_the_queue_holds_wait_for_the_move(self):
        """TCPROS had room for them in its sockets. The channel gets them as the subscriber takes them."""
        listener = self.listen()
        self.race("by_reference", queue=2)
        self.assert_got(listener, range(10))
        self.assertEqual([m["shared"] for m in listener.messages()], [False] + 9 * [True])

    def test_a_move_that_took_long_ends_while_the_publisher_publishes_on(self):
        listener = self.listen()
        self.assertEqual(self.race("long_move", "mover"), {"live": True})
        numbers = listener.numbers()
        self.assertGreater(len(numbers), 20)
        self.assertEqual(numbers, list(range(len(numbers))))

    def test_a_message_by_pointer_is_copied_before_a_callback_of_its_process_writes_to_it(self):
        listener = self.listen()
        self.assertEqual(self.race("local_writer", "mover"), {"written before it was copied": False, "written": True})
        self.assert_got(listener, range(1), shared=True)

    def test_a_connect_callback_that_runs_after_the_move_is_not_overtaken(self):
        listener = self.listen()
        self.assertEqual(self.race("late_greeting", "mover"), {"live": True})
        self.assert_got(listener, range(10))

    def test_an_offer_that_comes_before_the_tcpros_header(self):
        listener = self.listen()
        self.assertEqual(self.race("late_header"), {"connecting": True, "parked": True})
        self.assert_got(listener, range(10), shared=True)
        self.assert_seq_as_tcpros(listener)

    def test_a_shared_message_waits_for_the_handing_over_of_the_last_tcpros_one(self):
        reader = Listener(self.node("racer", "reader", {"race": "slow_reader"}))
        self.race("by_reference")
        self.assert_got(reader, range(10))
        self.assertEqual([m["shared"] for m in reader.messages()], [False] + 9 * [True])
        self.assertEqual(self.events(reader), {"waited": True, "went on at once": False})

    def test_back_on_tcpros_with_a_full_queue_nothing_comes_twice(self):
        shared, plain = self.listen(queue=1000), self.listen("plain", queue=1000)
        self.assertEqual(self.race("busy_queue"), {"returned": True})
        for listener in (shared, plain):
            self.assert_got(listener, range(330))
            self.assert_seq_as_tcpros(listener)
        self.assertGreater(sum(m["shared"] for m in shared.messages()), 100)
        self.assertFalse(any(m["shared"] for m in shared.messages()[-20:]))

    def test_back_on_tcpros_messages_that_were_left_to_their_bytes_come(self):
        listener = self.listen()
        self.assertEqual(self.race("left_to_bytes"), {"returned": True})
        self.assert_got(listener, range(5))

    def test_back_on_tcpros_that_cannot_send_the_queue_decides_what_is_lost(self):
        """TCPROS sends nothing for as long as the subscriber waits to be moved back."""
        shared = self.listen(queue=1000)
        self.listen("plain")
        self.assertEqual(self.race("busy_queue", queue=1), {"returned": True})
        self.wait_for_number(shared, 329)
        numbers = shared.numbers()
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertGreater(len(numbers), 100)
        self.assertLess(len(numbers), 330)

    def test_a_subscriber_that_does_not_answer_the_offer_in_time(self):
        listener = self.listen()
        self.assertEqual(self.race("silent", pid=listener.process.pid), {"unanswered": True, "parked": True})
        self.assert_got(listener, range(10), shared=True)

    def test_two_publishers_at_once_on_a_direct_subscriber(self):
        """Callbacks don't run at the same time, and the message that had to wait needs no other one to come."""
        subscriber = Listener(self.node("racer", "subscriber", {"race": "two_at_once"}))
        talkers = [self.start_talker(name=f"talker_{i}", count=1, subscribers=1) for i in range(2)]
        for talker in talkers:
            self.assertEqual(talker.wait(60), 0, talker.tail())
        self.wait_for(subscriber, 2)
        self.assertEqual(subscriber.numbers(), [0, 0])
        self.assertTrue(all(message["right"] and message["shared"] for message in subscriber.messages()))
        self.assertEqual(self.events(subscriber), {"second came meanwhile": True})

    def test_a_direct_callback_waits_for_that_of_the_last_tcpros_message(self):
        """That one runs on another thread."""
        subscriber = Listener(self.node("racer", "subscriber", {"race": "two_at_once"}))
        self.race("by_reference")
        self.assert_got(subscriber, range(10))
        self.assertEqual([m["shared"] for m in subscriber.messages()], [False] + 9 * [True])
        self.assertEqual(self.events(subscriber), {"second came meanwhile": True})

    def test_who_unsubscribes_waits_for_a_callback_that_was_in_no_queue(self):
        subscriber = Listener(self.node("racer", "subscriber", {"race": "unsubscribe"}))
        self.start_talker(count=0, rate=20, subscribers=1)
        self.assertEqual(subscriber.process.wait(60), 0, subscriber.process.tail())
        self.assertEqual(self.events(subscriber), {"ended before": True})
        self.assertEqual([message["shared"] for message in subscriber.messages()], [True])

    def test_exit_waits_for_a_message_that_is_being_taken(self):
        """Its queue, the program's or roscpp's, is destroyed by exit()."""
        self.start_talker(count=0, rate=20)
        self.assertEqual(self.race("exit"), {"taking": True, "used when dead": False})

    def assert_concurrent_ends(self, talker, shared):
        subscriber = Listener(self.node("racer", "subscriber", {"race": "concurrent"}))
        self.start_talker(talker, count=0, rate=20, subscribers=1)
        self.assertEqual(subscriber.process.wait(60), 0, subscriber.process.tail())
        self.assertEqual(self.events(subscriber), {"ended before": False, "ended afterwards": True})
        self.assertEqual([message["shared"] for message in subscriber.messages()], [shared])

    def test_who_unsubscribes_waits_for_a_direct_callback_that_may_run_beside_others(self):
        self.assert_concurrent_ends("twin", True)

    def test_and_so_it_does_over_tcpros(self):
        self.assert_concurrent_ends("plain", False)

    def test_a_guest_without_memory_for_a_message_goes_on(self):
        subscriber = Listener(self.node("racer", "subscriber", {"race": "no_memory"}))
        self.start_talker(count=0, rate=20, subscribers=1)
        self.wait_for(subscriber, 5)
        self.assertTrue(subscriber.process.alive())
        self.assertTrue(all(message["right"] for message in subscriber.messages()))
        self.assertIn("goes back to TCPROS: out of memory", subscriber.process.log())


if __name__ == "__main__":
    main()
