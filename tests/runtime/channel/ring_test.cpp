// SPDX-License-Identifier: BSD-3-Clause
// The ring by itself, and records that take turns between it and the socket.
#include "channel/wire/ring.h"

#include <atomic>
#include <deque>

#include "channel/wire/shared_page.h"
#include "posix/mapping.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

/// Both ends of a ring, by hand.
struct Ends {
  bool write(std::uint32_t number) { return writer.write(&number, sizeof number, "!", 1); }
  std::uint32_t read() {
    std::uint8_t packet[slot_bytes] = {};
    if (reader.read(packet) != sizeof(std::uint32_t) + 1) return 0;
    std::uint32_t number = 0;
    std::memcpy(&number, packet, sizeof number);
    return number;
  }
  Source look() { return reader.await(ended, false); }

  Ring ring{};
  RingWriter writer{&ring};
  RingReader reader{&ring};
  std::atomic<bool> ended{false};
};

TEST(Ring, carries_packets_in_order_round_and_round) {
  Ends ends;
  for (std::uint32_t number = 1; number <= 10 * ring_slots; number += 3) {
    for (std::uint32_t i = 0; i < 3; ++i) ASSERT_TRUE(ends.write(number + i));
    for (std::uint32_t i = 0; i < 3; ++i) {
      ASSERT_EQ(ends.look(), Source::ring);
      EXPECT_EQ(ends.read(), number + i);
    }
    EXPECT_EQ(ends.look(), Source::nothing);
  }
}

TEST(Ring, leaves_to_the_socket_what_it_has_no_room_for) {
  Ends ends;
  const std::vector<std::uint8_t> bytes(slot_bytes, 7);
  EXPECT_FALSE(ends.writer.write("?", 1, bytes.data(), bytes.size()));
  EXPECT_TRUE(ends.writer.write("?", 1, bytes.data(), bytes.size() - 1));
  for (std::uint32_t i = 1; i < ring_slots; ++i) EXPECT_TRUE(ends.write(i));
  EXPECT_FALSE(ends.write(9)) << "full";
  ends.look();
  ends.read();
  EXPECT_TRUE(ends.write(9));
}

TEST(Ring, is_not_used_while_packets_wait_in_the_socket) {
  Ends ends;
  ends.writer.sent_packets(2);
  EXPECT_FALSE(ends.write(1));
  EXPECT_EQ(ends.look(), Source::socket);
  ends.reader.count_packet();
  EXPECT_FALSE(ends.write(1)) << "one more";
  EXPECT_EQ(ends.look(), Source::socket);
  ends.reader.count_packet();
  EXPECT_EQ(ends.look(), Source::nothing);
  EXPECT_TRUE(ends.write(1));
}

TEST(Ring, is_emptied_before_the_socket_is_read) {
  Ends ends;
  ends.write(1);
  ends.write(2);
  ends.writer.sent_packets(1);
  ends.ended = true;
  for (const std::uint32_t number : {1u, 2u}) {
    ASSERT_EQ(ends.look(), Source::ring);
    EXPECT_EQ(ends.read(), number);
  }
  EXPECT_EQ(ends.look(), Source::socket);
}

TEST(Ring, without_one_everything_is_in_the_socket) {
  RingWriter writer(nullptr);
  RingReader reader(nullptr);
  EXPECT_FALSE(writer.write("x", 1, "y", 1));
  EXPECT_EQ(reader.await(std::atomic<bool>(false), true), Source::socket);
}

TEST(Ring, forged_counts_and_sizes_are_noticed) {
  Ends ends;
  std::uint8_t packet[slot_bytes];
  ends.ring.publisher.written = ring_start + ring_slots + 1;
  ASSERT_EQ(ends.look(), Source::ring);
  EXPECT_EQ(ends.reader.read(packet), 0u);
  ends.ring.publisher.written = ring_start + 1;
  ends.ring.slots[ring_start % ring_slots].size = slot_bytes + 1;
  ASSERT_EQ(ends.look(), Source::ring);
  EXPECT_EQ(ends.reader.read(packet), 0u);
}

#ifndef TZC_PORTABLE

TEST(Ring, its_end_wakes_a_sleeper) {
  Ends ends;
  std::thread sleeper([&] { EXPECT_EQ(ends.reader.await(ends.ended, true), Source::socket); });
  EXPECT_TRUE(eventually([&] { return ends.ring.subscriber.sleeping == 1; }));
  ends.ended = true;
  wake_reader(ends.ring);
  sleeper.join();
}

// Every wake-up counts: one that is missed would stop the reader for good.
TEST(Ring, nobody_sleeps_through_a_packet) {
  Ends ends;
  constexpr std::uint32_t last = 200'000;
  std::mutex mutex;
  std::deque<std::uint32_t> socket;
  std::thread publisher([&] {
    std::uint32_t packets = 0;
    for (std::uint32_t number = 1; number <= last; ++number) {
      if (number % 1000 != 0 && ends.write(number)) continue;
      {
        const std::lock_guard<std::mutex> lock(mutex);
        socket.push_back(number);
      }
      ends.writer.sent_packets(++packets);
    }
  });
  std::uint32_t wrong = 0;
  for (std::uint32_t expected = 1; expected <= last; ++expected) {
    std::uint32_t number = 0;
    if (ends.reader.await(ends.ended, true) == Source::ring) {
      number = ends.read();
    } else {
      const std::lock_guard<std::mutex> lock(mutex);
      number = socket.front();
      socket.pop_front();
      ends.reader.count_packet();
    }
    wrong += number == expected ? 0 : 1;
  }
  publisher.join();
  EXPECT_EQ(wrong, 0u);
}

