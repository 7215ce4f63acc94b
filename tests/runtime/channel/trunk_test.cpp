// SPDX-License-Identifier: BSD-3-Clause
// Connections whose two processes have a trunk: sockets come and go, and nothing else changes.
#include "channel/connect/trunk.h"

#include <signal.h>

#include <algorithm>
#include <atomic>
#include <random>

#include "few_descriptors.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

#ifndef TZC_PORTABLE

TEST(Trunk, connections_keep_no_descriptor) {
  constexpr int topics = 40, subscribers = 3;
  const auto first = publisher();
  const auto with_trunk = inbox(first->address());
  first->publish(text_record("x", {filled(*first->memory(), 1000, 1)}));
  ASSERT_TRUE(with_trunk->wait_for(1));
  const int before = open_descriptors();
  std::vector<std::shared_ptr<Publisher>> out;
  std::vector<std::unique_ptr<Inbox>> in;
  for (int i = 0; i < topics; ++i) {
    PublisherOptions options;
    options.queue_size = 4;
    out.push_back(publish_with(options));
    for (int j = 0; j < subscribers; ++j) in.push_back(inbox(out.back()->address()));
  }
  for (const auto& each : out) each->publish(text_record("x", {filled(*each->memory(), 1000, 1)}));
  for (const auto& each : in) ASSERT_TRUE(each->wait_for(1));
  EXPECT_TRUE(eventually([&] { return open_descriptors() <= before + 1; }))
      << open_descriptors() - before << " for " << topics * subscribers << " connections";
  for (const auto& each : out) each->publish(text_record("y"));
  for (const auto& each : in) EXPECT_TRUE(each->wait_for(2)) << "without a socket of its own";
}

TEST(Trunk, what_needs_a_socket_gets_one_again) {
  const auto out = publisher();
  const auto in = inbox(out->address());
  const int without = open_descriptors();
  for (int i = 0; i < 2; ++i) {
    out->publish(text_record(large_text(i)));
    out->publish(text_record("small"));
    ASSERT_TRUE(in->wait_for(2 * i + 2));
    EXPECT_EQ(control_of(in->messages()[2 * i]), large_text(i));
    EXPECT_TRUE(eventually([&] { return open_descriptors() <= without; }));
  }
}

