// SPDX-License-Identifier: BSD-3-Clause
// What a subscriber had not taken when it went comes back to the publisher: each record either here or there.
#include <atomic>
#include <thread>

#include "support.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

/// A publisher that keeps what was not delivered, and the connection that ended last.
class Keeper {
 public:
  explicit Keeper(std::size_t queue_size, std::size_t memory_size = 16 * mb, Policy policy = Policy()) {
    PublisherOptions options;
    options.queue_size = queue_size;
    options.memory = memory_of(memory_size, policy);
    options.keeps_undelivered = true;
    options.on_disconnect = [this](const ConnectionPtr& connection) {
      const std::lock_guard<std::mutex> lock(mutex_);
      undelivered_ = connection->take_undelivered();
      has_ended_ = true;
    };
    out = publish_with(std::move(options));
  }
  ~Keeper() { out.reset(); }

  std::size_t publish(const std::string& text, std::size_t bytes = 0) {
    std::vector<BufferPtr> buffers;
    if (bytes > 0) buffers.push_back(filled(*out->memory(), bytes, static_cast<unsigned char>(text[0])));
    return out->publish(text_record(text, buffers));
  }
  void forget() { undelivered_.clear(); }
  bool has_ended() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return has_ended_;
  }
  std::vector<RecordPtr> undelivered() {
    EXPECT_TRUE(eventually([&] { return has_ended(); }));
    return undelivered_;
  }
  std::vector<std::string> undelivered_texts() {
    std::vector<std::string> texts;
    for (const RecordPtr& record : undelivered()) {
      const RecordParts parts = parts_of(*record);
      EXPECT_EQ(parts.tag, 7u);
      texts.emplace_back(reinterpret_cast<const char*>(parts.control), parts.control_size);
    }
    return texts;
  }

  std::shared_ptr<Publisher> out;

 private:
  std::mutex mutex_;
  std::vector<RecordPtr> undelivered_;
  bool has_ended_ = false;
};

using Texts = std::vector<std::string>;

TEST(Undelivered, what_was_not_taken_comes_back_in_order) {
  Keeper keeper(10);
  auto in = idle_subscriber(keeper.out->address());
  for (const char* text : {"a", "b", "c", "d"}) keeper.publish(text, 5000);
  ASSERT_EQ(control_of(in->read()), "a");
  in.reset();
  EXPECT_EQ(keeper.undelivered_texts(), (Texts{"b", "c", "d"}));
}

/// Stops the allocator after it has seen that a block has no handles, until the record has come back; but not for
/// longer than a moment, because the allocator may rightly keep others waiting meanwhile.
struct Stop {
  static inline std::atomic<bool> reached{false}, may_go{false};
  static void at(const char* name) {
    if (std::strcmp(name, "allocate: no handles") != 0 || reached.exchange(true)) return;
    eventually([] { return may_go.load(); }, 300);
  }
};

TEST(Undelivered, a_block_that_comes_back_is_not_allocated_again) {
  Keeper keeper(10, mb);
  auto in = idle_subscriber(keeper.out->address());
  keeper.publish("k", mb);
  sync_point_hook = Stop::at;
  BufferPtr again;
  std::thread allocator([&] { again = keeper.out->memory()->allocate(mb); });
  ASSERT_TRUE(eventually([] { return Stop::reached.load(); }));
  in.reset();
  eventually([&] { return keeper.has_ended(); }, 200);
  Stop::may_go = true;
  allocator.join();
  sync_point_hook = nullptr;
  ASSERT_EQ(keeper.undelivered().size(), 1u);
  EXPECT_FALSE(again) << "the block has a handle, and was handed out again";
}

TEST(Undelivered, its_blocks_are_intact_under_pressure) {
  Keeper keeper(10, mb, Policy::best_effort());
  auto in = idle_subscriber(keeper.out->address());
  keeper.publish("k", mb / 2);
  in.reset();
  const std::vector<RecordPtr> undelivered = keeper.undelivered();
  ASSERT_EQ(undelivered.size(), 1u);
  EXPECT_FALSE(keeper.out->memory()->allocate(mb));
  const RecordParts parts = parts_of(*undelivered[0]);
  ASSERT_EQ(parts.blocks.size(), 1u);
  EXPECT_GE(parts.blocks[0].size, mb / 2);
  EXPECT_TRUE(all_bytes_are(parts.blocks[0], 'k'));
}

TEST(Undelivered, memory_is_free_once_it_is_forgotten) {
  Keeper keeper(10, mb);
  auto in = idle_subscriber(keeper.out->address());
  keeper.publish("k", mb);
  in.reset();
  ASSERT_EQ(keeper.undelivered().size(), 1u);
  EXPECT_FALSE(keeper.out->memory()->allocate(mb));
  keeper.forget();
  EXPECT_TRUE(keeper.out->memory()->allocate(mb));
}

TEST(Undelivered, what_the_queue_revoked_is_gone) {
  Keeper keeper(2);
  auto in = idle_subscriber(keeper.out->address());
  for (const char* text : {"a", "b", "c", "d"}) keeper.publish(text);
  in.reset();
  EXPECT_EQ(keeper.undelivered_texts(), (Texts{"c", "d"}));
}

TEST(Undelivered, a_large_control_part_comes_back_too) {
  Keeper keeper(10);
  auto in = idle_subscriber(keeper.out->address());
  const std::string large(300000, 'x');
  keeper.out->publish(make_record(7, large.data(), large.size(), {}, keeper.out->memory().get()));
  keeper.out->publish(make_record(7, large.data(), large.size()));  // as fragments
  in.reset();
  EXPECT_EQ(keeper.undelivered_texts(), (Texts{large, large}));
}

// However the end falls among the records, nothing is lost and nothing arrives twice.
TEST(Undelivered, each_record_is_either_taken_or_back) {
  for (int round = 0; round < 100; ++round) {
    Keeper keeper(1000);
    auto in = idle_subscriber(keeper.out->address());
    std::atomic<bool> leaves{false};
    std::size_t taken = 0, accepted = 0;
    std::thread reader([&] {
      while (!leaves) taken += in->read() != nullptr;
      in.reset();
    });
    for (int i = 0; i < 300; ++i) {
      accepted += keeper.publish("r");
      if (i == round) leaves = true;
    }
    reader.join();
    ASSERT_EQ(taken + keeper.undelivered().size(), accepted) << "round " << round;
  }
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
