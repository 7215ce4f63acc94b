// SPDX-License-Identifier: BSD-3-Clause
#include "posix/zeroed_memory.h"

#include <sys/mman.h>

#include <string>
#include <utility>

#include "posix/error.h"
#include "posix/mapping.h"

namespace tzc {
namespace posix {

Expected<ZeroedMemory> ZeroedMemory::create(std::size_t bytes) {
  ZeroedMemory memory;
  if (bytes < page_size()) {
    memory.data_.reset(new std::uint8_t[bytes]());
    return {std::move(memory)};
  }
  void* const pages = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return system_error("map " + std::to_string(bytes) + " bytes of memory");
  memory.data_ = std::unique_ptr<std::uint8_t, Release>(static_cast<std::uint8_t*>(pages), Release{bytes});
  return {std::move(memory)};
}

void ZeroedMemory::Release::operator()(std::uint8_t* data) const noexcept {
  if (mapped != 0)
    ::munmap(data, mapped);
  else
    delete[] data;
}

}  // namespace posix
}  // namespace tzc
