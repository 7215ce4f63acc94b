# SPDX-License-Identifier: BSD-3-Clause
"""Latched topics, connect callbacks, numbers of subscribers, header.seq, topic statistics: as with plain roscpp."""
import re
import signal
import time

from topic_case import TZC_RUN, Listener, TopicCase, main


class Latch(TopicCase):
    def test_late_subscribers_get_the_last_message(self):
        talker = self.start_talker(latch=True, count=5, rate=50, subscribers=0, settle=0, linger=300)
        self.assertEqual(self.last_published(talker), 4)
        shared, plain = self.listen(), self.listen("plain")
        self.assert_got(plain, [4], shared=False)
        self.assert_got(shared, [4])
        self.ros.wait_until(lambda: "TZC" in self.transports(self.name("talker")), 60, "the move of one")
        later = self.listen()  # now that others are on shared memory
        self.assert_got(later, [4])
        self.assertTrue(talker.alive())

    def test_latched_and_flowing(self):
        """Who is there gets all, who comes late starts with the last one, and gets no later one twice.

        That first one may come twice with plain roscpp, too: Publication::addSubscriberLink adds the link, which what
        is published then finds, and only afterwards sends it the last message."""
        early = self.listen()
        talker = self.start_talker(latch=True, count=0, rate=100, linger=300)
        self.wait_for(early, 50)
        late, plain = self.listen(), self.listen("plain")
        self.ros.wait_until(lambda: any(m["shared"] for m in late.messages()), 60, "the move")
        self.wait_for(plain, 2)
        talker.popen.send_signal(signal.SIGUSR1)
        end = self.last_published(talker) + 1
        self.assert_got(early, range(end), shared=True)
        for listener in (late, plain):
            first, second = listener.numbers()[:2]
            self.assert_got(listener, [first] * (first == second) + list(range(first, end)))
        self.assert_moved(late)
        self.assertFalse(any(m["shared"] for m in plain.messages()))
        last = self.listen()
        self.assert_got(last, [end - 1])
        self.assert_seq_as_tcpros(early)
        talker.stop()

    def test_a_callback_that_joins_a_process_later(self):
        process = self.node("several", "several", {"callbacks": "pointer late_shape_shifter"})
        self.wait_for_subscribers(self.name("image"), 1)
        talker = self.start_talker(latch=True, count=1, settle=0, linger=300)
        listener = Listener(process)
        self.assert_got(listener, [0], callback="pointer")
        self.assert_got(listener, [0], callback="shape_shifter")
        talker.stop()


class Connections(TopicCase):
    def events_of(self, runner=(), **parameters):
        """What a publisher's callbacks hear when two subscribers come, one leaves and the other is killed."""
        greeter = self.node("greeter", f"greeter{len(parameters)}", parameters, [f"image:=of{len(parameters)}"],
                            runner=runner)
        topic = f"of{len(parameters)}"
        events = lambda: [line for line in Listener(greeter).lines() if "event" in line]  # noqa: E731
        arrivals = []
        for name, mode in (("first", "pointer"), ("second", "pointer"), ("third", "plain")):
            arrivals.append(self.listen(mode, name + topic, [f"image:={topic}"], topic=topic, queue=1000))
            self.ros.wait_until(lambda: len(events()) == len(arrivals), 10, f"the arrival of {name}")
        if "plain" not in parameters:
            self.ros.wait_until(lambda: self.connections(self.name(f"greeter{len(parameters)}")).count(
                ("TZC", self.name(topic))) == 2, 60, "both to be on shared memory")
        for count, (listener, end) in enumerate(zip(arrivals, ("stop", "kill", "stop"))):
            getattr(listener.process, end)()
            self.ros.wait_until(lambda: len(events()) == 4 + count, 10, "a leave")
        time.sleep(0.3)
        seen = [(line["event"], line["subscriber"].replace(topic, ""), line["count"]) for line in events()]
        return seen, [listener.messages() for listener in arrivals]

    def test_connect_callbacks_as_with_plain_roscpp(self):
        plain, _ = self.events_of(plain=1)
        shared, _ = self.events_of()
        self.assertEqual(shared, plain)
        flowing, _ = self.events_of(rate=100, before=3)
        self.assertEqual(flowing, plain)
        foreign, _ = self.events_of(rate=100, before=3, foreign=1, bytes=50000)
        self.assertEqual(foreign, plain)
        image_transports, _ = self.events_of(rate=100, before=3, image_transport=1, bytes=50000, latch=False)
        self.assertEqual(image_transports, plain)

    def test_greetings_for_one_subscriber_alone(self):
        for parameters in ({}, {"rate": 200, "before": 3}, {"rate": 200, "before": 3, "foreign": 1},
                           {"rate": 200, "before": 3, "image_transport": 1, "latch": False}):
            _, messages = self.events_of(**parameters)
            self.assert_greeted_each(messages)

    def test_greetings_of_a_ported_node_under_tzc_run(self):
        """TZC stands before its callback twice."""
        for parameters in ({"rate": 200, "before": 3}, {"rate": 200, "before": 3, "foreign": 1}):
            _, messages = self.events_of(runner=TZC_RUN, **parameters)
            self.assert_greeted_each(messages)

    def assert_greeted_each(self, messages):
        for index, mine in enumerate(messages):
            self.assertTrue(all(m["right"] for m in mine))
            greetings = [m["number"] for m in mine if m["number"] >= 1000000]
            self.assertEqual(greetings, [1000000 + index])
            rest = [m["number"] for m in mine if m["number"] < 1000000]
            self.assertEqual(rest, list(range(rest[0], rest[0] + len(rest))) if rest else [], mine[:20])