TEST(TwoWays, records_of_all_sizes_keep_their_order) {
  const auto out = publisher(0, 64 * mb);
  Inbox in(out->address());
  ASSERT_TRUE(in.subscriber) << in.error;
  constexpr std::size_t count = 3000;
  const std::size_t sizes[] = {10, 100, 600, 10, 10, 40'000};  // the ring, and the socket
  std::vector<std::size_t> sent;
  for (std::size_t i = 0; i < count; ++i) {
    sent.push_back(i % 20 == 0 ? 300'000 : sizes[i / 7 % 6]);  // in fragments
    std::string text = std::to_string(i) + ":";
    text.resize(sent.back(), '.');
    out->publish(i % 3 == 0 ? text_record(text, {filled(*out->memory(), 5000, 1)}) : text_record(text));
  }
  ASSERT_TRUE(in.wait_for(count)) << in.messages().size();
  const auto messages = in.messages();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = control_of(messages[i]);
    ASSERT_EQ(text.substr(0, text.find(':')), std::to_string(i));
    ASSERT_EQ(text.size(), sent[i]);
  }
}

/// A subscriber that asked for the ring; the test writes and reads its packets itself.
class ByHand : public ::testing::Test {
 protected:
  void SetUp() override {
    peer_.send(hello_to(out_->address(), reads_ring));
    ASSERT_EQ(peer_.receive(), posix::ReceiveResult::packet);
    mapping_ =
        std::move(*posix::Mapping::map(peer_.packet.descriptors[0].get(), 4096, posix::Access::read_write));
    ASSERT_TRUE(eventually([&] { return out_->connections().size() == 1; }));
  }
  Ring& ring() { return reinterpret_cast<ConnectionPage*>(mapping_.data())->ring; }
  Ring::Slot& first_slot() { return ring().slots[ring_start % ring_slots]; }
  std::uint32_t written() { return ring().publisher.written - ring_start; }
  std::uint32_t packets() { return ring().publisher.packets - ring_start; }

  std::shared_ptr<Publisher> out_ = publisher(20);
  RawPeer peer_ = RawPeer::connect(out_->address());
  posix::Mapping mapping_;
};

TEST_F(ByHand, a_usual_record_does_not_cross_the_socket) {
  out_->publish(text_record("hello"));
  EXPECT_EQ(written(), 1u);
  EXPECT_EQ(packets(), 0u);
  EXPECT_EQ(first_slot().size, sizeof(RecordPrefix) + sizeof(BodyHeader) + 5);
  EXPECT_EQ(out_->connections().front()->stats().bytes, first_slot().size);
}

TEST_F(ByHand, the_socket_is_used_until_its_packets_are_read) {
  out_->publish(text_record("block", {filled(*out_->memory(), 1000, 1)}));  // its segment's files come first
  EXPECT_EQ(packets(), 2u);
  out_->publish(text_record("next"));
  EXPECT_EQ(packets(), 3u);
  EXPECT_EQ(written(), 0u);
  ring().subscriber.packets_read = ring_start + 3;
  out_->publish(text_record("and the next"));
  EXPECT_EQ(packets(), 3u);
  EXPECT_EQ(written(), 1u);
}

TEST_F(ByHand, a_full_ring_overflows_into_the_socket_and_the_queue_holds) {
  for (int i = 0; i < 200; ++i) out_->publish(text_record(std::to_string(i)));
  EXPECT_EQ(written(), ring_slots);
  const ConnectionStats stats = out_->connections().front()->stats();
  EXPECT_EQ(stats.in_flight, 20u);
  EXPECT_EQ(stats.dropped, 180u);
}

TEST_F(ByHand, forged_words_hurt_only_the_forger) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    ring().subscriber.read = i * 0x01234567u;
    ring().subscriber.packets_read = ring_start + i % 3;
    ring().subscriber.sleeping = i;
    ring().publisher.written = ~i;
    out_->publish(text_record(std::to_string(i), {filled(*out_->memory(), 1000, 1)}));
  }
  Inbox in(out_->address());
  ASSERT_TRUE(in.subscriber) << in.error;
  ASSERT_TRUE(eventually([&] { return out_->connections().size() == 2; }));
  out_->publish(text_record("still here"));
  EXPECT_TRUE(in.wait_for(1));
}

TEST_F(ByHand, who_sleeps_is_woken) {
  std::atomic<bool> woken{false};
  RingReader reader(&ring());
  std::thread sleeper([&] {
    const std::atomic<bool> ended{false};
    EXPECT_EQ(reader.await(ended, true), Source::ring);
    woken = true;
  });
  EXPECT_TRUE(eventually([&] { return ring().subscriber.sleeping == 1; }));
  EXPECT_FALSE(woken);
  out_->publish(text_record("hello"));
  sleeper.join();
}

TEST_F(ByHand, who_sleeps_is_woken_when_the_connection_closes) {
  RingReader reader(&ring());
  const std::atomic<bool> ended{false};
  std::thread sleeper([&] { EXPECT_EQ(reader.await(ended, true), Source::socket); });
  EXPECT_TRUE(eventually([&] { return ring().subscriber.sleeping == 1; }));
  out_->connections().front()->close();
  sleeper.join();
  EXPECT_EQ(peer_.receive(), posix::ReceiveResult::closed);
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
