// SPDX-License-Identifier: BSD-3-Clause
// Code in a subscriber that writes to a received message changes its own copy, and nothing else.
#include <signal.h>
#include <sys/mman.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <future>

#ifdef __linux__
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

std::uint8_t* writable(const MessagePtr& message, std::size_t block = 0) {
  return const_cast<std::uint8_t*>(message->blocks()[block].data);
}

/// Publishes a block of 1 MB full of `value`.
BufferPtr publish_block(Publisher& out, unsigned char value) {
  BufferPtr buffer = filled(*out.memory(), mb, value);
  out.publish(text_record("x", {buffer}));
  return buffer;
}

int draw_and_look() {
  const auto out = publisher(10, 2 * mb);
  const auto in = idle_subscriber(out->address());
  for (unsigned char i = 1; i <= 20; ++i) {  // the same two blocks again and again
    const BufferPtr sent = publish_block(*out, i);
    const MessagePtr message = in->read();
    if (!message || !all_bytes_are(message->blocks()[0], i)) return 1;
    std::memset(writable(message) + 5000, 200, 300'000);
    if (writable(message)[5000] != 200 || writable(message)[4999] != i || writable(message)[305'000] != i)
      return 2;
    if (!all_bytes_are(ConstBlock{sent->data(), sent->size()}, i)) return 3;
  }
  return in->stats().written == 20 ? 0 : 4;
}

// AddressSanitizer reports the fault and exits instead.
bool ended_by_the_fault(int status) {
  return WIFSIGNALED(status) ? WTERMSIG(status) == SIGSEGV : WIFEXITED(status) && WEXITSTATUS(status) != 0;
}

TEST(PrivateWrites, change_nothing_but_the_message) {
  EXPECT_EQ(draw_and_look(), 0);
}

TEST(PrivateWrites, are_not_seen_by_other_subscribers) {
  const auto out = publisher();
  const auto draws = idle_subscriber(out->address()), reads = idle_subscriber(out->address());
  publish_block(*out, 1);
  const MessagePtr drawn = draws->read(), seen = reads->read();
  std::memset(writable(drawn), 2, mb);
  EXPECT_TRUE(all_bytes_are(seen->blocks()[0], 1));
  EXPECT_TRUE(all_bytes_are(drawn->blocks()[0], 2));
}

TEST(PrivateWrites, are_not_in_another_message_of_the_same_block) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  const BufferPtr buffer = filled(*out->memory(), mb, 1);
  for (int i = 0; i < 3; ++i) out->publish(text_record("x", {buffer}));
  MessagePtr first = in->read();
  std::memset(writable(first), 2, mb);
  const MessagePtr second = in->read();
  EXPECT_TRUE(all_bytes_are(second->blocks()[0], 1));
  std::memset(writable(second), 3, mb);
  EXPECT_TRUE(all_bytes_are(first->blocks()[0], 2));
  first.reset();
  EXPECT_TRUE(all_bytes_are(in->read()->blocks()[0], 1));
}

TEST(PrivateWrites, of_several_threads_at_once) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  for (int round = 0; round < 20; ++round) {
    publish_block(*out, 1);
    const MessagePtr message = in->read();
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&, i] { std::memset(writable(message) + i * (mb / 4), 10 + i, mb / 4); });
    for (std::thread& thread : threads) thread.join();
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(all_bytes_are(ConstBlock{writable(message) + i * (mb / 4), mb / 4}, 10 + i));
  }
}

void draw_on_a_thread_of_the_library(bool shared_thread) {
  const auto out = publisher();
  std::promise<bool> drawn;
  SubscriberOptions options;
  options.address = out->address();
  options.shared_thread = shared_thread;
  options.on_message = [&drawn](const MessagePtr& message) {
    std::memset(writable(message), 2, mb);
    drawn.set_value(all_bytes_are(message->blocks()[0], 2));
  };
  const auto in = Subscriber::create(std::move(options));
  ASSERT_TRUE(in) << in.error().text();
  const BufferPtr sent = publish_block(*out, 1);
  EXPECT_TRUE(drawn.get_future().get());
  EXPECT_TRUE(all_bytes_are(ConstBlock{sent->data(), sent->size()}, 1));
}

TEST(PrivateWrites, by_on_message_on_the_shared_thread) {
  draw_on_a_thread_of_the_library(true);
}

TEST(PrivateWrites, by_on_message_on_a_thread_of_its_own) {
  draw_on_a_thread_of_the_library(false);
}

TEST(PrivateWrites, on_a_thread_that_blocked_all_signals_before_it_read_in_a_child) {
  const pid_t child = in_child([] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    return draw_and_look();
  });
  EXPECT_EQ(exit_status(child), 0);
}

TEST(PrivateWrites, work_with_locked_memory_in_a_child) {
  const pid_t child =
      in_child([] { return ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? draw_and_look() : 5; });
  EXPECT_EQ(exit_status(child), 0);
}

TEST(PrivateWrites, of_a_forked_child_stay_its_own) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  publish_block(*out, 1);
  const MessagePtr message = in->read();
  const pid_t child = in_child([&] {
    std::memset(writable(message), 2, mb);
    return all_bytes_are(message->blocks()[0], 2) ? 0 : 1;
  });
  EXPECT_EQ(exit_status(child), 0);
  EXPECT_TRUE(all_bytes_are(message->blocks()[0], 1));
}

