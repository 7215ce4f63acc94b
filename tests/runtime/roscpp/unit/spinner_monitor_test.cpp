// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/spin/spinner_monitor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace tzc {
namespace detail {
namespace {

bool may_spin_on_another_thread(SpinnerMonitor& monitor) {
  bool may = true;
  std::thread other([&] {
    try {
      const SpinsAlone alone(monitor);
    } catch (const std::runtime_error&) {
      may = false;
    }
  });
  other.join();
  return may;
}

TEST(SpinnerMonitor, one_thread_spins_alone) {
  SpinnerMonitor monitor;
  {
    const SpinsAlone alone(monitor);
    EXPECT_FALSE(may_spin_on_another_thread(monitor));
    EXPECT_THROW(monitor.begin_with_threads(), std::runtime_error);
  }
  EXPECT_TRUE(may_spin_on_another_thread(monitor));
}

TEST(SpinnerMonitor, it_may_spin_in_a_callback_and_stays_alone) {
  SpinnerMonitor monitor;
  const SpinsAlone outside(monitor);
  {
    const SpinsAlone inside(monitor);
  }
  EXPECT_FALSE(may_spin_on_another_thread(monitor));
}

TEST(SpinnerMonitor, spinners_with_threads_suffer_each_other_alone) {
  SpinnerMonitor monitor;
  monitor.begin_with_threads();
  monitor.begin_with_threads();
  monitor.end_with_threads();
  EXPECT_THROW(monitor.begin_alone(), std::runtime_error);
  monitor.end_with_threads();
  EXPECT_NO_THROW(monitor.begin_alone());
}

TEST(SpinnerMonitor, an_exception_of_a_callback_ends_the_turn) {
  SpinnerMonitor monitor;
  const auto spin = [&monitor] {
    const SpinsAlone alone(monitor);
    throw std::logic_error("of a callback");
  };
  EXPECT_THROW(spin(), std::logic_error);
  EXPECT_TRUE(may_spin_on_another_thread(monitor));
}

}  // namespace
}  // namespace detail
}  // namespace tzc
