// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tzc/detail/find_publisher.h>

#include <array>
#include <deque>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace tzc {
namespace {

TEST(FindPublisher, finds_what_the_map_holds) {
  const std::map<std::string, int> ordered{{"left", 1}, {"right", 2}};
  const std::unordered_map<int, std::string> hashed{{7, "seven"}};
  EXPECT_EQ(2, find_publisher(ordered, "right"));
  EXPECT_EQ("seven", find_publisher(hashed, 7));
  EXPECT_EQ(&ordered.at("left"), &find_publisher(ordered, "left")) << "the publisher itself, not a copy";
}

TEST(FindPublisher, adds_nothing_to_the_map) {
  std::map<std::string, int> publishers{{"left", 1}};
  EXPECT_EQ(0, find_publisher(publishers, "right"));
  EXPECT_EQ(1u, publishers.size());
}

template <class Sequence>
void find_in(const Sequence& sequence, int first, int last) {
  EXPECT_EQ(first, find_publisher(sequence, 0));
  EXPECT_EQ(last, find_publisher(sequence, 2u));
  EXPECT_EQ(&sequence[1], &find_publisher(sequence, 1L)) << "the publisher itself, not a copy";
  EXPECT_EQ(0, find_publisher(sequence, 3));
  EXPECT_EQ(0, find_publisher(sequence, -1));
}

TEST(FindPublisher, finds_what_a_sequence_holds_and_nothing_outside_of_it) {
  const int array[] = {7, 8, 9};
  find_in(array, 7, 9);
  find_in(std::vector<int>{7, 8, 9}, 7, 9);
  find_in(std::deque<int>{7, 8, 9}, 7, 9);
  find_in(std::array<int, 3>{{7, 8, 9}}, 7, 9);
}

TEST(FindPublisher, an_empty_sequence_has_no_last_element) {
  const std::vector<int> none;
  EXPECT_EQ(0, find_publisher(none, none.size() - 1));
}

TEST(FindPublisher, a_map_with_numbers_as_keys_is_no_sequence) {
  const std::map<std::size_t, int> sparse{{100, 1}};
  EXPECT_EQ(1, find_publisher(sparse, 100));
  EXPECT_EQ(0, find_publisher(sparse, 0));
}

}  // namespace
}  // namespace tzc
