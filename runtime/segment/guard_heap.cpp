// SPDX-License-Identifier: BSD-3-Clause
// The heap buffers that allocate replaced: kept for a while, and out of reach.
#include <dlfcn.h>
#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <new>

#include "posix/mapping.h"
#include "posix/write_fault.h"
#include "segment/guard_report.h"
#include "tzc/guard.h"
#include "tzc/memory.h"

namespace tzc {
namespace guard {
namespace {

/// True where operator new and delete are the C++ library's, which are malloc and free. A program, or a sanitizer, may
/// have others.
bool is_malloc() {
  static const bool is = [] {
    Dl_info info{};
    void* (*const allocate)(std::size_t) = &::operator new;
    return ::dladdr(reinterpret_cast<void*>(allocate), &info) != 0 && info.dli_fname != nullptr &&
           std::strstr(info.dli_fname, "libstdc++") != nullptr;
  }();
  return is;
}

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

/// One buffer in quarantine. Reused, never freed: a signal handler may look at it.
class RetiredBuffer final : public posix::WriteFaultArea {
 public:
  bool is_used() const { return memory_ != nullptr; }

  void retire(void* memory, std::size_t bytes, const char* topic, std::uint64_t number) {
    memory_ = memory;
    bytes_ = bytes;
    number_ = number;
    std::strncpy(topic_, topic, sizeof topic_ - 1);
    since_.capture();
    state_.store(out_of_reach);
    protect_pages();
  }

  /// The memory may be used again, unless it was used already.
  void release() {
    if (pages_ != nullptr) posix::forget_write_faults(pages_);
    std::uint32_t was = out_of_reach;
    if (state_.compare_exchange_strong(was, released)) {
      if (pages_ != nullptr) ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
      ::operator delete(memory_);
    }
    memory_ = nullptr;
    pages_ = nullptr;
  }

  bool make_writable(const posix::WriteFault& fault) noexcept override {
    std::uint32_t was = out_of_reach;
    if (state_.compare_exchange_strong(was, used)) {
      auto* const begin = static_cast<const std::uint8_t*>(memory_);
      report({Stale::Kind::replaced, topic_, number_, begin, bytes_, &since_}, fault);
      ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
    }
    return true;
  }

 private:
  enum State : std::uint32_t { released, out_of_reach, used };

  /// The pages that this buffer shares with nothing.
  void protect_pages() {
    const std::size_t page = posix::page_size();
    const std::size_t usable = is_malloc() ? ::malloc_usable_size(memory_) : bytes_;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory_);
    const std::uintptr_t first = round_up(begin, page),
                         end = (begin + std::max(usable, bytes_)) / page * page;
    if (first >= end) return;
    pages_ = reinterpret_cast<std::uint8_t*>(first);
    page_bytes_ = end - first;
    ::mprotect(pages_, page_bytes_, PROT_NONE);
    if (posix::watch_write_faults(pages_, page_bytes_, *this)) return;
    ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
    pages_ = nullptr;
  }

  void* memory_ = nullptr;
  std::size_t bytes_ = 0;
  std::uint64_t number_ = 0;
  char topic_[128] = {};
  CallStack since_{};
  std::uint8_t* pages_ = nullptr;
  std::size_t page_bytes_ = 0;
  std::atomic<std::uint32_t> state_{released};
};

/// The latest ones, in a ring.
class HeapQuarantine {
 public:
  RetiredBuffer& next() {
    RetiredBuffer& oldest = buffers_[next_++ % std::min(most, quarantined_blocks())];
    if (oldest.is_used()) oldest.release();
    return oldest;
  }
  std::mutex& mutex() { return mutex_; }

 private:
  static constexpr std::size_t most = 1024;
  std::mutex mutex_;
  std::size_t next_ = 0;
  RetiredBuffer buffers_[most];
};

}  // namespace

void* allocate(std::size_t bytes) noexcept {
  if (!is_malloc() || bytes == 0 || bytes > SIZE_MAX / 4) return nullptr;
  const std::size_t page = posix::page_size();
  return ::aligned_alloc(page, round_up(bytes, page));
}

void retire(void* memory, std::size_t bytes, const MemorySource* source) noexcept {
  static auto* const quarantine = new HeapQuarantine;
  prepare_reports();
  const auto* const segments = dynamic_cast<const SegmentMemory*>(source);
  const std::string topic = segments != nullptr ? segments->options().name : std::string();
  const std::uint64_t number = segments != nullptr ? segments->stats().allocated : 0;
  const std::lock_guard<std::mutex> lock(quarantine->mutex());
  quarantine->next().retire(memory, bytes, topic.empty() ? "(unnamed)" : topic.c_str(), number);
}

}  // namespace guard
}  // namespace tzc
