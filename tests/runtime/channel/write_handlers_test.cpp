// SPDX-License-Identifier: BSD-3-Clause
// The handler of writes to received messages works beside those of other code, whenever they are installed.
#include <setjmp.h>
#include <signal.h>
#include <sys/mman.h>

#include <atomic>

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

  static void install(int more_flags = 0) {
    struct sigaction action{};
    action.sa_sigaction = [](int number, siginfo_t* info, void* context) {
      heard += name;
      if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(number, info, context);
      siglongjmp(elsewhere, 1);
    };
    action.sa_flags = SA_SIGINFO | SA_NODEFER | more_flags;
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

volatile char* read_only_page() {
  return static_cast<volatile char*>(::mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
}

/// The handlers that get a fault that is not in a message, in order.
std::string who_hears() {
  volatile char* const none = read_only_page();
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

int earlier_handler_of_one_call_called_by_a_later_one() {
  Handler<'a'>::install(SA_RESETHAND);
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  Handler<'b'>::install();
  EXPECT_IN_CHILD(exchange.write());
  for (int i = 0; i < 3; ++i) EXPECT_IN_CHILD(who_hears() == "ba");
  return 0;
}

volatile char* forbidden = nullptr;  // where the program faults
std::atomic<int> calls{0};

// The kernel calls these handlers once, so a second call is told by the exit status.
void count_call() {
  if (++calls > 1) ::_exit(2);
}

void install(void (*handler)(int), int flags) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaddset(&action.sa_mask, SIGUSR1);
  ::sigaction(SIGSEGV, &action, nullptr);
}

bool is_blocked(int signal) {
  sigset_t now;
  pthread_sigmask(SIG_BLOCK, nullptr, &now);
  return sigismember(&now, signal) == 1;
}

int fault_with(void (*handler)(int), int flags) {
  install(handler, flags);
  forbidden = read_only_page();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  *forbidden = 1;
  return 1;
}

int one_call_that_returns() {
  return fault_with([](int) { count_call(); }, SA_RESETHAND);
}

int one_call_that_raises_at_once() {
  return fault_with(
      [](int number) {
        count_call();
        ::raise(number);
        ::_exit(3);
      },
      SA_RESETHAND | SA_NODEFER);
}

// The signal is blocked until the handler returns.
int one_call_that_raises() {
  return fault_with(
      [](int number) {
        count_call();
        ::raise(number);
      },
      SA_RESETHAND);
}

int fault_in_the_handler() {
  return fault_with(
      [](int) {
        count_call();
        *forbidden = 2;
        ::_exit(3);
      },
      0);
}

int handler_of_one_call_installed_again() {
  const auto jump = [](int) {
    heard += "j";
    siglongjmp(elsewhere, 1);
  };
  install(jump, SA_RESETHAND);
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  EXPECT_IN_CHILD(who_hears() == "j");
  install(jump, SA_RESETHAND);
  EXPECT_IN_CHILD(exchange.write());
  EXPECT_IN_CHILD(who_hears() == "j");
  EXPECT_IN_CHILD(exchange.write());
  who_hears();
  return 1;
}

struct sigaction found_before;

// As crash handlers do that let their predecessor report, or the system: the fault happens again.
int handler_that_puts_back_what_it_found() {
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  forbidden = read_only_page();
  ::sigaction(SIGSEGV, nullptr, &found_before);
  install(
      [](int) {
        count_call();
        ::sigaction(SIGSEGV, &found_before, nullptr);
      },
      SA_NODEFER);
  EXPECT_IN_CHILD(exchange.write());
  *forbidden = 1;
  return 1;
}

int handler_that_is_taken_back() {
  Handler<'a'>::install();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  Handler<'b'>::install();
  EXPECT_IN_CHILD(exchange.write() && who_hears() == "ba");
  ::sigaction(SIGSEGV, &Handler<'b'>::before, nullptr);
  EXPECT_IN_CHILD(who_hears() == "a");
  EXPECT_IN_CHILD(exchange.write() && who_hears() == "a");
  Handler<'c'>::install();
  EXPECT_IN_CHILD(who_hears() == "ca");
  EXPECT_IN_CHILD(exchange.write() && who_hears() == "ca");
  return 0;
}

template <int flags>
int mask_in_the_handler() {
  static bool is_as_asked = false;
  install(
      [](int) {
        is_as_asked = is_blocked(SIGUSR1) && is_blocked(SIGSEGV) == (flags == 0) && !is_blocked(SIGUSR2);
        ::mprotect(const_cast<char*>(forbidden), 4096, PROT_READ | PROT_WRITE);
      },
      flags);
  forbidden = read_only_page();
  const Exchange exchange;
  EXPECT_IN_CHILD(exchange.write());
  *forbidden = 1;
  EXPECT_IN_CHILD(is_as_asked && *forbidden == 1);
  EXPECT_IN_CHILD(!is_blocked(SIGUSR1) && !is_blocked(SIGSEGV));
  EXPECT_IN_CHILD(exchange.write());
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

TEST(WriteHandlers, one_of_one_call_is_not_reset_by_a_later_one_that_calls_it_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(earlier_handler_of_one_call_called_by_a_later_one)), 0);
}
TEST(WriteHandlers, that_are_taken_back_hear_no_more_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(handler_that_is_taken_back)), 0);
}
TEST(WriteHandlers, run_with_the_signals_blocked_that_they_ask_for_in_a_child) {
  EXPECT_EQ(exit_status(in_fresh_child(mask_in_the_handler<0>)), 0);
  EXPECT_EQ(exit_status(in_fresh_child(mask_in_the_handler<SA_NODEFER>)), 0);
}

/// The signal that ended the child; 0: it exited. Its handlers are its own, so AddressSanitizer has no word in it.
int signal_that_ends(int (*test)()) {
  int status = 0;
  ::waitpid(in_fresh_child(test), &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

TEST(WriteHandlers, of_one_call_are_called_once_in_a_child) {
  EXPECT_EQ(signal_that_ends(one_call_that_returns), SIGSEGV);
  EXPECT_EQ(signal_that_ends(one_call_that_raises), SIGSEGV);
  EXPECT_EQ(signal_that_ends(one_call_that_raises_at_once), SIGSEGV);
}
TEST(WriteHandlers, that_put_back_what_they_found_are_called_once_in_a_child) {
  EXPECT_EQ(signal_that_ends(handler_that_puts_back_what_it_found), SIGSEGV);
}
TEST(WriteHandlers, of_one_call_that_are_installed_again_are_called_again_in_a_child) {
  EXPECT_EQ(signal_that_ends(handler_of_one_call_installed_again), SIGSEGV);
}
TEST(WriteHandlers, that_fault_themselves_end_the_process_in_a_child) {
  EXPECT_EQ(signal_that_ends(fault_in_the_handler), SIGSEGV);
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
