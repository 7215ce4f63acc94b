# SPDX-License-Identifier: BSD-3-Clause
"""Subscribers that write to what they receive, ported and under tzc-run: they work, and no other node sees it."""
import signal

from topic_case import TZC_RUN, Listener, TopicCase, main

WARNING = "this node writes to messages"


class PrivateWrites(TopicCase):
    def draw(self, mode="draw", **how):
        return self.listen(mode, name="draws", **how)

    def assert_draws(self, bytes, drawer, warns=1, talker="twin"):
        """Each message comes whole although the one before in its block was drawn on; so it does at a node that looks on,
        and what was drawn is published."""
        looks_on = self.listen(name="looks_on")
        echo = self.listen("plain", name="echo", topic="drawn", remaps=["image:=drawn"])
        self.ros.wait_until(lambda: self.transports(self.name("draws"), "drawn"), 20, "a subscriber of what is drawn")
        self.talk(talker, count=60, rate=100, bytes=bytes, subscribers=2, shared=2)
        self.assert_got(drawer, range(60))
        self.assert_got(looks_on, range(60))
        self.assert_got(echo, range(1000, 1060))
        if warns:
            self.ros.wait_until(lambda: WARNING in drawer.process.log(), 10, "the warning")
        self.assertEqual(drawer.process.log().count(WARNING), warns, drawer.process.tail())
        self.assertTrue(drawer.process.alive())

    def test_of_a_ported_subscriber(self):
        self.assert_draws(100000, self.draw())

    def test_to_payloads_below_a_page(self):
        """They are copied: there is nothing to warn of."""
        self.assert_draws(1000, self.draw(), warns=0)

    def test_under_tzc_run(self):
        self.assert_draws(100000, self.draw("plain_draw", runner=TZC_RUN))

    def test_to_payloads_below_a_page_under_tzc_run(self):
        self.assert_draws(1000, self.draw("plain_draw", runner=TZC_RUN), warns=0)

    def test_on_threads_that_block_all_signals(self):
        """As roscpp's spinners do on the threads that they make."""
        self.assert_draws(100000, self.draw(spinner="async"))

    def test_on_a_thread_that_a_callback_started_before_anything_was_shared(self):
        """It inherits the signals that the callback's thread blocks."""
        pool = self.node("pool", "pool", {"count": 60})
        self.start_talker(count=0, rate=50, bytes=100000)
        self.assertEqual(pool.wait(90), 0, pool.tail())
        self.assertEqual(Listener(pool).lines(), [{"event": "drawn", "happened": True}])

    def test_on_threads_of_a_spinner_that_waits(self):
        self.assert_draws(100000, self.draw(spinner="multi"))

    def test_on_threads_that_serve_a_queue_of_the_programs_own(self):
        self.assert_draws(100000, self.draw(spinner="own_async"))

    def test_on_threads_that_block_all_signals_under_tzc_run(self):
        self.assert_draws(100000, self.draw("plain_draw", runner=TZC_RUN, spinner="async"))

    def test_of_a_direct_callback(self):
        self.assert_draws(100000, self.draw("direct_draw"))

    def test_after_a_handler_was_installed(self):
        """Also to messages that were taken before that."""
        self.assert_draws(100000, self.draw(handler=30))

    def test_after_a_handler_was_installed_under_tzc_run(self):
        self.assert_draws(100000, self.draw("plain_draw", runner=TZC_RUN, handler=30))

    def test_several_callbacks_of_one_subscription_share_the_message(self):
        """As roscpp alone: what the first one wrote the second one sees."""
        listener = self.node("listener", "twice", {"mode": "draw", "times": 2})
        self.wait_for_subscribers(self.name("image"), 1)
        self.talk(count=20)
        self.assert_got(Listener(listener), [n for i in range(20) for n in (i, i + 1000)])

    def test_a_later_callback_gets_a_latched_message_as_it_was_sent(self):
        drawer = self.draw(again=3)
        self.start_talker(latch=True, count=1, linger=300)
        self.assert_got(drawer, [0, 0])
        self.assertEqual([message["shared"] for message in drawer.messages()], [True, False])

    def assert_draws_beside_the_publisher(self, shared=True, **how):
        """Each message comes whole to a node that looks on, and to the drawing callback, and stays whole in the publisher."""
        looks_on = self.listen(name="looks_on")
        echo = self.listen("plain", name="echo", topic="drawn", remaps=["image:=drawn"])
        drawer = Listener(self.node("drawer", "drawer", how))
        drawer.process.wait(60)
        self.assert_got(looks_on, range(30), shared=shared)
        self.assert_got(echo, range(1000, 1030))
        self.assert_got(drawer, range(30))
        self.assertEqual([line for line in drawer.lines() if "event" in line], [{"event": "kept", "happened": True}])

    def test_in_the_publishers_own_process(self):
        self.assert_draws_beside_the_publisher()

    def test_in_the_publishers_own_process_to_payloads_below_a_page(self):
        self.assert_draws_beside_the_publisher(shared=False, bytes=1000)  # a subscriber copies them

    def test_in_the_publishers_own_process_to_what_is_latched(self):
        self.assert_draws_beside_the_publisher(latch=True)

    def assert_turned_off(self, **how):
        drawer = self.draw(**how)
        self.start_talker(count=20)
        self.assertEqual(drawer.process.wait(30), -signal.SIGSEGV)

    def test_can_be_turned_off(self):
        self.assert_turned_off(env={"TZC_PRIVATE_WRITES": "0"})

    def test_can_be_turned_off_by_parameter(self):
        self.assert_turned_off(**{"tzc/private_writes": "false"})

    def test_can_be_turned_off_under_tzc_run(self):
        self.assert_turned_off(mode="plain_draw", runner=TZC_RUN, env={"TZC_PRIVATE_WRITES": "off"})


class Joined(TopicCase):
    """A callback of something else draws on a shared image, on a thread that blocks all signals and has never run a callback of the
    image's topic."""

    def assert_joined(self, runner=(), late=False, **how):
        joiner = Listener(self.node("joiner", "joins", dict(how, role="joins", late=late), runner=runner))
        self.wait_for_subscribers(self.name("image"), 1)
        if not late:
            self.wait_for_subscribers(self.name("temperature"), 1)
        talker = self.node("joiner", "talks", {"role": "talks", "late": late})
        self.assertEqual(talker.wait(60), 0, talker.tail())
        self.assert_got(joiner, range(20), shared=True)
        self.assertTrue(joiner.process.alive(), joiner.process.tail())

    def test_with_what_has_a_queue_of_its_own(self):
        self.assert_joined(queues="other")

    def test_with_what_is_in_the_global_queue(self):
        self.assert_joined(queues="image")

    def test_in_one_queue_that_several_threads_call(self):
        self.assert_joined(queues="one")

    def test_with_what_is_subscribed_to_later(self):
        self.assert_joined(queues="other", late=True)

    def test_by_a_timer_of_the_global_queue(self):
        self.assert_joined(queues="image", draws="timer")

    def test_by_hand_under_tzc_run(self):
        self.assert_joined(queues="other", draws="callback", plain=True, runner=TZC_RUN)


if __name__ == "__main__":
    main()
