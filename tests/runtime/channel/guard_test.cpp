// SPDX-License-Identifier: BSD-3-Clause
// Guard mode: late writes are reported and reach no subscriber; programs that write in time get no report.
#include "tzc/guard.h"

#include <signal.h>

#include <cstring>

#include "guard_support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

TEST(Guard, is_on_in_this_program) {
  EXPECT_TRUE(guard::active);
}

TEST(Guard, says_nothing_about_a_program_that_writes_in_time_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    std::vector<MessagePtr> kept;
    for (unsigned char i = 1; i <= 100; ++i) {
      for (const std::size_t size : {10, 5000, 300'000}) {
        exchange.publish(size, i);
        kept.push_back(exchange.in->read());
        if (!all_bytes_are(kept.back()->blocks()[0], i)) return 1;
      }
      if (kept.size() > 12) kept.erase(kept.begin(), kept.begin() + 6);
    }
    return exchange.out->memory()->stats().refused == 0 ? 0 : 2;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status;
  EXPECT_EQ(outcome.errors, "");
}

TEST(Guard, a_late_write_on_a_thread_that_blocks_all_signals_is_reported_in_a_child) {
  const Outcome outcome = run([] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    const Exchange exchange;
    write_late(exchange.publish(5000, 1)->data(), 7);
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status;
  EXPECT_EQ(outcome.reports(), 1U) << outcome.errors;
}

TEST(Guard, a_late_write_is_reported_and_reaches_nobody_in_a_child) {
  for (const std::size_t size : {10, 4096, 300'000}) {
    const Outcome outcome = run([size] {
      const Exchange exchange;
      const auto second = idle_subscriber(exchange.out->address());
      exchange.publish(size, 1);
      const BufferPtr sent = exchange.publish(size, 2);
      MessagePtr before;
      exchange.in->read();
      before = exchange.in->read();
      write_late(sent->data(), 7);  // one subscriber has it, the other one takes it afterwards
      second->read();
      const MessagePtr after = second->read();
      for (const MessagePtr& message : {before, after})
        if (!message || !all_bytes_are(message->blocks()[0], 2)) return 1;
      return sent->data()[7] == 99 && sent->data()[8] == 2 ? 0 : 2;  // the writer sees what it wrote
    });
    EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status << outcome.errors;
    EXPECT_EQ(outcome.reports(), 1u) << outcome.errors;
    EXPECT_TRUE(outcome.says("topic /camera/image, message 2, byte 7 of")) << outcome.errors;
    EXPECT_TRUE(outcome.says("published here:") && outcome.says("written here:")) << outcome.errors;
    EXPECT_TRUE(outcome.says("guard_test(")) << outcome.errors;
  }
}

TEST(Guard, a_block_that_was_written_late_is_never_reused_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    std::uint8_t* stale = nullptr;
    {
      const BufferPtr sent = exchange.publish(mb, 1);
      exchange.in->read();
      stale = sent->data();
      write_late(stale, 0);
    }
    for (int i = 0; i < 300; ++i) {
      const BufferPtr next = exchange.publish(mb, 2);
      if (stale >= next->data() && stale < next->data() + next->size()) return 1;
      write_late(stale, 0);
      const MessagePtr message = exchange.in->read();
      if (!message || !all_bytes_are(message->blocks()[0], 2)) return 2;
    }
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status;
  EXPECT_EQ(outcome.reports(), 1u) << outcome.errors;
}

// Of 20 messages written late from one place, one report.
TEST(Guard, each_place_is_reported_once_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    for (int i = 0; i < 20; ++i) {
      const BufferPtr sent = exchange.publish(5000, 1);
      write_late(sent->data(), 3);
      const MessagePtr message = exchange.in->read();
      if (!message || !all_bytes_are(message->blocks()[0], 1)) return 1;
    }
    const BufferPtr sent = exchange.publish(5000, 1);
    write_late(sent->data(), 3);
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status;
  EXPECT_EQ(outcome.reports(), 2u) << outcome.errors;
}

TEST(Guard, an_access_to_a_block_that_no_message_has_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    std::uint8_t* const stale = exchange.publish(mb, 1)->data();
    exchange.in->read();
    for (int i = 0; i < 3; ++i) {
      exchange.publish(mb, 2);
      exchange.in->read();
    }
    return *static_cast<volatile std::uint8_t*>(stale) == 1 ? 0 : 1;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status << outcome.errors;
  EXPECT_TRUE(outcome.says("memory of a message that no message has any more") && outcome.says("message 1,"))
      << outcome.errors;
}

// 16 blocks are kept from reuse at least, where there is memory.
TEST(Guard, blocks_are_kept_from_reuse_for_a_while_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    const std::uint8_t* const first = exchange.publish(mb, 1)->data();
    exchange.in->read();
    int i = 0;
    for (; i < 100; ++i) {
      const BufferPtr next = exchange.publish(mb, 1);
      exchange.in->read();
      if (next->data() == first) break;
    }
    return i;
  });
  EXPECT_TRUE(WIFEXITED(outcome.status));
  EXPECT_GE(WEXITSTATUS(outcome.status), 16);
  EXPECT_LT(WEXITSTATUS(outcome.status), 30);
  EXPECT_EQ(outcome.reports(), 0u) << outcome.errors;
}

// What is kept from reuse gives way when memory is short: a program behaves as without guard mode.
TEST(Guard, refuses_no_memory_in_a_child) {
  const Outcome outcome = run([] {
    MemoryOptions options;
    options.size = 4 * mb;
    const auto memory = *SegmentMemory::create(options);
    for (int i = 0; i < 200; ++i) {
      BufferPtr buffers[4];
      for (BufferPtr& buffer : buffers) {
        buffer = filled(*memory, mb, 1);
        if (!buffer) return 1;
        buffer->seal();
      }
    }
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.errors;
}

TEST(Guard, several_threads_that_write_late_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    for (int round = 0; round < 50; ++round) {
      const BufferPtr sent = exchange.publish(mb, 1);
      std::vector<std::thread> threads;
      for (std::size_t i = 0; i < 4; ++i)
        threads.emplace_back([&, i] { std::memset(sent->data() + i * mb / 4, 5, mb / 4); });
      for (std::thread& thread : threads) thread.join();
      const MessagePtr message = exchange.in->read();
      if (!message || !all_bytes_are(message->blocks()[0], 1)) return 1;
      if (!all_bytes_are(ConstBlock{sent->data(), mb}, 5)) return 2;  // no thread lost what it wrote
    }
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status << outcome.errors;
  EXPECT_GE(outcome.reports(), 1u);
}

// A writer that does not stop: a subscriber never sees the bytes of one message change.
TEST(Guard, a_writer_that_races_with_subscribers_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    for (int round = 0; round < 100; ++round) {
      const BufferPtr buffer = filled(*exchange.out->memory(), 100'000, 1);
      std::atomic<bool> stop{false};
      std::thread writer([&] {
        for (unsigned char i = 0; !stop; ++i) std::memset(buffer->data(), i, 5000);
      });
      exchange.out->publish(text_record("x", {buffer}));
      const MessagePtr message = exchange.in->read();
      const std::string first(reinterpret_cast<const char*>(message->blocks()[0].data), 5000);
      std::this_thread::yield();
      const bool same = std::memcmp(message->blocks()[0].data, first.data(), 5000) == 0;
      stop = true;
      writer.join();
      if (!same || std::memcmp(message->blocks()[0].data, first.data(), 5000) != 0) return 1;
    }
    return 0;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status;
}

TEST(Guard, other_faults_end_the_process_as_ever_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    exchange.publish(mb, 1);
    *reinterpret_cast<volatile char*>(16) = 1;
    return 0;
  });
  EXPECT_FALSE(ended_with(outcome, 0));
  EXPECT_EQ(outcome.reports(), 0u);
}

TEST(Guard, heap_buffers_that_were_replaced_in_a_child) {
  const Outcome outcome = run([] {
    const auto memory = named_memory();
    for (const std::size_t size : {100, 4096, 200'000}) {
      auto* const old = static_cast<std::uint8_t*>(guard::allocate(size));
      if (old == nullptr) return 3;  // another operator new: nothing to test
      std::memset(old, 1, size);
      guard::retire(old, size, memory.get());
      write_late(old, size - 1);
      if (old[0] != 1 || old[size - 1] != 99) return 1;
    }
    for (int i = 0; i < 100; ++i) guard::retire(guard::allocate(10'000), 10'000, memory.get());
    std::vector<std::uint8_t>* const moved = new std::vector<std::uint8_t>(500'000, 1);
    guard::retire(moved->data(), 500'000,
                  memory.get());  // one that a vector made: its whole pages are watched
    write_late(moved->data(), 250'000);
    return 0;
  });
  // A sanitizer brings its own operator new, so guard mode finds none of the library's to watch; the plain build does.
  if (ended_with(outcome, 3)) GTEST_SKIP() << "this program's operator new is not the C++ library's";
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status << outcome.errors;
  EXPECT_EQ(outcome.reports(), 2u) << outcome.errors;
  EXPECT_TRUE(outcome.says("topic /camera/image") && outcome.says("moved here:")) << outcome.errors;
}

TEST(Guard, heap_buffers_that_were_sent_in_a_child) {
  const Outcome outcome = run([] {
    const auto memory = named_memory();
    auto* const elements = static_cast<std::uint8_t*>(guard::allocate(200'000));
    if (elements == nullptr) return 3;  // another operator new: nothing to test
    std::memset(elements, 1, 200'000);
    for (int round = 0; round < 10; ++round) {
      guard::freeze(elements, 200'000, memory.get());
      if (elements[100'000] != 1) return 1;
      if (round == 5) write_late(elements, 100'001);
      guard::thaw(elements);
      elements[50'000] = static_cast<std::uint8_t>(round);
    }
    guard::thaw(elements);
    return elements[50'000] == 9 && elements[100'001] == 99 ? 0 : 1;
  });
  // A sanitizer brings its own operator new, so guard mode finds none of the library's to watch; the plain build does.
  if (ended_with(outcome, 3)) GTEST_SKIP() << "this program's operator new is not the C++ library's";
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.status << outcome.errors;
  EXPECT_EQ(outcome.reports(), 1u) << outcome.errors;
  EXPECT_TRUE(outcome.says("topic /camera/image") && outcome.says("published here:")) << outcome.errors;
}

TEST(Guard, a_forked_child_writes_to_memory_of_its_own_in_a_child) {
  const Outcome outcome = run([] {
    const Exchange exchange;
    const BufferPtr sent = exchange.publish(mb, 1);
    const int status = exit_status(in_child([&] {
      write_late(sent->data(), 0);
      return 0;
    }));
    return status == 0 && all_bytes_are(exchange.in->read()->blocks()[0], 1) ? 0 : 1;
  });
  EXPECT_TRUE(ended_with(outcome, 0)) << outcome.errors;
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
