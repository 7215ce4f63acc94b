// SPDX-License-Identifier: BSD-3-Clause
#include "posix/write_fault.h"

#include <ucontext.h>

#include <atomic>
#include <mutex>

#include "posix/fault_handlers.h"
#include "posix/fault_signals.h"

namespace tzc {
namespace posix {
namespace {

/// Read by the signal handler: never freed. `begin` is 0 where nothing is watched.
struct Watched {
  std::atomic<std::uintptr_t> begin{0};
  std::atomic<std::uintptr_t> end{0};
  std::atomic<WriteFaultArea*> area{nullptr};
};

constexpr std::size_t most_areas = 4096;
Watched watched[most_areas];
std::atomic<std::size_t> watched_end{0};  // beyond the last one that was ever in use
std::mutex watched_mutex;

const void* instruction_of(const Fault& fault) {
#if defined(__linux__) && defined(__x86_64__)
  return reinterpret_cast<const void*>(
      static_cast<const ucontext_t*>(fault.context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__linux__) && defined(__aarch64__)
  return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(fault.context)->uc_mcontext.pc);
#else
  (void)fault;
  return nullptr;
#endif
}

bool resolve(const Fault& fault) {
  if (fault.info->si_code != SEGV_ACCERR) return false;
  const auto at = reinterpret_cast<std::uintptr_t>(fault.info->si_addr);
  const std::size_t end = watched_end.load(std::memory_order_acquire);
  for (std::size_t i = 0; i < end; ++i) {
    const std::uintptr_t begin = watched[i].begin.load(std::memory_order_acquire);
    if (begin == 0 || at < begin || at >= watched[i].end.load(std::memory_order_acquire)) continue;
    WriteFaultArea* const area = watched[i].area.load(std::memory_order_acquire);
    // The area that is written to lives, so what changes here meanwhile is the place of another one.
    if (watched[i].begin.load(std::memory_order_acquire) != begin) continue;
    return area->make_writable(WriteFault{reinterpret_cast<std::uint8_t*>(at), instruction_of(fault)});
  }
  return false;
}

/// A thread that is started here, of a pool perhaps, inherits what is blocked, and may write to what is watched later.
void unblock_faults_once() {
  static thread_local bool is_done = false;
  if (!is_done) unblock_faults();
  is_done = true;
}

}  // namespace

bool watch_write_faults(const std::uint8_t* begin, std::size_t size, WriteFaultArea& area) {
  if (!stay_first(resolve)) return false;
  const std::lock_guard<std::mutex> lock(watched_mutex);
  for (std::size_t i = 0; i < most_areas; ++i) {
    if (watched[i].begin.load(std::memory_order_relaxed) != 0) continue;
    watched[i].end.store(reinterpret_cast<std::uintptr_t>(begin) + size, std::memory_order_release);
    watched[i].area.store(&area, std::memory_order_release);
    watched[i].begin.store(reinterpret_cast<std::uintptr_t>(begin), std::memory_order_release);
    if (i >= watched_end.load()) watched_end.store(i + 1, std::memory_order_release);
    return true;
  }
  return false;
}

void forget_write_faults(const std::uint8_t* begin) {
  const std::lock_guard<std::mutex> lock(watched_mutex);
  for (Watched& one : watched) {
    if (one.begin.load(std::memory_order_relaxed) == reinterpret_cast<std::uintptr_t>(begin))
      one.begin.store(0);
  }
}

void keep_watching_write_faults() {
  if (watched_end.load(std::memory_order_acquire) == 0) return unblock_faults_once();
  stay_first(resolve);
  unblock_faults();
}

}  // namespace posix
}  // namespace tzc
