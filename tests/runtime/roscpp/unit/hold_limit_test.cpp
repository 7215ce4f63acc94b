// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/hold_limit.h"

#include <gtest/gtest.h>

#include <vector>

namespace tzc {
namespace detail {
namespace {

class FakeMessage : public channel::Message {
 public:
  explicit FakeMessage(std::size_t bytes) { blocks_.push_back(ConstBlock{nullptr, bytes}); }
};

channel::MessagePtr message(std::size_t bytes) {
  return std::make_shared<FakeMessage>(bytes);
}

TEST(HoldLimit, a_few_messages_of_any_size_are_allowed) {
  HoldLimit limit;
  limit.set_most_bytes(10);
  std::vector<std::shared_ptr<const void>> held;
  for (std::size_t i = 0; i < HoldLimit::kFewMessages; ++i) {
    ASSERT_TRUE(limit.allows(*message(1000)));
    held.push_back(limit.hold(message(1000)));
  }
  EXPECT_FALSE(limit.allows(*message(1)));
}

TEST(HoldLimit, more_than_that_up_to_the_limit) {
  HoldLimit limit;
  limit.set_most_bytes(3000);
  std::vector<std::shared_ptr<const void>> held;
  while (limit.allows(*message(100))) held.push_back(limit.hold(message(100)));
  EXPECT_EQ(held.size(), 30u);
  EXPECT_EQ(limit.held_bytes(), 3000u);
  held.pop_back();
  EXPECT_TRUE(limit.allows(*message(100)));
  EXPECT_FALSE(limit.allows(*message(101)));
}

TEST(HoldLimit, what_is_held_keeps_the_message_and_may_outlive_the_limit) {
  std::shared_ptr<const void> held;
  std::weak_ptr<const channel::Message> watched;
  {
    HoldLimit limit;
    const channel::MessagePtr one = message(100);
    watched = one;
    held = limit.hold(one);
    EXPECT_EQ(limit.held_messages(), 1u);
  }
  EXPECT_FALSE(watched.expired());
  held.reset();
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace detail
}  // namespace tzc
