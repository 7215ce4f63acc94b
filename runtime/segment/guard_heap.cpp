// SPDX-License-Identifier: BSD-3-Clause
// Heap buffers of arrays: those that allocate replaced are kept for a while, out of reach; those whose elements were sent
// must not be written.
#include <dlfcn.h>
#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <new>
#include <unordered_map>
#include <vector>

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

/// One buffer that must not be written, or not be used at all. Reused, never freed: a signal handler may look at it.
class WatchedBuffer final : public posix::WriteFaultArea {
 public:
  const void* memory() const { return memory_; }

  /// Published elements may be read.
  void watch(void* memory, std::size_t bytes, Stale::Kind kind, const MemorySource* source) {
    memory_ = memory;
    bytes_ = bytes;
    kind_ = kind;
    name_publisher(source);
    since_.capture();
    state_.store(watched);
    protect_pages(kind == Stale::Kind::published ? PROT_READ : PROT_NONE);
  }

  /// False: it was used.
  bool forget() {
    if (pages_ != nullptr) posix::forget_write_faults(pages_);
    std::uint32_t was = watched;
    const bool is_clean = state_.compare_exchange_strong(was, forgotten);
    if (is_clean && pages_ != nullptr) ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
    memory_ = nullptr;
    pages_ = nullptr;
    return is_clean;
  }

  bool make_writable(const posix::WriteFault& fault) noexcept override {
    std::uint32_t was = watched;
    if (state_.compare_exchange_strong(was, used)) {
      auto* const begin = static_cast<const std::uint8_t*>(memory_);
      report({kind_, topic_, number_, begin, bytes_, &since_}, fault);
      ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
    }
    return true;
  }

 private:
  enum State : std::uint32_t { forgotten, watched, used };

  void name_publisher(const MemorySource* source) {
    const auto* const segments = dynamic_cast<const SegmentMemory*>(source);
    const char* topic = segments != nullptr ? segments->options().name.c_str() : "";
    std::strncpy(topic_, *topic != '\0' ? topic : "(unnamed)", sizeof topic_ - 1);
    number_ = segments != nullptr ? segments->stats().allocated : 0;
    if (kind_ == Stale::Kind::published) number_ = message_number(number_);
  }

  /// The pages that this buffer shares with nothing.
  void protect_pages(int protection) {
    const std::size_t page = posix::page_size();
    const std::size_t usable = is_malloc() ? ::malloc_usable_size(memory_) : bytes_;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory_);
    const std::uintptr_t first = round_up(begin, page),
                         end = (begin + std::max(usable, bytes_)) / page * page;
    if (first >= end) return;
    pages_ = reinterpret_cast<std::uint8_t*>(first);
    page_bytes_ = end - first;
    ::mprotect(pages_, page_bytes_, protection);
    if (posix::watch_write_faults(pages_, page_bytes_, *this)) return;
    ::mprotect(pages_, page_bytes_, PROT_READ | PROT_WRITE);
    pages_ = nullptr;
  }

  void* memory_ = nullptr;
  std::size_t bytes_ = 0;
  Stale::Kind kind_ = Stale::Kind::replaced;
  std::uint64_t number_ = 0;
  char topic_[128] = {};
  CallStack since_{};
  std::uint8_t* pages_ = nullptr;
  std::size_t page_bytes_ = 0;
  std::atomic<std::uint32_t> state_{forgotten};
};

/// The latest retired buffers, in a ring.
class HeapQuarantine {
 public:
  void put(void* memory, std::size_t bytes, const MemorySource* source) {
    const std::lock_guard<std::mutex> lock(mutex_);
    WatchedBuffer& oldest = buffers_[next_++ % std::min(most, quarantined_blocks())];
    void* const old = const_cast<void*>(oldest.memory());
    if (old != nullptr && oldest.forget()) ::operator delete(old);  // what was used may be used again
    oldest.watch(memory, bytes, Stale::Kind::replaced, source);
  }

 private:
  static constexpr std::size_t most = 1024;
  std::mutex mutex_;
  std::size_t next_ = 0;
  WatchedBuffer buffers_[most];
};

/// Buffers of arrays whose elements were sent, and are not to be written.
class FrozenBuffers {
 public:
  void add(void* memory, std::size_t bytes, const MemorySource* source) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (unused_.empty()) unused_.push_back(new WatchedBuffer);
    WatchedBuffer* const buffer = unused_.back();
    unused_.pop_back();
    frozen_.emplace(memory, buffer);
    buffer->watch(memory, bytes, Stale::Kind::published, source);
  }
  void remove(const void* memory) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = frozen_.find(memory);
    if (found == frozen_.end()) return;
    found->second->forget();
    unused_.push_back(found->second);
    frozen_.erase(found);
  }

 private:
  std::mutex mutex_;
  std::unordered_map<const void*, WatchedBuffer*> frozen_;
  std::vector<WatchedBuffer*> unused_;
};

FrozenBuffers& frozen_buffers() {
  static auto* const buffers = new FrozenBuffers;  // for arrays that end after static objects
  return *buffers;
}

}  // namespace

void* allocate(std::size_t bytes) noexcept {
  if (!is_malloc() || bytes == 0 || bytes > SIZE_MAX / 4) return nullptr;
  const std::size_t page = posix::page_size();
  return ::aligned_alloc(page, round_up(bytes, page));
}

void retire(void* memory, std::size_t bytes, const MemorySource* source) noexcept {
  static auto* const quarantine = new HeapQuarantine;
  prepare_reports();
  quarantine->put(memory, bytes, source);
}

void freeze(void* memory, std::size_t bytes, const MemorySource* source) noexcept {
  prepare_reports();
  frozen_buffers().add(memory, bytes, source);
}

void thaw(const void* memory) noexcept {
  frozen_buffers().remove(memory);
}

}  // namespace guard
}  // namespace tzc
