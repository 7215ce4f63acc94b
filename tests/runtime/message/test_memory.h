// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <tzc/memory.h>

#include <atomic>
#include <memory>
#include <stdexcept>

namespace tzc {
namespace test {

/// Shared memory that counts what is asked of it and can be told to be exhausted.
class TestMemory : public MemorySource {
 public:
  explicit TestMemory(std::size_t size = std::size_t{256} << 20) {
    MemoryOptions options;
    options.size = size;
    options.prefault = Prefault::none;
    auto memory = SegmentMemory::create(options);
    if (!memory) throw std::runtime_error(memory.error().text());
    memory_ = memory.value();
  }

  BufferPtr allocate(std::size_t bytes) override {
    if (exhausted) return nullptr;
    ++allocations;
    return memory_->allocate(bytes);
  }

  std::atomic<bool> exhausted{false};
  std::atomic<int> allocations{0};

 private:
  std::shared_ptr<SegmentMemory> memory_;
};

}  // namespace test
}  // namespace tzc
