// SPDX-License-Identifier: BSD-3-Clause
// Few sockets are lent at a time: whoever needs one gets one, whatever the others do.
#include <atomic>

#include "few_descriptors.h"
#include "raw_peer.h"

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

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
