// SPDX-License-Identifier: BSD-3-Clause
// A forked child goes on to read what its parent held when it called fork(), and its parent gives it back all the same.
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>

#include <atomic>
#include <cerrno>
#include <memory>
#include <string>
#include <utility>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

std::atomic<bool> child_dies_at_fork{false}, child_stops_at_fork{false};

// As the program starts, so before those of the library, whose part in the child comes later therefore.
[[maybe_unused]] const int registered = ::pthread_atfork(nullptr, nullptr, [] {
  if (child_dies_at_fork) ::raise(SIGKILL);
  if (child_stops_at_fork) ::raise(SIGSTOP);
});

/// A line on which the parent lets its child go on.
class Whistle {
 public:
  Whistle() { EXPECT_EQ(::pipe(ends_), 0); }
  ~Whistle() {
    for (const int end : ends_) ::close(end);
  }
  void blow() const { EXPECT_EQ(::write(ends_[1], "!", 1), 1); }
  bool await() const {
    char heard = 0;
    return ::read(ends_[0], &heard, 1) == 1;
  }

 private:
  int ends_[2] = {-1, -1};
};

/// Publishes a block of 1 MB; where it lies in the publisher's memory.
const std::uint8_t* publish_in_place(Publisher& out, unsigned char value) {
  const BufferPtr buffer = filled(*out.memory(), mb, value);
  out.publish(text_record("x", {buffer}));
  return buffer->data();
}

/// A child that reads the message once the parent has let go of it and its memory is used again.
template <class Prepare>
void read_in_child_afterwards(Prepare prepare, unsigned char seen) {
  const auto out = publisher(10, 4 * mb);
  const auto in = idle_subscriber(out->address());
  const Whistle whistle;
  const std::uint8_t* const place = publish_in_place(*out, 1);
  MessagePtr message = in->read();
  prepare(message);
  const pid_t child = in_child([&] {
    const ConstBlock block = message->blocks()[0];
    return whistle.await() && block.data[0] == seen && all_bytes_are({block.data + 4096, mb - 4096}, 1) ? 0
                                                                                                        : 1;
  });
  message.reset();
  for (unsigned char value = 2; value < 5; ++value) {
    EXPECT_EQ(publish_in_place(*out, value), place) << "the child keeps the memory from the publisher";
    EXPECT_TRUE(all_bytes_are(in->read()->blocks()[0], value));
  }
  whistle.blow();
  EXPECT_EQ(exit_status(child), 0);
}

TEST(ForkedReading, goes_on_when_the_parent_has_let_go) {
  read_in_child_afterwards([](const MessagePtr&) {}, 1);
}

TEST(ForkedReading, goes_on_also_where_a_part_was_written_to) {
  read_in_child_afterwards(
      [](const MessagePtr& message) { *const_cast<std::uint8_t*>(message->blocks()[0].data) = 9; }, 9);
}

TEST(ForkedReading, goes_on_in_a_childs_child) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  const Whistle whistle;
  publish_in_place(*out, 1);
  MessagePtr message = in->read();
  const pid_t child = in_child([&] {
    return exit_status(
        in_child([&] { return whistle.await() && all_bytes_are(message->blocks()[0], 1) ? 0 : 1; }));
  });
  message.reset();
  publish_in_place(*out, 2);
  whistle.blow();
  EXPECT_EQ(exit_status(child), 0);
}

TEST(ForkedReading, of_messages_that_come_and_go_on_another_thread) {
  const auto out = publisher(10, 4 * mb);
  const auto in = idle_subscriber(out->address()), other = idle_subscriber(out->address());
  std::atomic<bool> stop{false};
  std::thread others([&] {
    for (unsigned char value = 0; !stop; ++value) {
      publish_in_place(*out, value);
      other->read();
      in->read();
    }
  });
  MessagePtr message;
  for (int round = 0; round < 20; ++round) {
    const auto own = publisher();
    const auto own_in = idle_subscriber(own->address());
    publish_in_place(*own, 1);
    message = own_in->read();
    EXPECT_EQ(exit_status(in_child([&] { return all_bytes_are(message->blocks()[0], 1) ? 0 : 1; })), 0);
  }
  stop = true;
  others.join();
  EXPECT_TRUE(eventually([&] { return out->memory()->allocate(3 * mb) != nullptr; }));
}

