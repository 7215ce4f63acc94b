// SPDX-License-Identifier: BSD-3-Clause
// Threads that wait for callbacks and read shared messages meanwhile: none sleeps while there is something to call.
#include "roscpp/spin/heard_queue.h"

#include <gtest/gtest.h>
#include <tzc/channel.h>
#include <tzc/memory.h>

#include <boost/make_shared.hpp>

#include <future>
#include <thread>

namespace tzc {
namespace detail {
namespace {

using std::chrono::milliseconds;

// A wake-up that is lost costs all of it.
constexpr milliseconds most_idle(20'000);
constexpr milliseconds slow(10'000);

class Call final : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    function_();
    return Success;
  }

 private:
  const std::function<void()> function_;
};

/// A queue with idle threads, and a channel whose messages are added to it by the thread that reads.
class HeardQueueWithThreads : public ::testing::Test {
 protected:
  void SetUp() override {
    out_ = *channel::Publisher::create(channel::PublisherOptions());
    channel::SubscriberOptions options;
    options.address = out_->address();
    options.shared_thread = true;
    options.on_message = [this](const channel::MessagePtr&) { add([this] { ++called_; }); };
    in_ = *channel::Subscriber::create(std::move(options));
  }
  void TearDown() override {
    stop_ = true;
    for (std::size_t i = 0; i < threads_.size(); ++i) add([] {});
    for (std::thread& thread : threads_) thread.join();
  }

  void start(int count) {
    for (int i = 0; i < count; ++i) {
      threads_.emplace_back([this] {
        while (!stop_) {
          queue_.wait(most_idle);
          queue_.callOne();
        }
      });
    }
  }
  void add(std::function<void()> function) {
    queue_.addCallback(boost::make_shared<Call>(std::move(function)), 1);
  }
  void publish() { out_->publish(channel::make_record(1, "x", 1)); }
  bool called(int count) {
    const auto end = std::chrono::steady_clock::now() + slow;
    while (called_ < count && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    return called_ == count;
  }

  HeardQueue queue_;
  std::atomic<int> called_{0};
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
  std::shared_ptr<channel::Publisher> out_;
  std::shared_ptr<channel::Subscriber> in_;
};

TEST_F(HeardQueueWithThreads, no_callback_is_left_while_a_thread_is_idle) {
  start(3);
  for (int i = 1; i <= 4000; ++i) {
    if (i % 2 == 0)
      publish();
    else
      add([this] { ++called_; });
    ASSERT_TRUE(called(i)) << i;
  }
}

TEST_F(HeardQueueWithThreads, one_thread_is_enough) {
  start(1);
  for (int i = 1; i <= 2000; ++i) {
    publish();
    ASSERT_TRUE(called(i)) << i;
  }
}

TEST_F(HeardQueueWithThreads, callbacks_of_several_threads_are_all_called) {
  start(3);
  constexpr int each = 2000;
  std::vector<std::thread> adders;
  for (int adder = 0; adder < 3; ++adder)
    adders.emplace_back([this] {
      for (int i = 0; i < each; ++i) add([this] { ++called_; });
    });
  for (std::thread& adder : adders) adder.join();
  EXPECT_TRUE(called(3 * each));
}

/// Two callbacks of which each waits until the other one runs.
class Meeting {
 public:
  void come() {
    ++here_;
    const auto end = std::chrono::steady_clock::now() + slow;
    while (here_ < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    if (here_ >= 2) ++met_;
  }
  bool took_place() const { return met_ == 2; }

 private:
  std::atomic<int> here_{0}, met_{0};
};

TEST_F(HeardQueueWithThreads, two_callbacks_run_at_once_on_two_threads) {
  start(2);
  for (int round = 0; round < 300; ++round) {
    Meeting meeting;
    std::atomic<int> ended{0};
    for (int i = 0; i < 2; ++i)
      add([&] {
        meeting.come();
        ++ended;
      });
    while (ended < 2) std::this_thread::yield();
    ASSERT_TRUE(meeting.took_place()) << round;
  }
}

TEST_F(HeardQueueWithThreads, what_is_read_while_a_callback_runs_is_called_by_another_thread) {
  start(2);
  for (int round = 1; round <= 300; ++round) {
    std::promise<void> end;
    std::atomic<bool> ended{false};
    add([&] {
      end.get_future().wait();
      ended = true;
    });
    publish();
    const bool in_time = called(round);
    end.set_value();
    while (!ended) std::this_thread::yield();
    ASSERT_TRUE(in_time) << round;
  }
}

/// What reads on the guest's thread leaves it a call.
class HeardQueueWithGuest : public HeardQueueWithThreads {
 protected:
  void SetUp() override {
    steps.clear();
    HeardQueueWithThreads::SetUp();
    channel::SubscriberOptions options;
    options.address = out_->address();
    options.shared_thread = true;
    options.on_message = [this](const channel::MessagePtr&) { on_message(); };
    in_ = *channel::Subscriber::create(std::move(options));
  }
  virtual void on_message() {
    HeardQueue* const queue = HeardQueue::of_guest();
    if (queue == nullptr) return note("no guest");
    EXPECT_EQ(queue, &queue_);
    note(queue->leave_call([] { note("left"); }) ? "taken" : "refused");
    note(queue->leave_call([] { note("second"); }) ? "taken" : "refused");
    add([this] {
      note("added");
      ++called_;
    });
  }
  /// The thread may not wait as a guest yet when the first ones come.
  void publish_to_guest() {
    for (bool came = false; !came;) {
      steps.clear();
      publish();
      while (first_step().empty()) std::this_thread::yield();
      came = first_step() != "no guest";
    }
  }
  static std::string first_step() {
    const std::lock_guard<std::mutex> lock(mutex);
    return steps.empty() ? std::string() : steps.front();
  }
  static void note(const std::string& step) {
    const std::lock_guard<std::mutex> lock(mutex);
    steps.push_back(step);
  }

