// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/throttled_warning.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace tzc {
namespace detail {
namespace {

using Clock = ThrottleBySubject::Clock;
constexpr std::chrono::seconds kPeriod{60};
const Clock::time_point kNow = Clock::now();

TEST(ThrottleBySubject, each_subject_is_due_once_in_a_period) {
  ThrottleBySubject throttle(kPeriod);
  EXPECT_TRUE(throttle.is_due("/left", kNow));
  EXPECT_TRUE(throttle.is_due("/right", kNow)) << "one topic does not silence another";
  EXPECT_FALSE(throttle.is_due("/left", kNow + kPeriod / 2));
  EXPECT_FALSE(throttle.is_due("/right", kNow + kPeriod / 2));
  EXPECT_TRUE(throttle.is_due("/left", kNow + kPeriod));
  EXPECT_FALSE(throttle.is_due("/left", kNow + kPeriod + kPeriod / 2));
}

/// How many of so many subjects are due.
std::size_t due(ThrottleBySubject& throttle, std::size_t subjects, const std::string& prefix,
                Clock::time_point now) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < subjects; ++i)
    count += throttle.is_due(prefix + std::to_string(i), now) ? 1 : 0;
  return count;
}

TEST(ThrottleBySubject, remembers_so_many_subjects_and_no_more) {
  const std::size_t most = ThrottleBySubject::kMostSubjects;
  ThrottleBySubject throttle(kPeriod);
  EXPECT_EQ(due(throttle, 10 * most, "/a", kNow), most + 1) << "the others share one throttle";
  EXPECT_EQ(due(throttle, most, "/a", kNow), 0u);
  EXPECT_EQ(due(throttle, most, "/b", kNow + kPeriod), most) << "those of the last period are forgotten";
}

TEST(ThrottleBySubject, threads_get_one_turn_for_each_subject) {
  ThrottleBySubject throttle(kPeriod);
  std::atomic<std::size_t> turns{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&] { turns += due(throttle, 100, "/", kNow); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(turns, 100u);
}

/// What the macro makes of a subject; whether its text was put together.
bool warns(const std::string& topic) {
  bool warned = false;
  const auto text = [&] {
    warned = true;
    return topic + " is warned about";
  };
  TZC_WARN_THROTTLED_FOR(topic, 60, text());
  return warned;
}

TEST(ThrottledWarning, a_place_in_the_code_warns_of_each_topic) {
  EXPECT_TRUE(warns("/left"));
  EXPECT_TRUE(warns("/right"));
  EXPECT_FALSE(warns("/left"));
}

TEST(ThrottleBySubject, a_process_without_descriptors_is_one_subject) {
  EXPECT_EQ(subject_of(EMFILE, "/image"), subject_of(ENFILE, "/cloud"));
  EXPECT_EQ(subject_of(ENOMEM, "/image"), "/image");
}

}  // namespace
}  // namespace detail
}  // namespace tzc
