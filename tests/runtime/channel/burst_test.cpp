// SPDX-License-Identifier: BSD-3-Clause
// PublisherOptions::buffered_bytes: a burst that a TCP connection with a queue would deliver arrives as well.
#include <deque>
#include <random>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

/// A subscriber that takes messages promptly, but for its first one: from its coming to release() it takes no other.
class Held {
 public:
  explicit Held(const std::string& address) {
    SubscriberOptions options;
    options.address = address;
    options.shared_thread = true;
    options.on_message = [this](const MessagePtr& message) { take(message); };
    subscriber = *Subscriber::create(std::move(options));
  }
  ~Held() {
    release();
    subscriber.reset();
  }

  bool wait_for_first() {
    return eventually([this] { return taken() > 0; });
  }
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }
  std::size_t taken() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return taken_;
  }
  /// That of the last one, when it is `text`: then no other follows.
  bool wait_for(const std::string& text) {
    return eventually([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return last_ == text;
    });
  }

  std::shared_ptr<Subscriber> subscriber;

 private:
  void take(const MessagePtr& message) {
    std::unique_lock<std::mutex> lock(mutex_);
    ++taken_;
    last_ = control_of(message);
    changed_.wait(lock, [this] { return released_; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool released_ = false;
  std::size_t taken_ = 0;
  std::string last_;
};

/// How many messages of a burst a link of roscpp loses while nobody reads (roscpp's TransportSubscriberLink): a queue
/// that is cut to its size, a message that is being written, and the sockets' buffers.
class TcprosLink {
 public:
  TcprosLink(std::size_t queue_size, std::size_t socket_bytes)
      : queue_size_(queue_size), room_(socket_bytes) {}

  void publish(std::size_t bytes) {
    if (outbox_.size() >= queue_size_) {
      outbox_.pop_front();
      ++lost_;
    }
    outbox_.push_back(bytes);
    write();
  }
  std::size_t lost() const { return lost_; }

 private:
  void write() {
    while (writing_ > 0 || !outbox_.empty()) {
      if (writing_ == 0) {
        writing_ = outbox_.front();
        outbox_.pop_front();
      }
      const std::size_t part = std::min(writing_, room_);
      writing_ -= part;
      room_ -= part;
      if (writing_ > 0) return;
    }
  }

  const std::size_t queue_size_;
  std::size_t room_;
  std::deque<std::size_t> outbox_;
  std::size_t writing_ = 0;
  std::size_t lost_ = 0;
};

std::shared_ptr<Publisher> bursting(std::size_t queue_size, std::size_t buffered_bytes,
                                    MemoryOptions memory = MemoryOptions()) {
  PublisherOptions options;
  options.queue_size = queue_size;
  options.buffered_bytes = buffered_bytes;
  memory.queue_size = queue_size;
  options.memory = *SegmentMemory::create(memory);
  return publish_with(std::move(options));
}

struct Burst {
  std::size_t queue_size;
  std::vector<std::size_t> sizes;
};

Burst random_burst(std::mt19937& random, bool mixed) {
  const auto up_to = [&random](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(random);
  };
  Burst burst{1 + up_to(up_to(20)), {}};
  const std::size_t usual = (std::size_t{1024} << up_to(11)) + up_to(1024);
  const std::size_t total = up_to(16 * mb);
  for (std::size_t sum = 0; sum < total; sum += burst.sizes.back()) {
    const std::size_t other = up_to(9) == 0 ? 1024 + up_to(3 * mb) : usual + up_to(usual);
    burst.sizes.push_back(mixed ? other : usual);
  }
  return burst;
}

std::size_t lost_by_roscpp(const Burst& burst) {
  TcprosLink link(burst.queue_size, 4200000);
  for (const std::size_t bytes : burst.sizes) link.publish(bytes);
  return link.lost();
}

std::size_t lost_of(const Burst& burst) {
  const auto out = bursting(burst.queue_size, 9 * mb);  // as roscpp/publish/socket_buffers.h has it
  Held in(out->address());
  out->publish(text_record("first"));
  EXPECT_TRUE(in.wait_for_first());
  for (std::size_t i = 0; i < burst.sizes.size(); ++i) {
    const BufferPtr buffer = out->memory()->allocate(burst.sizes[i]);
    EXPECT_TRUE(buffer);
    EXPECT_EQ(out->publish(text_record(std::to_string(i), {buffer})), 1u);
  }
  in.release();
  if (!burst.sizes.empty()) {
    EXPECT_TRUE(in.wait_for(std::to_string(burst.sizes.size() - 1)));
  }
  const std::size_t lost = burst.sizes.size() + 1 - in.taken();
  EXPECT_EQ(in.subscriber->stats().lost, lost);
  EXPECT_EQ(out->stats().dropped, lost);
  return lost;
}

TEST(Burst, arrives_whole_where_a_link_of_roscpp_delivers_it_whole) {
  std::mt19937 random(20261122);
  std::size_t whole = 0;
  for (int i = 0; i < 200; ++i) {
    const Burst burst = random_burst(random, i % 2 == 0);
    if (lost_by_roscpp(burst) > 0) continue;
    ASSERT_EQ(lost_of(burst), 0u) << "burst " << i << " of " << burst.sizes.size() << ", queue "
                                  << burst.queue_size;
    ++whole;
  }
  EXPECT_GT(whole, 50u);
}

// Which ones differs: roscpp keeps what its sockets took first, a channel the newest. So one message that is larger than the
// others may cost several of them; with messages of one size fewer are lost.
TEST(Burst, of_one_size_loses_no_more_than_a_link_of_roscpp) {
  std::mt19937 random(20261122);
  std::size_t cut = 0;
  for (int i = 0; i < 100; ++i) {
    const Burst burst = random_burst(random, false);
    const std::size_t lost = lost_by_roscpp(burst);
    if (lost == 0) continue;
    ASSERT_LE(lost_of(burst), lost) << "burst " << i << " of " << burst.sizes.size() << ", queue "
                                    << burst.queue_size;
    ++cut;
  }
  EXPECT_GT(cut, 20u);
}

TEST(Burst, what_is_in_flight_is_bounded) {
  const auto out = bursting(3, 6 * mb);
  Held in(out->address());
  out->publish(text_record("first"));
  ASSERT_TRUE(in.wait_for_first());
  const ConnectionPtr connection = out->connections()[0];
  for (int i = 0; i < 20; ++i) out->publish(text_record("x", {filled(*out->memory(), mb, 1)}));
  EXPECT_EQ(connection->in_flight(), 3u + 1 + 5);  // 5: a sixth has more than 6 MB with what counts for each
  for (int i = 0; i < 40000; ++i) out->publish(text_record("small"));
  EXPECT_LE(connection->in_flight(), 6 * mb / 256);
  EXPECT_GT(connection->in_flight(), 15000u);
  out->publish(text_record("last"));
  in.release();
  EXPECT_TRUE(in.wait_for("last"));
}

TEST(Burst, without_a_queue_size_what_the_protocol_can_count_is_in_flight) {
  const auto out = bursting(0, 9 * mb);
  Held in(out->address());
  out->publish(text_record("first"));
  ASSERT_TRUE(in.wait_for_first());
  for (int i = 0; i < 65600; ++i) out->publish(text_record("x"));
  EXPECT_EQ(out->connections()[0]->in_flight(), 65535u);
}

TEST(Burst, memory_that_is_needed_comes_from_beyond_the_queue) {
  for (const Policy policy : {Policy::worst_effort(), Policy::medium_effort(), Policy::best_effort()}) {
    MemoryOptions memory;
    memory.size = 4 * mb;
    memory.policy = policy;
    const auto out = bursting(2, 64 * mb, memory);
    Held in(out->address());
    out->publish(text_record("first"));
    ASSERT_TRUE(in.wait_for_first());
    for (int i = 0; i < 50; ++i) {
      const BufferPtr buffer = filled(*out->memory(), mb, 1);
      ASSERT_TRUE(buffer) << i;
      EXPECT_EQ(out->publish(text_record(std::to_string(i), {buffer})), 1u);
    }
    in.release();
    EXPECT_TRUE(in.wait_for("49"));
    EXPECT_GE(in.taken(), 3u);  // the first, and the queue
  }
}

TEST(Burst, a_subscriber_that_may_be_slow_keeps_the_newest) {
  const auto out = bursting(2, 6 * mb);
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 10; ++i) out->publish(text_record(std::to_string(i)));
  EXPECT_EQ(control_of(in->read()), "8");
  EXPECT_EQ(control_of(in->read()), "9");
  EXPECT_FALSE(in->read());
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
