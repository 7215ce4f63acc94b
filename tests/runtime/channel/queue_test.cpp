// SPDX-License-Identifier: BSD-3-Clause
// A slow or stopped subscriber loses its own oldest messages, counted, and harms no other.
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

std::vector<MessagePtr> read_all(Subscriber& subscriber) {
  std::vector<MessagePtr> messages;
  while (const MessagePtr message = subscriber.read()) messages.push_back(message);
  return messages;
}

TEST(Queue, a_stopped_subscriber_keeps_the_newest) {
  const auto out = publisher(3);
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 10; ++i)
    out->publish(text_record(std::to_string(i), {filled(*out->memory(), 1000, 1)}));
  const auto messages = read_all(*in);
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(control_of(messages[0]), "7");
  EXPECT_EQ(in->stats().lost, 7u);
  EXPECT_EQ(out->stats().dropped, 7u);
}

TEST(Queue, the_bound_holds_across_socket_and_outbox) {
  const auto out = publisher(100);
  const auto in = idle_subscriber(out->address());
  const std::string large(60'000, 'x');  // a socket takes only a few of these
  for (int i = 0; i < 300; ++i) out->publish(text_record(std::to_string(1000 + i) + large));
  EXPECT_GT(out->connections()[0]->stats().queued, 50u);
  EXPECT_EQ(out->connections()[0]->stats().in_flight, 100u);
  std::vector<MessagePtr> messages;
  ASSERT_TRUE(eventually([&] {
    for (const auto& message : read_all(*in)) messages.push_back(message);
    return messages.size() >= 100;
  }));
  EXPECT_EQ(messages.size(), 100u);
  EXPECT_EQ(control_of(messages.front()).substr(0, 4), "1200");
  EXPECT_EQ(control_of(messages.back()).substr(0, 4), "1299");
  EXPECT_EQ(in->stats().lost, 200u);
}

// What is kept for it goes when it has all, and is there again for the next ones.
TEST(Queue, a_long_one_fills_and_empties_twice) {
  constexpr int count = 3000;
  const auto out = publisher(count);
  const auto in = idle_subscriber(out->address());
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < count; ++i) out->publish(text_record(std::to_string(i)));
    std::vector<MessagePtr> messages;
    ASSERT_TRUE(eventually([&] {
      for (const auto& message : read_all(*in)) messages.push_back(message);
      return messages.size() >= count;
    }));
    for (int i = 0; i < count; ++i) ASSERT_EQ(control_of(messages[i]), std::to_string(i));
    EXPECT_EQ(out->connections()[0]->in_flight(), 0u);
  }
  EXPECT_EQ(out->stats().dropped, 0u);
}

TEST(Queue, blocks_are_held_from_taking_to_releasing) {
  const auto out = publisher(10);
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 3; ++i)
    out->publish(text_record("x", {filled(*out->memory(), 1000, 1), filled(*out->memory(), mb, 2)}));
  const ConnectionPtr connection = out->connections()[0];
  EXPECT_EQ(connection->held(), 0u);
  std::vector<MessagePtr> messages = read_all(*in);
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(connection->held(), 6u);
  messages.pop_back();
  EXPECT_EQ(connection->held(), 4u);
  messages.clear();
  EXPECT_EQ(connection->held(), 0u);
}

TEST(Queue, at_most_queue_size_messages_pin_memory) {
  for (const Policy policy : {Policy::worst_effort(), Policy::medium_effort(), Policy::best_effort()}) {
    const auto out = publisher(2, 4 * mb, policy);
    const auto stopped = idle_subscriber(out->address());
    for (int i = 0; i < 50; ++i) {
      const BufferPtr buffer = filled(*out->memory(), mb, 1);
      ASSERT_TRUE(buffer) << i;
      EXPECT_EQ(out->publish(text_record("x", {buffer})), 1u);
    }
    EXPECT_EQ(read_all(*stopped).size(), 2u);
  }
}

TEST(Queue, a_stopped_subscriber_does_not_disturb_the_others) {
  const auto out = publisher(4, 16 * mb);
  const auto stopped = idle_subscriber(out->address());
  Inbox in(out->address());
  for (std::size_t i = 0; i < 200; ++i) {
    out->publish(text_record(std::string(2000, 'x'), {filled(*out->memory(), mb, 1)}));
    ASSERT_TRUE(in.wait_for(1)) << i;
    in.clear();
  }
  EXPECT_EQ(in.subscriber->stats().lost, 0u);
}

