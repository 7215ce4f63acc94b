# SPDX-License-Identifier: BSD-3-Clause
"""A publisher of a library that advertises several topics by itself, as laser_proc's."""
from topic_case import Listener, TopicCase, main


class Scanner(TopicCase):
    def test_each_topic_that_it_tells_is_attached(self):
        for pointer in ("false", "true"):
            with self.subTest(pointer=pointer):
                self.ros.stop_since(self.before)
                listener = Listener(self.node("scanner", "scans", {"role": "listener"}))
                self.wait_for_subscribers(self.name("first"), 1)
                scanner = self.node("scanner", "scanner", {"pointer": pointer})
                self.assertEqual(scanner.wait(30), 0, scanner.tail())
                self.assert_got(listener, range(20), shared=True, topic="first")
                self.assert_got(listener, range(20), topic="echoes")


if __name__ == "__main__":
    main()
