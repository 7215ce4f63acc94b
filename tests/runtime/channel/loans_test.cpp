// SPDX-License-Identifier: BSD-3-Clause
// Few sockets are lent at a time: whoever needs one gets one, whatever the others do.
#include <atomic>
#include <cstring>

#include "few_descriptors.h"
#include "raw_peer.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

#ifndef TZC_PORTABLE

/// At most eight are lent.
class Loans : public ::testing::Test {
 protected:
  static constexpr int most = 8;

  /// Leaves inside the callback of its first message, which it keeps, while others lie unread in its socket.
  void leave_and_keep_one() {
    const auto out = publisher();
    std::atomic<bool> published{false};
    std::shared_ptr<Subscriber> subscriber;
    std::atomic<bool> left{false};
    SubscriberOptions options;
    options.address = out->address();
    options.shared_thread = true;
    options.on_message = [&](const MessagePtr& message) {
      while (!published) std::this_thread::yield();
      kept_.push_back(message);
      subscriber.reset();
      left = true;
    };
    subscriber = *Subscriber::create(std::move(options));
    for (int i = 0; i < 3; ++i) out->publish(text_record(large_text(i)));
    published = true;
    ASSERT_TRUE(eventually([&] { return left.load(); }));
    publishers_.push_back(out);
  }

  const FewDescriptors few_{static_cast<rlim_t>(open_descriptors()) + 300};
  std::vector<std::shared_ptr<Publisher>> publishers_;
  std::vector<MessagePtr> kept_;
};

TEST_F(Loans, one_that_left_keeps_none_with_the_messages_that_it_keeps) {
  for (int i = 0; i < most; ++i) leave_and_keep_one();
  const auto out = publisher();
  const auto in = inbox(out->address());
  out->publish(text_record(large_text(1)));
  EXPECT_TRUE(in->wait_for(1));
}

// Something crosses each of them again before it would be given up.
TEST_F(Loans, busy_connections_take_turns) {
  std::vector<std::unique_ptr<Inbox>> in;
  for (int i = 0; i < 3 * most; ++i) {
    publishers_.push_back(publisher());
    in.push_back(inbox(publishers_.back()->address()));
  }
  std::atomic<bool> done{false};
  std::thread publishes([&] {
    for (int i = 0; !done; ++i) {
      for (const auto& each : publishers_) each->publish(text_record(large_text(i)));
      std::this_thread::yield();
    }
  });
  for (const auto& each : in) EXPECT_TRUE(each->wait_for(10));
  done = true;
  publishes.join();
}

/// Lets the reader look for a loan before it has come, and stops it there until the loan and the publisher's end have.
struct LateLoan {
  static inline std::atomic<int> heard{0};
  static inline std::atomic<bool> looked{false}, may_go{false};
  static void at(const char* name) {
    if (std::strcmp(name, "trunk: hears") == 0 && heard++ == 0)
      eventually([] { return looked.load(); }, 1000);
    if (std::strcmp(name, "take: no socket") == 0 && !looked.exchange(true))
      eventually([] { return may_go.load(); }, 5000);
  }
};

TEST(LoanThatComesLate, is_read_before_the_end) {
  auto out = publisher();
  const auto in = inbox(out->address());
  out->publish(text_record("the reader has begun"));
  ASSERT_TRUE(in->wait_for(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // its first loan ends
  sync_point_hook = LateLoan::at;
  out->publish(text_record(large_text(1)));
  ASSERT_TRUE(eventually([] { return LateLoan::looked.load(); }, 2000));
  out.reset();
  ASSERT_TRUE(eventually([] { return LateLoan::heard.load() >= 2; }, 2000));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  LateLoan::may_go = true;
  EXPECT_TRUE(in->wait_for_end());
  sync_point_hook = nullptr;
  EXPECT_EQ(in->messages().size(), 2u);
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
