// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tzc/detail/find_publisher.h>

#include <map>
#include <string>
#include <unordered_map>

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

}  // namespace
}  // namespace tzc