class Numbering(TopicCase):
    def test_seq_as_tcpros(self):
        shared, plain = self.listen(queue=1000), self.listen("plain", queue=1000)
        self.talk(count=300, rate=500, settle=0, queue=1000, subscribers=2)
        for listener in (shared, plain):
            self.assert_got(listener, range(300))
            self.assert_seq_as_tcpros(listener)


class Order(TopicCase):
    def test_what_roscpp_queues_is_not_overtaken(self):
        """Every other message goes through shared memory."""
        listeners = [self.listen(queue=1000), self.listen("plain", name="plain", queue=1000)]
        self.talk("mixed", count=300, rate=2000, queue=1000, subscribers=2, shared=1)
        for listener in listeners:
            self.assert_got(listener, range(300))
            self.assert_seq_as_tcpros(listener)


class NumbersInOneProcess(TopicCase):
    """header.seq of images that a callback of the publisher's own process reads, and of those that go out beside them."""
    tries = 0

    def numbers_of(self, others, **parameters):
        """What the own callback and the other listeners got, as [seq, ...] each."""
        NumbersInOneProcess.tries += 1
        topic = f"image{self.tries}"
        remaps = (f"image:={topic}",)
        listeners = [self.listen(mode, name=f"{mode}{self.tries}", topic=topic, remaps=remaps, queue=1000) for mode in others]
        node = self.node("own_reader", f"own{self.tries}", dict(parameters, subscribers=1 + len(others)), remaps)
        self.assertEqual(node.wait(30), 0, node.tail())
        own = Listener(node)
        for listener in (own, *listeners):
            self.assert_got(listener, range(50))
        return [[message["seq"] for message in listener.messages()] for listener in (own, *listeners)]

    def assert_as_plain(self, others=(), **parameters):
        plain = self.numbers_of(others, **parameters)
        ported = self.numbers_of(others, ported=True, shared=others.count("pointer"), **parameters)
        self.assertEqual(ported, plain)
        return plain

    def test_by_reference_roscpp_numbers_for_its_own_process_too(self):
        self.assertEqual(self.assert_as_plain(), [list(range(50))])
        self.assert_as_plain(writer=True)

    def test_by_reference_beside_other_processes(self):
        for others in (("plain",), ("pointer",), ("plain", "pointer")):
            self.assertEqual(self.assert_as_plain(others), [list(range(50))] * (1 + len(others)), others)

    def test_by_pointer_the_own_process_gets_what_the_program_wrote(self):
        own, other = self.assert_as_plain(("pointer",), pointer=True)
        self.assertEqual((own[0], other), (7000000, list(range(50))))

    def test_image_transport(self):
        self.assertEqual(self.assert_as_plain(library="image_transport"), [list(range(50))])
        self.assert_as_plain(("plain", "pointer"), library="image_transport")
        self.assert_as_plain(library="image_transport", pointer=True)


class Statistics(TopicCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(self.ros.run, ["rosparam", "delete", "/enable_statistics"])
        self.assertEqual(self.ros.run(["rosparam", "set", "/enable_statistics", "true"])[0], 0)

    def statistics_of(self, mode, shared):
        """What a listener's node tells after a second or so; every message has arrived."""
        echo = self.ros.start(["rostopic", "echo", "-n", "1", "/statistics"], name="echo")
        listener = self.listen(mode, name=mode)
        talker = self.start_talker(count=0, rate=100, bytes=50000, shared=shared)
        self.assertEqual(echo.wait(30), 0)
        self.assert_got(listener, range(self.finish(talker)["last"] + 1), shared=bool(shared))
        told = re.findall(r"^(\w+): *(\S*)(?: *\n +secs: *(\d+)\n +nsecs: *(\d+))?", echo.log(), re.M)
        self.ros.stop_since(self.before)
        return {name: value or float(f"{seconds}.{int(nanoseconds):09}") for name, value, seconds, nanoseconds in told
                if name.islower() and (value or seconds)}

    def test_topic_statistics_are_published(self):
        plain, shared, direct = [self.statistics_of(mode, mode != "plain") for mode in ("plain", "pointer", "direct")]
        self.assertEqual(set(shared), set(plain))
        for told, mode in ((plain, "plain"), (shared, "pointer"), (direct, "direct")):
            self.assertEqual([told[what] for what in ("topic", "node_pub", "node_sub", "dropped_msgs")],
                             [f'"{self.name("image")}"', f'"{self.name("talker")}"', f'"{self.name(mode)}"', "0"])
            delivered = int(told["delivered_msgs"])
            self.assertAlmostEqual((told["window_stop"] - told["window_start"]) / told["period_mean"], delivered,
                                   delta=2 + 0.05 * delivered)
            self.assertTrue(0 < told["stamp_age_mean"] <= told["stamp_age_max"] < 1 * self.slowness())
            least = 50000 if told is plain else 40  # bytes of a message: all of it, or its control part
            self.assertTrue(least * delivered < int(told["traffic"]) < (least + 200) * (delivered + 1), told)


if __name__ == "__main__":
    main()
