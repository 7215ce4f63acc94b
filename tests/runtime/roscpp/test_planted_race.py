# SPDX-License-Identifier: BSD-3-Clause
"""A data race for ThreadSanitizer to find, between the transport's reader thread and the node's own."""
from topic_case import Listener, TopicCase, main


class Planted(TopicCase):
    def test_planted(self):
        racer = Listener(self.node("racer", "racer", {"race": "planted"}))
        self.talk(count=20)
        self.assert_got(racer, range(20), shared=True)


if __name__ == "__main__":
    main()
