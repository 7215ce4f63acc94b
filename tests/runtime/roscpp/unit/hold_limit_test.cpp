// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/hold_limit.h"

#include <gtest/gtest.h>

#include <vector>

namespace tzc {
namespace detail {
namespace {

TEST(HoldLimit, a_few_messages_of_any_size_are_allowed) {
  HoldLimit limit;
  limit.set_most_bytes(10);
  std::vector<std::shared_ptr<const void>> held;
  for (std::size_t i = 0; i < HoldLimit::kFewMessages; ++i) {
    ASSERT_TRUE(limit.allows(1000));
    held.push_back(limit.hold(1000, nullptr));
  }
  EXPECT_FALSE(limit.allows(1));
}

TEST(HoldLimit, more_than_that_up_to_the_limit) {
  HoldLimit limit;
  limit.set_most_bytes(3000);
  std::vector<std::shared_ptr<const void>> held;
  while (limit.allows(100)) held.push_back(limit.hold(100, nullptr));
  EXPECT_EQ(held.size(), 30u);
  EXPECT_EQ(limit.held_bytes(), 3000u);
  held.pop_back();
  EXPECT_TRUE(limit.allows(100));
  EXPECT_FALSE(limit.allows(101));
}

TEST(HoldLimit, what_is_held_keeps_the_message_and_may_outlive_the_limit) {
  std::shared_ptr<const void> held;
  std::weak_ptr<const int> watched;
  {
    HoldLimit limit;
    const auto message = std::make_shared<const int>(1);
    watched = message;
    held = limit.hold(100, message);
    EXPECT_EQ(limit.held_messages(), 1u);
  }
  EXPECT_FALSE(watched.expired());
  held.reset();
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace detail
}  // namespace tzc
