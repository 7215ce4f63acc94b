// SPDX-License-Identifier: BSD-3-Clause
#include "posix/mapping.h"

#include <sys/mman.h>
#include <unistd.h>

#include "posix/error.h"

namespace tzc {
namespace posix {
namespace {

#ifndef MAP_NORESERVE
constexpr int MAP_NORESERVE = 0;
#endif

// Adds zero atomically: a write fault without changing what another thread may be writing there.
void touch(std::uint8_t* page) noexcept {
  __atomic_fetch_add(page, std::uint8_t{0}, __ATOMIC_RELAXED);
}

bool populate_at_once(std::uint8_t* begin, std::uint8_t* end) noexcept {
#ifdef MADV_POPULATE_WRITE
  return ::madvise(begin, static_cast<std::size_t>(end - begin), MADV_POPULATE_WRITE) == 0;
#else
  (void)begin;
  (void)end;
  return false;
#endif
}

}  // namespace

std::size_t page_size() noexcept {
  static const auto size = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return size;
}

Mapping::~Mapping() {
  if (data_ != nullptr) ::munmap(data_, size_);
}

Expected<Mapping> Mapping::map(int fd, std::size_t size, Access access, std::uint64_t offset) {
  const int protection = access == Access::read_write ? PROT_READ | PROT_WRITE : PROT_READ;
  const int sharing = access == Access::read_private ? MAP_PRIVATE : MAP_SHARED;
  void* address = ::mmap(nullptr, size, protection, sharing | MAP_NORESERVE, fd, static_cast<off_t>(offset));
  if (address == MAP_FAILED) return system_error("map " + std::to_string(size) + " bytes of shared memory");
  Mapping mapping;
  mapping.data_ = static_cast<std::uint8_t*>(address);
  mapping.size_ = size;
  return mapping;
}

bool Mapping::make_private(int fd, std::uint64_t offset) const noexcept {
  return ::mmap(data_, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED | MAP_NORESERVE, fd,
                static_cast<off_t>(offset)) != MAP_FAILED;
}

void Mapping::populate(std::size_t offset, std::size_t bytes) const noexcept {
  const std::size_t page = page_size();
  std::uint8_t* begin = data_ + offset / page * page;
  std::uint8_t* end = data_ + (offset + bytes + page - 1) / page * page;
  if (end > data_ + size_) end = data_ + size_;
  if (populate_at_once(begin, end)) return;
  for (std::uint8_t* at = begin; at < end; at += page) touch(at);
}

}  // namespace posix
}  // namespace tzc