// Half of the sizes cross the ring; pauses are about as long as a loan lasts.
TEST(Trunk, order_and_content_survive_any_sequence_of_loans) {
  for (const unsigned seed : {1u, 2u}) {
    std::mt19937 random(seed);
    const auto out = publisher(1000);
    const auto in = inbox(out->address());
    std::vector<std::string> sent;
    for (int i = 0; i < 200; ++i) {
      static constexpr std::size_t sizes[] = {10, 100, 400, 600, 5000, 200'000};
      sent.push_back(std::to_string(i) + std::string(sizes[random() % 6], 'x'));
      out->publish(text_record(sent.back()));
      if (random() % 8 == 0) std::this_thread::sleep_for(milliseconds(random() % 110));
    }
    ASSERT_TRUE(in->wait_for(sent.size())) << "seed " << seed;
    const auto received = in->messages();
    for (std::size_t i = 0; i < sent.size(); ++i) ASSERT_EQ(control_of(received[i]), sent[i]) << seed;
  }
}

/// The most descriptors of this process while it lives, seen now and then.
class MostDescriptors {
 public:
  ~MostDescriptors() { stop(); }
  int stop() {
    stopped_ = true;
    if (looks_.joinable()) looks_.join();
    return most_;
  }

 private:
  std::atomic<bool> stopped_{false};
  std::atomic<int> most_{0};
  std::thread looks_{[this] {
    while (!stopped_) {
      most_ = std::max(most_.load(), open_descriptors());
      std::this_thread::yield();
    }
  }};
};

TEST(Trunk, few_sockets_are_lent_at_a_time_and_all_get_one_in_the_end) {
  const auto out = publisher(20);
  std::vector<std::unique_ptr<Inbox>> in;
  for (int i = 0; i < 60; ++i) in.push_back(inbox(out->address()));
  const int before = open_descriptors();
  const FewDescriptors few(static_cast<rlim_t>(before) + 120);
  MostDescriptors most;
  for (int i = 0; i < 10; ++i) out->publish(text_record(large_text(i)));
  for (const auto& each : in) EXPECT_TRUE(each->wait_for(10));
  EXPECT_LE(most.stop(), before + 8 * 2 + 8);  // both ends are here, and a few descriptors on their way
}

// Its loans are open for as long as it reads nothing.
TEST(Trunk, another_process_that_stops_keeps_loans_from_nobody_else) {
  const auto out = publisher(4);
  const FewDescriptors few(static_cast<rlim_t>(open_descriptors()) + 120);
  const pid_t child = in_child([&] {
    std::vector<std::unique_ptr<Inbox>> its;
    for (int i = 0; i < 20; ++i) its.push_back(inbox(out->address()));
    for (;;) ::pause();
    return 0;
  });
  ASSERT_TRUE(eventually([&] { return out->stats().subscribers == 20; }));
  ::kill(child, SIGSTOP);
  const auto in = inbox(out->address());
  for (int i = 0; i < 20; ++i) {
    out->publish(text_record(large_text(i)));
    EXPECT_TRUE(in->wait_for(static_cast<std::size_t>(i) + 1)) << i;
  }
  ::kill(child, SIGCONT);
  const auto has_taken_all = [](const auto& connection) { return connection->in_flight() == 0; };
  EXPECT_TRUE(eventually([&] {
    const auto all = out->connections();
    return all.size() == 21 && std::all_of(all.begin(), all.end(), has_taken_all);
  }));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST(Trunk, a_message_waits_for_a_descriptor_and_others_keep_theirs) {
  const auto out = publisher();
  const auto in = inbox(out->address());
  std::vector<posix::FileDescriptor> occupied;
  {
    const FewDescriptors few(static_cast<rlim_t>(open_descriptors()) + 80);
    for (int round = 0; round < 2; ++round) {  // what the greeting used is closed by then
      while (posix::FileDescriptor one{::dup(0)}) occupied.push_back(std::move(one));
      std::this_thread::sleep_for(milliseconds(100));
    }
    std::sort(occupied.begin(), occupied.end(),
              [](const auto& a, const auto& b) { return a.get() < b.get(); });
    occupied.resize(occupied.size() - 3);  // the highest, and less than an eighth of them
    out->publish(text_record(large_text(1)));
    out->publish(text_record("after it"));
    std::this_thread::sleep_for(milliseconds(200));
    EXPECT_TRUE(in->messages().empty());
    occupied.clear();
    EXPECT_TRUE(in->wait_for(2));
  }
  EXPECT_EQ(control_of(in->messages()[0]), large_text(1));
}

TEST(Trunk, what_was_sent_before_the_end_arrives) {
  for (int i = 0; i < 50; ++i) {
    auto out = publisher(100);
    const auto in = inbox(out->address());
    for (int j = 0; j < i; ++j) out->publish(text_record(j % 3 == 0 ? large_text(j) : "small"));
    out.reset();
    ASSERT_TRUE(in->wait_for_end());
    ASSERT_EQ(in->messages().size(), static_cast<std::size_t>(i));
  }
}

TEST(Trunk, a_process_that_is_killed_leaves_nothing) {
  const auto out = publisher(4, 4 * mb, Policy::best_effort());
  const pid_t child = in_child([&] {
    const auto in = inbox(out->address());
    for (;;) ::pause();
    return 0;
  });
  ASSERT_TRUE(eventually([&] { return out->stats().subscribers == 1; }));
  for (int i = 0; i < 4; ++i) out->publish(text_record("x", {filled(*out->memory(), mb / 2, 1)}));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(eventually([&] { return out->connections().empty(); }));
  EXPECT_TRUE(out->memory()->allocate(3 * mb));
}

TEST(Trunk, a_publisher_that_is_killed_is_noticed) {
  int address[2];
  ASSERT_EQ(::pipe(address), 0);
  const pid_t child = in_child([&] {
    const auto out = publisher();
    const std::string text = out->address();
    if (::write(address[1], text.data(), text.size()) < 0) return 1;
    for (int i = 0;; ++i) {
      out->publish(text_record(large_text(i)));
      std::this_thread::sleep_for(milliseconds(1));
    }
    return 0;
  });
  char text[200];
  const ssize_t size = ::read(address[0], text, sizeof text);
  const auto in = inbox(std::string(text, static_cast<std::size_t>(size)));
  ASSERT_TRUE(in->wait_for(10));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(in->wait_for_end());
  ::close(address[0]);
  ::close(address[1]);
}

TEST(Trunk, messages_that_are_held_keep_their_blocks_after_the_subscriber) {
  const auto out = publisher(4, 4 * mb, Policy::best_effort());
  auto in = inbox(out->address());
  out->publish(text_record("x", {filled(*out->memory(), 3 * mb, 7)}));
  ASSERT_TRUE(in->wait_for(1));
  std::vector<MessagePtr> held = in->messages();
  in.reset();
  ASSERT_TRUE(eventually([&] { return out->stats().subscribers == 0; }));
  EXPECT_FALSE(out->memory()->allocate(3 * mb));
  EXPECT_TRUE(all_bytes_are(held[0]->blocks()[0], 7));
  held.clear();
  EXPECT_TRUE(eventually([&] { return static_cast<bool>(out->memory()->allocate(3 * mb)); }));
}

// The parent's connections live on when a forked child ends, or uses the library itself.
TEST(Trunk, a_forked_child_has_its_own) {
  const auto out = publisher();
  const auto in = inbox(out->address());
  const pid_t child = in_child([&] {
    const auto own = publisher();
    const auto of_child = inbox(own->address());
    const auto of_parent = inbox(out->address());
    own->publish(text_record(large_text(1)));
    return of_child->wait_for(1) && of_parent->subscriber ? 0 : 1;
  });
  EXPECT_EQ(exit_status(child), 0);
  out->publish(text_record(large_text(2)));
  EXPECT_TRUE(in->wait_for(1));
}

TEST(Trunk, many_threads_connect_and_leave_at_once) {
  const auto out = publisher();
  std::vector<std::thread> threads;
  std::atomic<int> failed{0};
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 50; ++j) failed += inbox(out->address())->subscriber ? 0 : 1;
    });
  for (auto& each : threads) each.join();
  EXPECT_EQ(failed, 0);
  EXPECT_TRUE(eventually([&] { return out->connections().empty(); }));
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