TEST(Queue, a_fragmented_message_that_is_revoked_half_way_spoils_nothing) {
  const auto out = publisher(1);
  const auto in = idle_subscriber(out->address());
  const std::string huge(2 * mb, 'x');
  for (int i = 0; i < 5; ++i) out->publish(text_record(std::to_string(i) + huge));
  std::vector<MessagePtr> messages;
  ASSERT_TRUE(eventually([&] {
    for (const auto& message : read_all(*in)) messages.push_back(message);
    return !messages.empty();
  }));
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(control_of(messages[0]), "4" + huge);
  EXPECT_EQ(in->stats().lost, 4u);
}

TEST(Queue, best_effort_takes_back_what_is_in_flight) {
  const auto out = publisher(10, 2 * mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 6; ++i) {
    const BufferPtr buffer = filled(*out->memory(), mb, static_cast<unsigned char>(i));
    ASSERT_TRUE(buffer) << i;
    out->publish(text_record(std::to_string(i), {buffer}));
  }
  const auto messages = read_all(*in);
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(control_of(messages[0]), "4");
  EXPECT_TRUE(all_bytes_are(messages[0]->blocks()[0], 4));
  EXPECT_EQ(in->stats().lost, 4u);
  EXPECT_EQ(out->memory()->stats().revoked, 4u);
  EXPECT_EQ(out->stats().dropped, 4u);
}

