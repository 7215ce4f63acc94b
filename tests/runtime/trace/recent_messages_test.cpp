// SPDX-License-Identifier: BSD-3-Clause
#include "trace/recent_messages.h"

#include <gtest/gtest.h>

#include <vector>

namespace tzc {
namespace trace {
namespace {

struct Recent : testing::Test {
  RecentMessages recent;
  std::vector<char> memory = std::vector<char>(2 * RecentMessages::most);
};

TEST_F(Recent, message_is_found_by_its_address_and_knows_its_first_callback) {
  recent.remember(&memory[0], 7);
  EXPECT_EQ(recent.find(&memory[0]).message, 7U);
  EXPECT_FALSE(recent.find(&memory[0]).is_first_call);
  recent.remember(&memory[0], 8);  // the memory was reused
  EXPECT_EQ(recent.find(&memory[0]).message, 8U);
  recent.remember(&memory[0], 9);
  EXPECT_TRUE(recent.find(&memory[0]).is_first_call);
}

TEST_F(Recent, memory_that_another_message_took_leads_to_no_old_one) {
  recent.remember(&memory[0], 7);
  recent.remember(&memory[0], 0);
  EXPECT_EQ(recent.find(&memory[0]).message, 0U);
}

TEST_F(Recent, message_that_is_taken_is_forgotten) {
  recent.remember(&memory[0], 7);
  EXPECT_EQ(recent.take(&memory[0]), 7U);
  EXPECT_EQ(recent.take(&memory[0]), 0U);
}

TEST_F(Recent, messages_are_a_bounded_number) {
  for (std::size_t i = 0; i < memory.size(); ++i) recent.remember(&memory[i], i + 1);
  EXPECT_EQ(recent.find(&memory[0]).message, 0U);
  EXPECT_EQ(recent.find(&memory.back()).message, memory.size());
  EXPECT_EQ(recent.find(nullptr).message, 0U);
}

}  // namespace
}  // namespace trace
}  // namespace tzc
