# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/demo takes for equal recordings; a letter stands for a message's content."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts/lib"))
from compare_bags import difference  # noqa: E402


class Difference(unittest.TestCase):
    def assert_equal(self, first, second):
        self.assertIsNone(difference(list(first), list(second)))

    def assert_different(self, first, second, why):
        self.assertRegex(difference(list(first), list(second)) or "equal", why)

    def test_the_same_messages(self):
        self.assert_equal("abcde", "abcde")
        self.assert_equal("xxxx", "xxxx")
        self.assert_equal("xxxx", "xx")

    def test_one_began_earlier_ended_later_or_lost_some(self):
        self.assert_equal("abcdef", "cdefgh")
        self.assert_equal("cdefgh", "abcdef")
        self.assert_equal("abcdef", "abdef")

    def test_changed_content_is_seen_wherever_it_is(self):
        for changed in ("Abcdef", "abCdef", "abcdeF", "aBCDEF", "ABCDEf", "aBcDeF"):
            self.assert_different("abcdef", changed, "^different content: message ")
        self.assert_different("abcdef", "ABCDEF", "^no message of one bag is in the other")
        self.assert_different("abcdef", "cdEfgh", "message 5 of the first bag, 3 of the second")

    def test_a_source_that_repeats_itself_loses_nothing(self):
        self.assert_different("xxxx", "xxxy", "repeats itself")
        self.assert_different("xxxx", "xxxxxy", "repeats itself")

    def test_order(self):
        self.assert_different("abcdef", "abdcef", "order")


if __name__ == "__main__":
    unittest.main()
