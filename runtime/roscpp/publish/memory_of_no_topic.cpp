// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/memory_of_no_topic.h"

#include <tzc/detail/attachment.h>

#include <atomic>
#include <mutex>

#include "roscpp/throttled_warning.h"

namespace tzc {
namespace detail {
namespace {

std::atomic<bool> has_topics{false};

MemoryOptions memory_options() {
  MemoryOptions options;
  options.name = no_topic;
  options.pooled = true;  // as that of every topic
  return options;
}

/// Made when it is first asked for. Where that fails, the next call tries again.
class MemoryOfNoTopic {
 public:
  std::shared_ptr<MemorySource> get() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (memory_) return memory_;
    const Expected<std::shared_ptr<SegmentMemory>> made = SegmentMemory::create(memory_options());
    if (made) {
      memory_ = *made;
    } else {
      TZC_WARN_THROTTLED(60,
                         "TZC: messages of no topic (tzc::allocate, publishers that are not advertised) are "
                         "built without shared "
                         "memory, and copied when they are published: "
                             << made.error().text());
    }
    return memory_;
  }
  std::optional<MemoryStats> stats() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return memory_ ? std::make_optional(memory_->stats()) : std::nullopt;
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<SegmentMemory> memory_;
};

MemoryOfNoTopic& of_process() {
  static auto* const memory = new MemoryOfNoTopic;  // outlives every message
  return *memory;
}

}  // namespace

void note_topic_with_memory() {
  has_topics.store(true, std::memory_order_relaxed);
}

std::shared_ptr<MemorySource> memory_of_no_topic() {
  if (!has_topics.load(std::memory_order_relaxed)) return nullptr;
  return of_process().get();
}

std::optional<MemoryStats> stats_of_no_topic() {
  return of_process().stats();
}

}  // namespace detail
}  // namespace tzc
