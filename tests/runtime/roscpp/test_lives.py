# SPDX-License-Identifier: BSD-3-Clause
"""What outlives what: callbacks their objects, nodes their end, messages their events."""
from topic_case import Listener, TopicCase, main


class Lives(TopicCase):
    def events_of(self, node, timeout=90):
        self.assertEqual(node.wait(timeout), 0, node.tail())
        return {line["event"]: line["happened"] for line in Listener(node).lines()}


class Endings(Lives):
    """With roscpp, no callback runs once the node has shut down and the subscriber is destroyed."""
    EXPECTED = {"called": True, "called too late": False, "called afterwards": False}

    def test_a_direct_callback_ends_with_its_subscriber_while_the_node_shuts_down(self):
        ending = self.node("ending", "ending", {})
        self.start_talker(count=0, rate=50)
        self.assertEqual(self.events_of(ending), self.EXPECTED)

    def test_and_so_does_one_that_may_run_beside_others(self):
        ending = self.node("ending", "ending", {"concurrent": True})
        self.start_talker(count=0, rate=50)
        self.assertEqual(self.events_of(ending), self.EXPECTED)

    def test_and_so_do_messages_of_the_same_process_that_wait(self):
        self.assertEqual(self.events_of(self.node("ending", "ending", {"local": True})), self.EXPECTED)


class Renewed(Lives):
    def test_what_has_ended_does_not_wait_for_what_takes_its_place(self):
        self.assertEqual(self.events_of(self.node("renewer", "renewer", {})), {"renewed": True})


class GivenUp(Lives):
    def test_what_a_library_gives_up_is_no_longer_advertised(self):
        """A copy of its publisher, to which shared memory is attached, goes on living."""
        events = self.events_of(self.node("given_up", "given_up", {}))
        self.assertEqual(events, {f"/{topic} {when}": when == "before" for topic in ("plain", "image", "camera")
                                  for when in ("before", "after")})


class StartedAgain(Lives):
    def test_a_node_that_is_started_again_shares_memory(self):
        self.start_talker(count=0, rate=30, subscribers=0)
        self.assertEqual(self.events_of(self.node("again", "again", {})), {"second life": True, "third life": True})


class Comparisons(Lives):
    def test_a_publisher_is_another_one_than_a_stock_publisher(self):
        """Both convert to what says whether they are valid, which is the same for all that are."""
        self.assertEqual(self.events_of(self.node("compared", "compared", {})), {"publishers are mixed up": False})


class Events(Lives):
    def test_a_writer_behind_an_event_gets_a_message_of_its_own(self):
        writer = self.node("event_writer", "writer", {})
        reader = self.listen()
        self.talk(count=10, subscribers=2)
        self.assert_got(reader, range(10), shared=True)
        self.ros.wait_until(lambda: '"filtered"' in writer.log(), 30, "the writer behind a filter")
        self.talk(count=10, name="other", remaps=["image:=other"])
        self.assertEqual(self.events_of(writer), {"filtered": True, "converted": True})


if __name__ == "__main__":
    main()
