// SPDX-License-Identifier: BSD-3-Clause
// Where a function may run code that no expression names. What C++17 has is among the golden cases.
#include <gtest/gtest.h>

#include <algorithm>

#include "facts/facts_of.h"

namespace tzc::rewriter::test {
namespace {

/// Whether a pointer into a message lives across code that is not known in a coroutine that does this in between.
bool runs_unknown_code(const std::string& between) {
  const Facts facts = facts_of(R"(
#include <coroutine>
struct Own {
  bool await_ready() { return false; }
  void await_suspend(std::coroutine_handle<>) {}
  void await_resume() {}
};
struct Task {
  struct promise_type {
    Task get_return_object() { return {}; }
    std::suspend_never initial_suspend() noexcept { return {}; }
    std::suspend_never final_suspend() noexcept { return {}; }
    Own yield_value(int) noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() {}
  };
};
sensor_msgs::Image last;
Task run() {
  last.data.resize(100);
  unsigned char* at = last.data.data();
  )" + between + R"(
  at[0] = 1;
  co_return;
})",
                               "c++20");
  return std::any_of(facts.holds.begin(), facts.holds.end(),
                     [](const DataHold& hold) { return hold.event.kind == PublishEvent::Kind::unknown; });
}

TEST(Events, a_coroutine_that_is_suspended_lets_others_run) {
  EXPECT_FALSE(runs_unknown_code("int number = 0; (void)number;"));
  EXPECT_FALSE(runs_unknown_code("Own().await_resume();"));
  EXPECT_TRUE(runs_unknown_code("co_await Own();"));
  EXPECT_TRUE(runs_unknown_code("co_yield 1;"));
}

}  // namespace
}  // namespace tzc::rewriter::test
