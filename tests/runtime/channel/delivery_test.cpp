// SPDX-License-Identifier: BSD-3-Clause
// What is published arrives, whole and in order, in whatever size and number.
#include <poll.h>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

TEST(Delivery, a_control_part_and_its_blocks_arrive) {
  const auto out = publisher();
  Inbox in(out->address());
  ASSERT_TRUE(in.subscriber) << in.error;
  ASSERT_EQ(
      out->publish(text_record("hello", {filled(*out->memory(), mb, 1), filled(*out->memory(), 100, 2)})),
      1u);
  ASSERT_TRUE(in.wait_for(1));
  const MessagePtr message = in.messages()[0];
  EXPECT_EQ(message->tag(), 7u);
  EXPECT_EQ(control_of(message), "hello");
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(message->control()) % 8, 0u);
  ASSERT_EQ(message->blocks().size(), 2u);
  EXPECT_TRUE(all_bytes_are(message->blocks()[0], 1));
  EXPECT_TRUE(all_bytes_are(message->blocks()[1], 2));
  EXPECT_TRUE(in_segment(message->blocks()[0].data));
}

TEST(Delivery, messages_come_in_order) {
  const auto out = publisher(2000);
  Inbox in(out->address());
  for (int i = 0; i < 1000; ++i) out->publish(text_record(std::to_string(i)));
  ASSERT_TRUE(in.wait_for(1000));
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(control_of(in.messages()[i]), std::to_string(i));
}

TEST(Delivery, every_subscriber_gets_every_message) {
  const auto out = publisher(100);
  std::vector<std::unique_ptr<Inbox>> inboxes;
  for (int i = 0; i < 8; ++i) inboxes.push_back(std::make_unique<Inbox>(out->address()));
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(out->publish(text_record("x", {filled(*out->memory(), 1000, 3)})), 8u);
  for (const auto& in : inboxes) EXPECT_TRUE(in->wait_for(50));
}

TEST(Delivery, another_process_shares_the_memory) {
  const auto out = publisher();
  const std::string address = out->address();
  const pid_t child = in_child([&address] {
    Inbox in(address);
    if (!in.subscriber || !in.wait_for(1)) return 1;
    return all_bytes_are(in.messages()[0]->blocks()[0], 9) ? 0 : 2;
  });
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  EXPECT_EQ(out->connections()[0]->peer().pid, child);
  out->publish(text_record("x", {filled(*out->memory(), 4 * mb, 9)}));
  EXPECT_EQ(exit_status(child), 0);
}

TEST(Delivery, records_larger_than_a_socket_travel_as_fragments) {
  const auto out = publisher();
  Inbox in(out->address());
  for (const std::size_t size : {std::size_t{0}, std::size_t{65'000}, std::size_t{70'000}, 6 * mb}) {
    std::string text(size, 'x');
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 7 + size);
    in.clear();
    out->publish(text_record(text, {filled(*out->memory(), 64, 4)}));
    ASSERT_TRUE(in.wait_for(1)) << size;
    EXPECT_TRUE(control_of(in.messages()[0]) == text) << size;
    EXPECT_TRUE(all_bytes_are(in.messages()[0]->blocks()[0], 4));
  }
}

TEST(Delivery, a_large_control_part_goes_into_a_block_when_it_may) {
  const auto out = publisher();
  Inbox in(out->address());
  const std::string text(300'000, 'c');
  out->publish(
      make_record(1, text.data(), text.size(), {filled(*out->memory(), 64, 4)}, out->memory().get()));
  ASSERT_TRUE(in.wait_for(1));
  const MessagePtr message = in.messages()[0];
  EXPECT_EQ(control_of(message), text);
  EXPECT_EQ(message->blocks().size(), 1u);
  EXPECT_TRUE(in_segment(message->control()));
  EXPECT_LT(in.subscriber->stats().bytes, 1000u);
}

TEST(Delivery, the_callers_own_loop_polls_a_descriptor) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  ASSERT_GE(in->fd(), 0);
  EXPECT_FALSE(in->read());
  pollfd one{in->fd(), POLLIN, 0};
  EXPECT_EQ(::poll(&one, 1, 0), 0);
  out->publish(text_record("ready", {filled(*out->memory(), 100, 5)}));
  ASSERT_EQ(::poll(&one, 1, 5000), 1);
  MessagePtr message;
  ASSERT_TRUE(eventually([&] { return static_cast<bool>(message = in->read()); }));
  EXPECT_EQ(control_of(message), "ready");
}

TEST(Delivery, one_message_goes_out_on_two_publishers) {
  const auto first = publisher(), second = publisher();
  Inbox a(first->address()), b(second->address());
  const RecordPtr record = text_record("both", {filled(*first->memory(), mb, 6)});
  EXPECT_EQ(first->publish(record) + second->publish(record), 2u);
  ASSERT_TRUE(a.wait_for(1) && b.wait_for(1));
  EXPECT_TRUE(all_bytes_are(b.messages()[0]->blocks()[0], 6));
}

TEST(Delivery, a_block_sent_twice_is_held_twice) {
  const auto out = publisher(10, mb);
  Inbox in(out->address());
  const RecordPtr record = text_record("again", {filled(*out->memory(), mb, 6)});
  out->publish(record);
  out->publish(record);
  ASSERT_TRUE(in.wait_for(2));
  EXPECT_EQ(in.messages()[0]->blocks()[0].size, in.messages()[1]->blocks()[0].size);
}

TEST(Delivery, nothing_precedes_on_connect_and_what_it_sends) {
  PublisherOptions options;
  options.queue_size = 0;
  options.on_connect = [](const ConnectionPtr& connection) { connection->send(text_record("first")); };
  const auto out = publish_with(std::move(options));
  std::atomic<bool> stop{false};
  std::thread noise([&] {
    while (!stop) {
      out->publish(text_record("later"));
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 20; ++i) {
    Inbox in(out->address());
    EXPECT_TRUE(in.wait_for(1));
    EXPECT_EQ(control_of(in.messages()[0]), "first");
  }
  stop = true;
  noise.join();
}

TEST(Delivery, threads_may_publish_concurrently) {
  const auto out = publisher(0, 64 * mb);
  Inbox in(out->address());
  std::vector<std::thread> threads;
  for (unsigned char mark = 1; mark <= 4; ++mark) {
    threads.emplace_back([&out, mark] {
      for (int i = 0; i < 500; ++i) {
        const BufferPtr buffer = filled(*out->memory(), 5000, mark);
        ASSERT_TRUE(buffer);
        out->publish(text_record(std::string(1, static_cast<char>(mark)), {buffer}));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_TRUE(in.wait_for(2000));
  for (const MessagePtr& message : in.messages())
    ASSERT_TRUE(all_bytes_are(message->blocks()[0], static_cast<unsigned char>(message->control()[0])));
}

TEST(Delivery, hello_and_authorization) {
  PublisherOptions options;
  options.authorize = [](const Credentials& who, const std::string& hello) {
    return who.uid == ::getuid() && hello == "friend";
  };
  const auto out = publish_with(std::move(options));
  Inbox stranger(out->address(), "enemy"), in(out->address(), "friend");
  EXPECT_FALSE(stranger.subscriber);
  EXPECT_NE(stranger.error.find("did not authorize"), std::string::npos) << stranger.error;
  ASSERT_TRUE(in.subscriber) << in.error;
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  EXPECT_EQ(out->connections()[0]->hello(), "friend");
  EXPECT_EQ(out->stats().refused_peers, 1u);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
