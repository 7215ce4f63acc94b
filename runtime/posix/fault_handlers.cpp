// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fault_handlers.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <mutex>
#include <vector>

namespace tzc {
namespace posix {
namespace {

/// A handler of other code, as it was installed.
struct Handler {
  explicit Handler(const struct sigaction& installed) : action(installed) {}

  const struct sigaction action;
  std::atomic<bool> is_reset{false};  // it had its one call (SA_RESETHAND), and counts as SIG_DFL
};

/// The latest one last. Neither a chain nor a handler is ever freed: a signal handler may read them at any time.
using Chain = std::vector<Handler*>;

constexpr std::size_t most_handlers = 8;

std::mutex install_mutex;
std::atomic<const Chain*> chain{nullptr};
std::atomic<FaultResolver> first{nullptr};

#ifdef __linux__
/// A handler that was installed after ours usually calls ours, with the same siginfo_t; then its predecessor's turn has
/// come. How many handlers had theirs is written into the end of the siginfo_t, which the kernel fills with zeros for
/// each signal: unlike a thread's variable it is right after a handler that jumped out.
struct Turns {
  std::uint32_t mark;
  std::uint32_t taken;
};
constexpr std::uint32_t turns_mark = 0x747a6366;  // "tzcf"
static_assert(sizeof(siginfo_t) == 128 && sizeof(Turns) == 8, "the kernel's structure has room at its end");

std::uint8_t* turns_in(siginfo_t& info) {
  return reinterpret_cast<std::uint8_t*>(&info) + sizeof(siginfo_t) - sizeof(Turns);
}

std::uint32_t turns_taken(siginfo_t& info) {
  Turns turns{};
  std::memcpy(&turns, turns_in(info), sizeof turns);
  return turns.mark == turns_mark ? turns.taken : 0;
}

void set_turns_taken(siginfo_t& info, std::uint32_t taken) {
  const Turns turns{taken != 0 ? turns_mark : 0, taken};
  std::memcpy(turns_in(info), &turns, sizeof turns);
}

#else
__thread std::uint32_t turns = 0;  // wrong after a handler that jumped out

std::uint32_t turns_taken(siginfo_t&) {
  return turns;
}

void set_turns_taken(siginfo_t&, std::uint32_t taken) {
  turns = taken;
}
#endif

// A fault happens again when the instruction is tried again, and then ends the process as it would have without us. A
// signal that was sent does not.
void take_default_action(const Fault& fault) {
  struct sigaction standard{};
  standard.sa_handler = SIG_DFL;
  ::sigaction(fault.number, &standard, nullptr);
  if (fault.info->si_code <= 0) ::raise(fault.number);
}

using Entry = void (*)(int, siginfo_t*, void*);

/// Ours, as it is installed above that many handlers. A handler that puts back what it had found, as many do before they return,
/// puts back the entry that it was installed above, and so is the latest no more, nor is any that was found after it.
template <std::size_t beneath>
void on_fault_above(int number, siginfo_t* info, void* context);

constexpr Entry entries[most_handlers] = {on_fault_above<1>, on_fault_above<2>, on_fault_above<3>,
                                          on_fault_above<4>, on_fault_above<5>, on_fault_above<6>,
                                          on_fault_above<7>, on_fault_above<8>};

bool is_ours(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 &&
         std::find(std::begin(entries), std::end(entries), action.sa_sigaction) != std::end(entries);
}

/// Otherwise a handler that was installed since may have called ours.
bool is_called_by_the_kernel(std::uint32_t turns_taken) {
  struct sigaction now{};
  return turns_taken == 0 && (::sigaction(SIGSEGV, nullptr, &now) != 0 || is_ours(now));
}

bool is_a_function(const struct sigaction& action) {
  return action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
}

// The kernel leaves the flags of a handler that it has reset, so SA_SIGINFO may stand beside SIG_DFL.
void call(const struct sigaction& action, const Fault& fault) {
  if (action.sa_handler == SIG_IGN && fault.info->si_code <= 0) return;
  if (!is_a_function(action)) return take_default_action(fault);
  if ((action.sa_flags & SA_SIGINFO) != 0)
    return action.sa_sigaction(fault.number, fault.info, fault.context);
  action.sa_handler(fault.number);
}

/// As the kernel would have called it if ours were not there. With SA_RESETHAND one thread calls it, once. What its sa_mask
/// names is blocked, and the signal itself unless there is SA_NODEFER, so a fault in the handler ends the process there. A
/// handler that jumps out leaves them blocked, as it would without us. Only the stack may be another: ours runs on the
/// alternate one where the thread has one, because a handler that asks for it cannot do without, and others can do with it.
void call_as_kernel(Handler& handler, const Fault& fault) {
  const struct sigaction& action = handler.action;
  if (!is_a_function(action)) return call(action, fault);
  if ((action.sa_flags & SA_RESETHAND) != 0 && handler.is_reset.exchange(true))
    return take_default_action(fault);
  sigset_t blocked = action.sa_mask;
  sigset_t before;
  if ((action.sa_flags & SA_NODEFER) == 0) sigaddset(&blocked, fault.number);
  pthread_sigmask(SIG_BLOCK, &blocked, &before);
  call(action, fault);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

/// As a later handler calls the one that it found: nothing is blocked, nothing reset.
void call_as_predecessor(const Handler& handler, const Fault& fault) {
  if (handler.is_reset.load(std::memory_order_acquire)) return take_default_action(fault);
  call(handler.action, fault);
}

void on_fault(const Fault& fault, std::size_t beneath) {
  siginfo_t* const info = fault.info;
  const int saved = errno;
  const bool resolved = first.load(std::memory_order_acquire)(fault);
  errno = saved;
  if (resolved) return;
  const Chain& others = *chain.load(std::memory_order_acquire);
  const std::uint32_t before = turns_taken(*info);
  const auto passed_over = static_cast<std::uint32_t>(others.size() - std::min(beneath, others.size()));
  const std::uint32_t taken = std::max(before, passed_over);
  if (taken >= others.size()) return take_default_action(fault);
  Handler& next = *others[others.size() - 1 - taken];
  const bool as_kernel = is_called_by_the_kernel(before);
  set_turns_taken(*info, taken + 1);
  as_kernel ? call_as_kernel(next, fault) : call_as_predecessor(next, fault);
  set_turns_taken(*info, before);
}

template <std::size_t beneath>
void on_fault_above(int number, siginfo_t* info, void* context) {
  on_fault(Fault{number, info, context}, beneath);
}

bool has_same_code(const struct sigaction& a, const struct sigaction& b) {
  return (a.sa_flags & SA_SIGINFO) == (b.sa_flags & SA_SIGINFO) && a.sa_sigaction == b.sa_sigaction;
}

/// By the signals that there are: what glibc gives out behind them is anything.
bool is_same(const sigset_t& a, const sigset_t& b) {
  for (int signal = 1; signal < NSIG; ++signal)
    if (sigismember(&a, signal) != sigismember(&b, signal)) return false;
  return true;
}

bool is_same(const struct sigaction& a, const struct sigaction& b) {
  return has_same_code(a, b) && a.sa_flags == b.sa_flags && is_same(a.sa_mask, b.sa_mask);
}

// A program may install two handlers in turn for as long as it runs, so none is made that was there before.
Handler* handler_of(const struct sigaction& action) {
  static std::vector<Handler*>& all = *new std::vector<Handler*>;
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const Handler* one) { return is_same(one->action, action); });
  if (known == all.end()) return all.emplace_back(new Handler(action));
  (*known)->is_reset.store(false);
  return *known;
}

const Chain* chain_of(Chain handlers) {
  static std::vector<const Chain*>& all = *new std::vector<const Chain*>;
  const auto known = std::find_if(all.begin(), all.end(), [&](const Chain* one) { return *one == handlers; });
  return known != all.end() ? *known : all.emplace_back(new Chain(std::move(handlers)));
}

// One that was there already has been installed again: it is the latest now, and has its one call before it.
void add_to_chain(const struct sigaction& latest) {
  const Chain* const old = chain.load();
  if (old != nullptr && is_same(old->back()->action, latest)) return old->back()->is_reset.store(false);
  Chain next = old != nullptr ? *old : Chain();
  next.erase(std::remove_if(next.begin(), next.end(),
                            [&](const Handler* one) { return has_same_code(one->action, latest); }),
             next.end());
  if (next.size() == most_handlers) next.erase(next.begin() + 1);
  next.push_back(handler_of(latest));
  chain.store(chain_of(std::move(next)), std::memory_order_release);
}

bool install(FaultResolver resolver) {
  const std::lock_guard<std::mutex> lock(install_mutex);
  struct sigaction now{};
  if (::sigaction(SIGSEGV, nullptr, &now) != 0) return false;
  if (is_ours(now)) return true;
  add_to_chain(now);
  first.store(resolver, std::memory_order_release);
  struct sigaction ours{};
  ours.sa_sigaction = entries[chain.load()->size() - 1];
  ours.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
  return ::sigaction(SIGSEGV, &ours, nullptr) == 0;
}

}  // namespace

bool stay_first(FaultResolver resolver) {
  struct sigaction now{};
  if (::sigaction(SIGSEGV, nullptr, &now) != 0) return false;
  return is_ours(now) || install(resolver);
}

}  // namespace posix
}  // namespace tzc