TEST(Queue, best_effort_takes_back_what_waits_in_the_outbox) {
  const auto out = publisher(100, 4 * mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 40; ++i) out->publish(text_record(std::string(60'000, 'x')));  // fills the socket
  for (int i = 0; i < 20; ++i) {
    const BufferPtr buffer = filled(*out->memory(), mb, 1);
    ASSERT_TRUE(buffer) << i;
    out->publish(text_record(std::to_string(i), {buffer}));
  }
}

// It would free nothing.
TEST(Queue, best_effort_leaves_what_the_program_refers_to_in_flight) {
  const auto out = publisher(10, 2 * mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address());
  out->publish(text_record("a", {filled(*out->memory(), mb, 1)}));
  const MessagePtr held = in->read();
  const BufferPtr own = filled(*out->memory(), mb, 2);
  out->publish(text_record("b", {own}));
  EXPECT_FALSE(out->memory()->allocate(mb));
  const auto messages = read_all(*in);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_TRUE(all_bytes_are(messages[0]->blocks()[0], 2));
  EXPECT_EQ(out->stats().dropped, 0u);
}

TEST(Queue, best_effort_leaves_what_the_program_refers_to_in_the_outbox) {
  const auto out = publisher(100, mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address()), other = idle_subscriber(out->address());
  for (int i = 0; i < 40; ++i) out->publish(text_record(std::string(60'000, 'x')));  // fills the sockets
  BufferPtr own = filled(*out->memory(), mb, 2);
  out->publish(text_record("b", {own}));
  EXPECT_FALSE(out->memory()->allocate(mb));
  EXPECT_EQ(out->stats().dropped, 0u);
  own.reset();
  EXPECT_TRUE(out->memory()->allocate(mb)) << "each of the two queues has the same record";
  EXPECT_EQ(out->stats().dropped, 82u);
}

// Two arrays of a message in one buffer: the record in the outbox has two handles of it, which are nobody else's.
TEST(Queue, best_effort_takes_back_a_block_that_a_record_names_twice) {
  const auto out = publisher(100, mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address()), other = idle_subscriber(out->address());
  for (int i = 0; i < 40; ++i) out->publish(text_record(std::string(60'000, 'x')));  // fills the sockets
  BufferPtr own = filled(*out->memory(), mb, 2);
  out->publish(text_record("b", {own, own}));
  EXPECT_FALSE(out->memory()->allocate(mb)) << "the program refers to it";
  own.reset();
  EXPECT_TRUE(out->memory()->allocate(mb));
}

TEST(Queue, a_block_that_a_record_names_twice_is_free_when_it_was_read_or_taken_back) {
  const auto out = publisher(1, mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address());
  for (unsigned char i = 0; i < 4; ++i) {
    BufferPtr own = filled(*out->memory(), mb, i);
    ASSERT_TRUE(own) << "round " << int{i};  // what was sent before was read, or is taken back now
    out->publish(text_record("b", {own, own}));
    own.reset();
    if (i % 2 != 0) continue;
    const MessagePtr message = in->read();
    ASSERT_EQ(message->blocks().size(), 2u);
    EXPECT_TRUE(all_bytes_are(message->blocks()[0], i) && all_bytes_are(message->blocks()[1], i));
    EXPECT_FALSE(out->memory()->allocate(mb)) << "it is held";
  }
  EXPECT_TRUE(out->memory()->allocate(mb));
  EXPECT_EQ(out->stats().dropped, 2u);
}

TEST(Queue, no_policy_ever_takes_back_what_a_subscriber_holds) {
  const auto out = publisher(10, 2 * mb, Policy::best_effort());
  const auto in = idle_subscriber(out->address());
  out->publish(text_record("a", {filled(*out->memory(), mb, 1)}));
  out->publish(text_record("b", {filled(*out->memory(), mb, 2)}));
  auto held = read_all(*in);
  ASSERT_EQ(held.size(), 2u);
  EXPECT_FALSE(out->memory()->allocate(mb));
  EXPECT_EQ(out->memory()->stats().refused, 1u);
  EXPECT_TRUE(all_bytes_are(held[1]->blocks()[0], 2));
  held.pop_back();
  EXPECT_TRUE(out->memory()->allocate(mb));
}

TEST(Queue, worst_effort_stops_at_the_oldest_message_in_use) {
  const auto out = publisher(10, 2 * mb, Policy::worst_effort());
  const auto in = idle_subscriber(out->address());
  out->publish(text_record("a", {filled(*out->memory(), mb, 1)}));
  out->publish(text_record("b", {filled(*out->memory(), mb, 2)}));
  auto held = read_all(*in);
  held.pop_back();  // the newer one is free, but the older one is in use
  EXPECT_FALSE(out->memory()->allocate(mb));
  held.clear();
  EXPECT_TRUE(out->memory()->allocate(mb));
}

// However many messages are kept: what is free behind them is found.
TEST(Queue, medium_effort_finds_what_is_free_behind_kept_messages) {
  for (const unsigned attempts : {0u, 2u, 64u}) {
    const auto out = publisher(0, 80 * 4096, Policy::medium_effort(attempts));
    const auto in = idle_subscriber(out->address());
    while (const BufferPtr buffer = filled(*out->memory(), 4000, 1)) out->publish(text_record("x", {buffer}));
    auto held = read_all(*in);
    ASSERT_GE(held.size(), 80u);
    for (int i = 0; i < 10; ++i) {
      EXPECT_FALSE(out->memory()->allocate(4000)) << attempts;
      held.erase(held.begin() + 70 - i);
      EXPECT_TRUE(out->memory()->allocate(4000))
          << "behind " << 70 - i << " kept ones, attempts " << attempts;
      held.push_back(nullptr);
      out->publish(text_record("y", {filled(*out->memory(), 4000, 2)}));
      held.back() = in->read();
      ASSERT_TRUE(held.back());
    }
  }
}

// A subscriber that keeps some messages of many does not make a segment grow.
TEST(Queue, kept_messages_do_not_make_the_memory_grow) {
  MemoryOptions memory;
  memory.ceiling = 64 * mb;
  PublisherOptions options;
  options.queue_size = 10;
  options.memory = *SegmentMemory::create(memory);
  const auto out = publish_with(std::move(options));
  const auto in = idle_subscriber(out->address());
  std::vector<MessagePtr> kept;
  for (int i = 0; i < 1000; ++i) {
    const BufferPtr buffer = filled(*out->memory(), 10'000, 1);
    ASSERT_TRUE(buffer) << i;
    out->publish(text_record("x", {buffer}));
    const MessagePtr message = in->read();
    ASSERT_TRUE(message);
    if (i < 65) kept.push_back(message);
  }
  EXPECT_LT(out->memory()->stats().size_bytes, 2 * mb);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
