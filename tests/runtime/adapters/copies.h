// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "../message/counting_new.h"
#include "../message/test_memory.h"

namespace tzc {
namespace test {

/// Stands for a tzc::Publisher: something with memory().
struct FakePublisher {
  std::shared_ptr<TestMemory> test_memory = std::make_shared<TestMemory>();
  std::shared_ptr<MemorySource> memory() const { return test_memory; }
};

/// How many places of at least `size` bytes `work` asks for, on the heap and in `memory`: the copies that it
/// can make.
template <class Work>
std::size_t places_for(std::size_t size, const std::shared_ptr<TestMemory>& memory, Work work) {
  const int before = memory->allocations;
  big_allocations = 0;
  big_size = size;
  work();
  big_size = static_cast<std::size_t>(-1);
  return big_allocations + static_cast<std::size_t>(memory->allocations - before);
}

}  // namespace test
}  // namespace tzc
