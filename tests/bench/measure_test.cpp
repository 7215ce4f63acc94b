// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "poor_process.h"

namespace {

using namespace tzc::bench;
using testing::HasSubstr;
using tzc::test::has_children;
using tzc::test::in_poor_process;
using tzc::test::not_possible;
using tzc::test::ProcessEnd;

using Settings = Setup;  // testing::Test has a Setup of its own

Settings setup_for(std::size_t subscribers) {
  return {64, subscribers, 1000, 5, "measure_test"};
}

/// Subscribers that wait, and a publisher that does what a test says.
class MadeUp : public Contender {
 public:
  using Publish = std::function<void(std::uint64_t)>;
  using Open = std::function<Publish(const Setup&)>;
  explicit MadeUp(Open open) : open_(std::move(open)) {}

  const char* name() const override { return "made-up"; }
  void subscribe(const Setup&, std::size_t, Recorder& recorder) override {
    recorder.ready();
    while (!recorder.stop()) ::usleep(1000);
  }
  Publish publish(const Setup& setup) override { return open_(setup); }

 private:
  const Open open_;
};

/// The publisher calls its subscribers.
class InOneProcess final : public Contender {
 public:
  const char* name() const override { return "in-one-process"; }
  bool in_one_process() const override { return true; }
  void subscribe(const Setup&, std::size_t, Recorder&) override {}
  void subscribe_here(const Setup&, std::vector<Recorder>& recorders) override {
    for (Recorder& recorder : recorders) recorder.ready();
    recorders_ = &recorders;
  }
  std::function<void(std::uint64_t)> publish(const Setup&) override {
    return [this](std::uint64_t index) {
      for (Recorder& recorder : *recorders_) recorder.record({now_ns(), index});
    };
  }

 private:
  std::vector<Recorder>* recorders_ = nullptr;
};

/// Its subscribers end before the publisher has found them.
class Fleeting final : public Contender {
 public:
  const char* name() const override { return "fleeting"; }
  void subscribe(const Setup&, std::size_t who, Recorder& recorder) override {
    recorder.ready();
    while (who != 1 && !recorder.stop()) ::usleep(1000);
  }
  std::function<void(std::uint64_t)> publish(const Setup&) override {
    for (;;) ::pause();
  }
};

/// What a measurement says while it fails.
std::string failure_of(Contender& contender, const Setup& setup) {
  testing::internal::CaptureStderr();
  const Measurement measurement = measure(contender, setup);
  EXPECT_EQ(measurement.outcome, Outcome::failed);
  EXPECT_FALSE(has_children());
  return testing::internal::GetCapturedStderr();
}

TEST(Measure, has_what_every_subscriber_got) {
  InOneProcess contender;
  const Measurement measurement = measure(contender, setup_for(2));
  EXPECT_EQ(measurement.outcome, Outcome::complete);
  ASSERT_EQ(measurement.latency_ns.size(), 2u);
  for (const auto& latencies : measurement.latency_ns) EXPECT_THAT(latencies, testing::Each(testing::Gt(0u)));
}

TEST(Measure, fails_where_the_publisher_never_finds_its_subscribers) {
  MadeUp contender([](const Settings&) -> MadeUp::Publish {
    for (;;) ::pause();
  });
  Settings setup = setup_for(2);
  setup.patience = std::chrono::milliseconds(300);
  EXPECT_THAT(
      failure_of(contender, setup),
      HasSubstr("made-up: after 0.3 s the publisher is not connected to all subscribers (2 of 2 are ready)"));
}

TEST(Measure, tells_a_publisher_that_waits_when_it_is_over) {
  class CleansUp final : public MadeUp {
   public:
    using MadeUp::MadeUp;
    bool cleans_up_at_exit() const override { return true; }
  } contender([](const Settings& setup) -> MadeUp::Publish {
    if (!wait_until(setup, [] { return false; })) return {};
    return [](std::uint64_t) {};
  });
  Settings setup = setup_for(1);
  setup.patience = std::chrono::milliseconds(300);
  const auto start = std::chrono::steady_clock::now();
  failure_of(contender, setup);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15)) << "it was killed in the end";
}

TEST(Measure, fails_as_soon_as_a_subscriber_has_ended) {
  Fleeting contender;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(failure_of(contender, setup_for(2)), HasSubstr("fleeting: a subscriber has ended early"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, setup_for(2).patience / 2);
}

TEST(Measure, fails_where_the_publisher_has_ended_early) {
  MadeUp contender([](const Settings&) -> MadeUp::Publish { ::_exit(1); });
  EXPECT_THAT(failure_of(contender, setup_for(1)), HasSubstr("made-up: the publisher has ended early"));
}

TEST(Measure, stops_those_that_have_started_where_no_more_can_be) {
  const ProcessEnd end = in_poor_process(2, [] {
    MadeUp contender([](const Settings&) -> MadeUp::Publish { return [](std::uint64_t) {}; });
    const bool failed = measure(contender, setup_for(4)).outcome == Outcome::failed;
    return failed && !has_children() ? 0 : 1;
  });
  if (end.exited_with(not_possible)) GTEST_SKIP() << tzc::test::why_not_possible;
  EXPECT_TRUE(end.exited_with(0)) << end.status;
  EXPECT_THAT(end.said, HasSubstr("made-up: cannot start a process: "));
}

}  // namespace
