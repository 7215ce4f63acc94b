// SPDX-License-Identifier: BSD-3-Clause
// A thread of the program that reads in the place of the library's while it has nothing else to do.
#include "tzc/shared_reading.h"

#include <atomic>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

bool nothing_wanted() {
  return false;
}

#ifdef TZC_PORTABLE

TEST(SharedReading, is_not_there_without_a_futex) {
  const auto out = publisher();
  Inbox in(out->address());
  EXPECT_FALSE(read_while_idle(seconds(1), nothing_wanted));
}

#else

/// A subscriber on the shared thread, which notes the thread of each message.
class SharedReading : public ::testing::Test {
 protected:
  void SetUp() override {
    SubscriberOptions options;
    options.address = out_->address();
    options.shared_thread = true;
    options.on_message = [this](const MessagePtr& message) {
      thread_ = std::this_thread::get_id();
      if (calls_back_) refused_ = !read_while_idle(seconds(1), nothing_wanted);
      last_ = std::stoi(control_of(message));
    };
    in_ = *Subscriber::create(std::move(options));
  }

  void publish(int number) { out_->publish(text_record(std::to_string(number))); }
  bool received(int number) {
    return eventually([&] { return last_ == number; });
  }
  bool is_guests() const { return thread_ == guest_.get_id(); }
  /// Reads until stop(); `idle_` is true while it does.
  void start_guest() {
    guest_ = std::thread([this] {
      while (!stop_)
        read_while_idle(seconds(5), [this] { return stop_ || work_ > 0; }) && work_ > 0 && work();
    });
  }
  bool work() {
    --work_;
    ++worked_;
    return true;
  }
  void TearDown() override {
    stop_ = true;
    if (!guest_.joinable()) return;
    wake_idle_reader();
    guest_.join();
  }

  // What the guest uses outlives a test that fails: TearDown() ends it.
  const std::shared_ptr<Publisher> out_ = publisher(1000);
  std::atomic<int> last_{0}, work_{0}, worked_{0};
  std::atomic<bool> stop_{false};
  std::atomic<std::thread::id> thread_{};
  std::atomic<bool> calls_back_{false}, refused_{false};
  std::thread guest_;
  std::shared_ptr<Subscriber> in_;
};

TEST_F(SharedReading, a_guest_reads_and_the_library_does_when_it_is_gone) {
  publish(1);
  EXPECT_TRUE(received(1));
  const std::thread::id librarys = thread_;
  start_guest();
  EXPECT_TRUE(eventually([&] {  // from the time on when it sleeps
    publish(2);
    return received(2) && is_guests();
  }));
  stop_ = true;
  wake_idle_reader();
  guest_.join();
  publish(3);
  EXPECT_TRUE(received(3));
  EXPECT_EQ(thread_, librarys);
}

TEST_F(SharedReading, a_guest_does_what_else_is_wanted_at_once) {
  start_guest();
  for (int i = 1; i <= 1000; ++i) {
    ++work_;
    wake_idle_reader();
    ASSERT_TRUE(eventually([&] { return worked_ == i; }, 4000))
        << "the guest slept on for its five seconds: " << i;
  }
}

// A wake-up that is lost costs the reader's second, or the guest's five. A busy machine may take as long now and then.
TEST_F(SharedReading, no_message_is_left_between_reader_and_guest) {
  start_guest();
  int slow = 0;
  for (int i = 1; i <= 3000; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    if (i % 3 == 0) ++work_;
    publish(i);
    if (i % 3 == 0) wake_idle_reader();
    while (last_ != i) std::this_thread::yield();
    slow += std::chrono::steady_clock::now() - begin > milliseconds(900) ? 1 : 0;
  }
  EXPECT_LE(slow, 5);
}

TEST_F(SharedReading, the_library_reads_while_the_guest_works) {
  guest_ = std::thread([this] {
    read_while_idle(seconds(20), [this] { return work_ > 0 || stop_; });
    ++worked_;
    while (!stop_) std::this_thread::yield();
  });
  ++work_;
  wake_idle_reader();
  ASSERT_TRUE(eventually([this] { return worked_ > 0; }));
  for (int i = 1; i <= 100; ++i) publish(i);
  EXPECT_TRUE(received(100));
  EXPECT_FALSE(is_guests());
}

TEST_F(SharedReading, takes_the_time_given_at_most) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(read_while_idle(milliseconds(30), nothing_wanted));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(30));
}

TEST_F(SharedReading, has_one_guest_at_a_time) {
  guest_ = std::thread([this] {
    read_while_idle(seconds(20), [this] {
      worked_ = 1;
      return stop_.load();
    });
  });
  ASSERT_TRUE(eventually([this] { return worked_ == 1; }));
  EXPECT_FALSE(read_while_idle(seconds(1), nothing_wanted));
}

TEST_F(SharedReading, a_callback_is_no_guest) {
  calls_back_ = true;
  publish(1);
  EXPECT_TRUE(received(1));
  EXPECT_TRUE(refused_);
}

/// A subscriber whose messages take longer to read than to publish, so that there is always one more; and one with little to read.
/// Turns are counted in messages of the first, not in time.
class SaturatedReading : public ::testing::Test {
 protected:
  static constexpr int in_a_row = 16;  // as the subscriber's

  void SetUp() override {
    flood_ = subscribe(*flooding_, [this] {
      ++flooded_;
      std::this_thread::sleep_for(milliseconds(1));
    });
    drop_ = subscribe(*dropping_, [this] { ++dropped_; });
    flooder_ = std::thread([this] {
      while (!stop_) {
        flooding_->publish(text_record("flood"));
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      }
    });
    ASSERT_TRUE(eventually([this] { return flooded_ > 10 * in_a_row; }));
  }
  void TearDown() override {
    stop_ = true;
    flooder_.join();
  }
  static std::shared_ptr<Subscriber> subscribe(const Publisher& to, const std::function<void()>& on_message) {
    SubscriberOptions options;
    options.address = to.address();
    options.shared_thread = true;
    options.on_message = [on_message](const MessagePtr&) { on_message(); };
    return *Subscriber::create(std::move(options));
  }

  const std::shared_ptr<Publisher> flooding_ = publisher(1000), dropping_ = publisher(1000);
  std::atomic<int> flooded_{0}, dropped_{0};
  std::atomic<bool> stop_{false};
  std::shared_ptr<Subscriber> flood_, drop_;
  std::thread flooder_;
};

// Each ring of a connection that had its turn already was a turn more.
TEST_F(SaturatedReading, a_connection_that_never_empties_has_one_turn_of_each_round) {
  for (int i = 1; i <= 60; ++i) {
    const int before = flooded_;
    dropping_->publish(text_record("drop"));
    ASSERT_TRUE(eventually([&] { return dropped_ == i; }));
    EXPECT_LE(flooded_ - before, 4 * in_a_row) << "in round " << i;
  }
}

// A thread that has other work comes back to it, though the reader never rests.
TEST_F(SaturatedReading, a_guest_is_let_in_and_let_go) {
  for (int i = 1; i <= 60; ++i) {
    const int before = flooded_;
    EXPECT_TRUE(read_while_idle(milliseconds(100), [] { return true; }));
    EXPECT_LE(flooded_ - before, 4 * in_a_row) << "in call " << i;
  }
}

TEST(SharedReadingAlone, is_not_there_without_a_subscriber_in_a_child) {
  const pid_t child = in_child([] {
    wake_idle_reader();
    return read_while_idle(seconds(1), nothing_wanted) ? 1 : 0;
  });
  EXPECT_EQ(exit_status(child), 0);
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
