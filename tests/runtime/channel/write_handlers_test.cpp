// SPDX-License-Identifier: BSD-3-Clause
// The handler of writes to received messages works beside those of other code, whenever they are installed.
#include <setjmp.h>
#include <signal.h>
#include <sys/mman.h>

#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

std::uint8_t* whole(const MessagePtr& message) {
  return const_cast<std::uint8_t*>(message->blocks()[0].data);
}

sigjmp_buf elsewhere;
std::string heard;

/// A crash handler as programs have them: notes that it ran, then calls the one that was there before, or jumps away.
template <char name>
struct Handler {
  static inline struct sigaction before;

  static void install() {
    struct sigaction action{};
    action.sa_sigaction = [](int number, siginfo_t* info, void* context) {
      heard += name;
      if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(number, info, context);
      siglongjmp(elsewhere, 1);
    };
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
    ::sigaction(SIGSEGV, &action, &before);
  }
};

struct Exchange {
  std::shared_ptr<Publisher> out = publisher();
  std::shared_ptr<Subscriber> in = idle_subscriber(out->address());

  MessagePtr next() const {
    out->publish(text_record("x", {filled(*out->memory(), mb, 1)}));
    return in->read();
  }
  /// A write to the next message works.
  bool write() const {
    const MessagePtr message = next();
    std::memset(whole(message), 3, mb);
    return all_bytes_are(message->blocks()[0], 3);
  }
};

/// The handlers that get a fault that is not in a message, in order.
std::string who_hears() {
  auto* none =
      static_cast<volatile char*>(::mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  heard.clear();
  if (sigsetjmp(elsewhere, 1) == 0) *none = 1;
  return heard;
}

#define EXPECT_IN_CHILD(condition)                                                  \
  do {                                                                              \
    if (!(condition)) return std::fprintf(stderr, "not true: %s\n", #condition), 1; \
  } while (false)

int earlier_handler() {
  Handler<'a'>::install();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  EXPECT_IN_CHILD(who_hears() == "a" && who_hears() == "a");
  EXPECT_IN_CHILD(exchange.write());
  return 0;
}

int later_handler() {
  Handler<'a'>::install();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  Handler<'b'>::install();  // no segment arrives afterwards, only a message
  EXPECT_IN_CHILD(exchange.write());
  for (int i = 0; i < 3; ++i) EXPECT_IN_CHILD(who_hears() == "ba");
  EXPECT_IN_CHILD(exchange.write());
  return 0;
}

int several_later_handlers() {
  Handler<'a'>::install();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  Handler<'b'>::install();
  EXPECT_IN_CHILD(exchange.write());
  Handler<'c'>::install();
  EXPECT_IN_CHILD(exchange.write());
  for (int i = 0; i < 3; ++i) EXPECT_IN_CHILD(who_hears() == "cba");
  ::signal(SIGSEGV, [](int) {
    heard += "d";
    siglongjmp(elsewhere, 1);
  });
  EXPECT_IN_CHILD(exchange.write());
  EXPECT_IN_CHILD(who_hears() == "d" && who_hears() == "d");
  EXPECT_IN_CHILD(exchange.write());
  return 0;
}

// A program that installs its handler again and again, above ours.
int insisting_handler() {
  const auto action = [](int) {
    heard += "i";
    siglongjmp(elsewhere, 1);
  };
  const Exchange exchange;
  for (int i = 0; i < 50; ++i) {
    ::signal(SIGSEGV, action);
    EXPECT_IN_CHILD(exchange.write());
    EXPECT_IN_CHILD(who_hears() == "i");
  }
  return 0;
}

/// The handlers of earlier tests are none of this one's.
pid_t in_fresh_child(int (*test)()) {
  return in_child([test] {
    ::signal(SIGSEGV, SIG_DFL);
    return test();
  });
}

// AddressSanitizer reports the fault and exits instead.
bool ended_by(int status, int signal) {
  return WIFSIGNALED(status) ? WTERMSIG(status) == signal : WIFEXITED(status) && WEXITSTATUS(status) != 0;
}

TEST(WriteHandlers, earlier_ones_hear_of_other_faults_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(earlier_handler)), 0);
}
TEST(WriteHandlers, later_ones_are_found_with_the_next_message_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(later_handler)), 0);
}
TEST(WriteHandlers, several_later_ones_hear_in_turn_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(several_later_handlers)), 0);
}
TEST(WriteHandlers, one_that_insists_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(insisting_handler)), 0);
}

TEST(WriteHandlers, a_signal_that_was_sent_still_ends_the_process_in_a_child) {
  const pid_t child = in_child([] {
    const Exchange exchange;
    if (!exchange.write()) return 1;
    ::raise(SIGSEGV);
    return 0;
  });
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(ended_by(status, SIGSEGV)) << status;
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
