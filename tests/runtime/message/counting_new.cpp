// SPDX-License-Identifier: BSD-3-Clause
#include "counting_new.h"

#include <cstdlib>
#include <new>

namespace tzc {
namespace test {

std::size_t requested_bytes = 0;
std::size_t big_size = static_cast<std::size_t>(-1);
std::size_t big_allocations = 0;

}  // namespace test
}  // namespace tzc

__attribute__((noinline)) void* operator new(std::size_t size) {
  tzc::test::requested_bytes += size;
  if (size >= tzc::test::big_size) ++tzc::test::big_allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
__attribute__((noinline)) void operator delete(void* memory) noexcept {
  std::free(memory);
}
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