  static std::mutex mutex;
  static std::vector<std::string> steps;
};
std::mutex HeardQueueWithGuest::mutex;
std::vector<std::string> HeardQueueWithGuest::steps;

TEST_F(HeardQueueWithGuest, it_makes_one_call_that_it_was_left_and_before_what_came_later) {
  start(1);
  publish_to_guest();
  ASSERT_TRUE(called(1));
  EXPECT_EQ(steps, (std::vector<std::string>{"taken", "refused", "left", "added"}));
}

TEST_F(HeardQueueWithGuest, it_takes_none_while_something_waits_or_the_queue_is_disabled) {
  EXPECT_EQ(HeardQueue::of_guest(), nullptr);
  add([] {});
  EXPECT_FALSE(queue_.leave_call([] {}));
  queue_.clear();
  queue_.disable();
  EXPECT_FALSE(queue_.leave_call([] {}));
  queue_.enable();
  EXPECT_TRUE(queue_.leave_call([] { note("left"); }));
  queue_.wait(milliseconds(1));
  EXPECT_EQ(steps, std::vector<std::string>{"left"});
}

/// The call that is left waits for a callback that is added after it: another thread has to call that one.
class HeardQueueWithSlowGuest : public HeardQueueWithGuest {
 protected:
  void SetUp() override {
    ended = 0;
    HeardQueueWithGuest::SetUp();
  }
  void on_message() override {
    meeting = std::make_unique<Meeting>();
    HeardQueue* const queue = HeardQueue::of_guest();
    const auto come = [] {
      meeting->come();
      ++ended;
    };
    if (queue == nullptr || !queue->leave_call(come)) add(come);
    add(come);
  }

  static std::unique_ptr<Meeting> meeting;
  static std::atomic<int> ended;
};
std::unique_ptr<Meeting> HeardQueueWithSlowGuest::meeting;
std::atomic<int> HeardQueueWithSlowGuest::ended{0};

TEST_F(HeardQueueWithSlowGuest, what_comes_while_it_calls_is_called_by_another_thread) {
  start(2);
  for (int round = 1; round <= 300; ++round) {
    publish();
    const auto end = std::chrono::steady_clock::now() + slow;
    while (ended < 2 * round && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    ASSERT_EQ(ended, 2 * round);
    ASSERT_TRUE(meeting->took_place()) << round;
  }
}

}  // namespace
}  // namespace detail
}  // namespace tzc
