// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fault_handlers.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <vector>

namespace tzc {
namespace posix {
namespace {

/// The handlers of other code, the latest one last. Never freed: a signal handler may read it at any time.
using Chain = std::vector<struct sigaction>;

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

void call(const struct sigaction& handler, const Fault& fault) {
  if ((handler.sa_flags & SA_SIGINFO) != 0)
    return handler.sa_sigaction(fault.number, fault.info, fault.context);
  if (handler.sa_handler == SIG_IGN && fault.info->si_code <= 0) return;
  if (handler.sa_handler != SIG_DFL && handler.sa_handler != SIG_IGN) return handler.sa_handler(fault.number);
  take_default_action(fault);
}

void on_fault(int number, siginfo_t* info, void* context) {
  const Fault fault{number, info, context};
  const int saved = errno;
  const bool resolved = first.load(std::memory_order_acquire)(fault);
  errno = saved;
  if (resolved) return;
  const Chain& others = *chain.load(std::memory_order_acquire);
  const std::uint32_t taken = turns_taken(*info);
  if (taken >= others.size()) return take_default_action(fault);
  set_turns_taken(*info, taken + 1);
  call(others[others.size() - 1 - taken], fault);
  set_turns_taken(*info, taken);
}

bool is_ours(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == on_fault;
}

bool is_same(const struct sigaction& a, const struct sigaction& b) {
  return (a.sa_flags & SA_SIGINFO) == (b.sa_flags & SA_SIGINFO) && a.sa_sigaction == b.sa_sigaction;
}

// One that was there already has been installed again: it is the latest now.
void add_to_chain(const struct sigaction& latest) {
  const Chain* const old = chain.load();
  if (old != nullptr && is_same(old->back(), latest)) return;
  Chain next = old != nullptr ? *old : Chain();
  next.erase(std::remove_if(next.begin(), next.end(), [&](const auto& one) { return is_same(one, latest); }),
             next.end());
  if (next.size() == most_handlers) next.erase(next.begin() + 1);
  next.push_back(latest);
  chain.store(new const Chain(std::move(next)), std::memory_order_release);
}

bool install(FaultResolver resolver) {
  const std::lock_guard<std::mutex> lock(install_mutex);
  struct sigaction now{};
  if (::sigaction(SIGSEGV, nullptr, &now) != 0) return false;
  if (is_ours(now)) return true;
  add_to_chain(now);
  first.store(resolver, std::memory_order_release);
  struct sigaction ours{};
  ours.sa_sigaction = on_fault;
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