TEST(ForkedReading, a_child_that_is_killed_at_once_keeps_nothing) {
  const auto out = publisher(10, 4 * mb);
  const auto in = idle_subscriber(out->address());
  const std::uint8_t* const place = publish_in_place(*out, 1);
  MessagePtr message = in->read();
  child_dies_at_fork = true;
  const pid_t child = in_child([] { return 0; });
  child_dies_at_fork = false;
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  message.reset();
  EXPECT_EQ(publish_in_place(*out, 2), place);
}

int fork_that_fails() {
  const auto out = publisher(10, 4 * mb);
  const auto in = idle_subscriber(out->address());
  const std::uint8_t* const place = publish_in_place(*out, 1);
  MessagePtr message = in->read();
  const rlimit none{0, 0};
  if (::setrlimit(RLIMIT_NPROC, &none) != 0) return 1;
  if (::geteuid() == 0 && ::setuid(65534) != 0) return 2;  // root may have more
  if (::fork() != -1 || errno != EAGAIN) return 3;
  message.reset();
  return publish_in_place(*out, 2) == place ? 0 : 4;
}

TEST(ForkedReading, a_fork_that_fails_keeps_nothing_in_a_child) {
  EXPECT_EQ(exit_status(in_child(fork_that_fails)), 0);
}

/// What a process of its own says when it forks twice with a message in its hands, under a limit or with a child that stops.
template <class Prepare>
void expect_to_say_once(const std::string& cause, Prepare prepare) {
  const pid_t process = in_child([&] {
    const auto out = publisher(10, 4 * mb);
    const auto in = idle_subscriber(out->address());
    publish_in_place(*out, 1);
    const MessagePtr message = in->read();
    ::testing::internal::CaptureStderr();
    pid_t children[2] = {};
    for (pid_t& child : children) {
      [[maybe_unused]] const auto limited = prepare();
      child = in_child([] { return 0; });
    }
    for (const pid_t child : children) {
      ::kill(child, SIGCONT);
      ::waitpid(child, nullptr, 0);
    }
    const std::string said = ::testing::internal::GetCapturedStderr();
    const std::size_t first = said.find(cause);
    return first != std::string::npos &&
                   said.find("may see later messages") == said.rfind("may see later messages")
               ? 0
               : 1;
  });
  EXPECT_EQ(exit_status(process), 0) << cause;
}

/// This process gets no more of it until the end.
class Limited {
 public:
  Limited(decltype(RLIMIT_DATA) resource, rlim_t most) : resource_(resource) {
    ::getrlimit(resource_, &before_);
    const rlimit few{most, before_.rlim_max};
    ::setrlimit(resource_, &few);
  }
  ~Limited() { ::setrlimit(resource_, &before_); }
  Limited(const Limited&) = delete;
  Limited& operator=(const Limited&) = delete;

 private:
  const decltype(RLIMIT_DATA) resource_;
  rlimit before_{};
};

TEST(ForkedReading, says_once_that_a_forked_child_gets_no_memory) {
  expect_to_say_once("memory for copies", [] { return std::make_unique<Limited>(RLIMIT_DATA, 4096); });
}

TEST(ForkedReading, says_once_that_there_are_no_descriptors_for_a_forked_childs_report) {
  expect_to_say_once("no descriptors", [] { return std::make_unique<Limited>(RLIMIT_NOFILE, 0); });
}

TEST(ForkedReading, says_once_that_a_forked_child_was_stopped) {
  expect_to_say_once("five seconds", [first = true]() mutable {
    child_stops_at_fork = std::exchange(first, false);
    return 0;
  });
}

TEST(ForkedReading, says_nothing_of_a_child_that_has_its_copies_or_is_killed) {
  const auto out = publisher();
  const auto in = idle_subscriber(out->address());
  publish_in_place(*out, 1);
  const MessagePtr message = in->read();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(exit_status(in_child([] { return 0; })), 0);
  child_dies_at_fork = true;
  ::waitpid(in_child([] { return 0; }), nullptr, 0);
  child_dies_at_fork = false;
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(ForkedReading, of_a_view_in_the_publishers_own_process) {
  const auto memory = memory_of(4 * mb);
  BufferPtr buffer = filled(*memory, mb, 1);
  const std::uint8_t* const place = buffer->data();
  BufferViews views = view_for_callbacks({buffer});
  const Whistle whistle;
  const pid_t child = in_child([&] { return whistle.await() && all_bytes_are(views.blocks[0], 1) ? 0 : 1; });
  views = BufferViews();
  buffer.reset();
  EXPECT_EQ(filled(*memory, mb, 2)->data(), place);
  whistle.blow();
  EXPECT_EQ(exit_status(child), 0);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