TEST(PrivateWrites, to_payloads_of_every_size) {
  const auto out = publisher(10, 2 * mb);
  const auto in = idle_subscriber(out->address()), reads = idle_subscriber(out->address());
  for (const std::size_t size : {1, 64, 100, 1000, 4095, 4096, 4097, 10'000}) {
    const BufferPtr sent = filled(*out->memory(), size, 1);
    const BufferPtr also = filled(*out->memory(), 30, 2);
    out->publish(text_record("x", {sent, also}));
    const MessagePtr drawn = in->read(), seen = reads->read();
    std::memset(writable(drawn), 200, drawn->blocks()[0].size);
    std::memset(writable(drawn, 1), 201, drawn->blocks()[1].size);
    for (const MessagePtr& message : {seen, drawn})
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(message->blocks()[1].data) % 64, 0u);
    EXPECT_TRUE(all_bytes_are(seen->blocks()[0], 1) && all_bytes_are(seen->blocks()[1], 2)) << size;
    EXPECT_TRUE(all_bytes_are(drawn->blocks()[0], 200) && all_bytes_are(drawn->blocks()[1], 201)) << size;
    EXPECT_TRUE(all_bytes_are(ConstBlock{sent->data(), sent->size()}, 1)) << size;
  }
}

TEST(PrivateWrites, by_a_system_call_fail_until_the_program_has_written) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "abcdefgh", 8), 8);
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  publish_block(*out, 1);
  const MessagePtr message = in->read();
  EXPECT_EQ(::read(ends[0], writable(message), 4), -1);
  EXPECT_EQ(errno, EFAULT);
  writable(message)[100] = 2;
  EXPECT_EQ(::read(ends[0], writable(message), 8), 8);
  EXPECT_EQ(std::memcmp(message->blocks()[0].data, "abcdefgh", 8), 0);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(PrivateWrites, are_told_once) {
  const auto out = publisher(10, 16 * mb);
  std::atomic<int> told{0};
  std::mutex mutex;
  std::vector<MessagePtr> kept;
  SubscriberOptions options;
  options.address = out->address();
  options.on_message = [&](const MessagePtr& message) {
    const std::lock_guard<std::mutex> lock(mutex);
    kept.push_back(message);
  };
  options.on_write = [&] { ++told; };
  auto in = *Subscriber::create(options);
  const auto received = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return kept;
  };
  for (unsigned char i = 1; i <= 3; ++i) publish_block(*out, i);
  ASSERT_TRUE(eventually([&] { return received().size() == 3; }));
  EXPECT_EQ(told, 0);
  for (const MessagePtr& message : received()) writable(message)[7] = 9;  // and no message comes afterwards
  EXPECT_TRUE(eventually([&] { return told == 1; }));
  publish_block(*out, 4);
  ASSERT_TRUE(eventually([&] { return received().size() == 4; }));
  writable(received()[3])[7] = 9;
  in.reset();
  EXPECT_EQ(told, 1);
}

#ifdef __linux__
/// From now on this thread's calls of `number` fail whose argument `index` is `value`.
bool forbid(int number, int index, std::uint32_t value, int error) {
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(number), 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offsetof(seccomp_data, args) +
                                                                    8 * static_cast<std::size_t>(index))),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog filter{6, program};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

int write_where_forbidden(int number, int index, std::uint32_t value, int error) {
  const auto out = publisher();
  if (!forbid(number, index, value, error)) return 77;
  const auto in = idle_subscriber(out->address());
  for (unsigned char i = 1; i <= 20; ++i) {
    const BufferPtr sent = publish_block(*out, i);
    const MessagePtr message = in->read();
    if (!message || !all_bytes_are(message->blocks()[0], i)) return 1;
    std::memset(writable(message), 200, mb);
    if (!all_bytes_are(ConstBlock{sent->data(), sent->size()}, i)) return 2;
  }
  return in->stats().copies_blocks ? 0 : 3;
}

TEST(PrivateWrites, are_copies_where_pages_cannot_be_made_writable_in_a_child) {
  EXPECT_EQ(exit_status(in_child(
                [] { return write_where_forbidden(SYS_mprotect, 2, PROT_READ | PROT_WRITE, EPERM); })),
            0);
}

TEST(PrivateWrites, are_copies_where_pages_cannot_be_dropped_in_a_child) {
  EXPECT_EQ(
      exit_status(in_child([] { return write_where_forbidden(SYS_madvise, 2, MADV_DONTNEED, EINVAL); })), 0);
}
#endif

TEST(PrivateWrites, leave_other_faults_to_the_system_in_a_child) {
  const pid_t child = in_child([] {
    const auto out = publisher();
    const auto in = idle_subscriber(out->address());
    publish_block(*out, 1);
    const MessagePtr message = in->read();
    std::memset(writable(message), 2, mb);
    const volatile std::uintptr_t nowhere = 16;  // the compiler must not know it
    *reinterpret_cast<volatile char*>(nowhere) = 1;
    return 0;
  });
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(ended_by_the_fault(status)) << status;
}

TEST(PrivateWrites, can_be_turned_off) {
  const pid_t child = in_child([] {
    const auto out = publisher();
    SubscriberOptions options;
    options.address = out->address();
    options.own_thread = false;
    options.private_writes = false;
    const auto in = *Subscriber::create(options);
    publish_block(*out, 1);
    const MessagePtr message = in->read();
    writable(message)[0] = 2;
    return 0;
  });
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(ended_by_the_fault(status)) << status;
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
