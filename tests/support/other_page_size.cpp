// SPDX-License-Identifier: BSD-3-Clause
/// Preloaded into a test, it makes the process see pages of TZC_TEST_PAGE_SIZE bytes, a multiple of the machine's: what
/// sysconf tells, where mappings begin, and that calls on parts of a page fail. What it cannot show is a kernel that
/// itself works in such pages: that faults, and file ends, are as coarse as that.
#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>

namespace {

std::size_t page() {
  static const std::size_t size = std::strtoul(std::getenv("TZC_TEST_PAGE_SIZE"), nullptr, 10);
  return size;
}
std::size_t round_up(std::size_t bytes) {
  return (bytes + page() - 1) / page() * page();
}
bool is_aligned(const void* address) {
  return reinterpret_cast<std::uintptr_t>(address) % page() == 0;
}

void* map(void* address, std::size_t bytes, int protection, int flags, int fd, off_t offset) {
  return reinterpret_cast<void*>(::syscall(SYS_mmap, address, bytes, protection, flags, fd, offset));
}
long unmap(void* address, std::size_t bytes) {
  return bytes == 0 ? 0 : ::syscall(SYS_munmap, address, bytes);
}

/// Whole pages of address space at a page's beginning; MAP_FAILED when there are none.
void* reserve_pages(std::size_t bytes) {
  void* const wider =
      map(nullptr, bytes + page(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (wider == MAP_FAILED) return wider;
  auto* const begin = static_cast<char*>(wider);
  auto* const aligned = reinterpret_cast<char*>(round_up(reinterpret_cast<std::uintptr_t>(begin)));
  unmap(begin, static_cast<std::size_t>(aligned - begin));
  unmap(aligned + bytes, static_cast<std::size_t>(begin + page() - aligned));
  return aligned;
}

int refused() {
  errno = EINVAL;
  return -1;
}

}  // namespace

extern "C" {

long sysconf(int name) noexcept {
  static const auto real = reinterpret_cast<long (*)(int)>(dlsym(RTLD_NEXT, "sysconf"));
  return name == _SC_PAGESIZE ? static_cast<long>(page()) : real(name);
}

int getpagesize() noexcept {
  return static_cast<int>(page());
}

void* mmap(void* address, std::size_t bytes, int protection, int flags, int fd, off_t offset) noexcept {
  if (!is_aligned(address) || offset % static_cast<off_t>(page()) != 0) {
    errno = EINVAL;
    return MAP_FAILED;
  }
  if (address || bytes == 0) return map(address, bytes, protection, flags, fd, offset);
  void* const place = reserve_pages(round_up(bytes));
  if (place == MAP_FAILED) return place;
  void* const mapped = map(place, bytes, protection, flags | MAP_FIXED, fd, offset);
  const int error = errno;
  if (mapped == MAP_FAILED) unmap(place, round_up(bytes));
  errno = error;
  return mapped;
}

int munmap(void* address, std::size_t bytes) noexcept {
  return is_aligned(address) ? static_cast<int>(unmap(address, round_up(bytes))) : refused();
}

int mprotect(void* address, std::size_t bytes, int protection) noexcept {
  return is_aligned(address) ? static_cast<int>(::syscall(SYS_mprotect, address, round_up(bytes), protection))
                             : refused();
}

int madvise(void* address, std::size_t bytes, int advice) noexcept {
  return is_aligned(address) ? static_cast<int>(::syscall(SYS_madvise, address, round_up(bytes), advice))
                             : refused();
}

}  // extern "C"
