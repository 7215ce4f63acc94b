// SPDX-License-Identifier: BSD-3-Clause
// The program defines the libc's functions that move bytes. The dynamic linker takes a program's definition before
// the libc's, in the program and in every library that it uses, so all of them are counted alike; what a call does
// is left to the libc. Not in builds with a sanitizer, which defines the same functions.
#include <dlfcn.h>
#include <sys/socket.h>

#include <cstddef>

#include "cost.h"

namespace tzc {
namespace bench {
namespace {

Counts* counted = nullptr;

}  // namespace

void count_into(Counts* counts) {
  counted = counts;
}

}  // namespace bench
}  // namespace tzc

#ifndef TZC_BENCH_SANITIZED

namespace {

using tzc::bench::counted;
using tzc::bench::Counts;

template <class Function>
Function libc(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

ssize_t count(std::atomic<std::uint64_t> Counts::* sum, ssize_t bytes) {
  if (counted != nullptr && bytes > 0)
    (counted->*sum).fetch_add(static_cast<std::uint64_t>(bytes), std::memory_order_relaxed);
  return bytes;
}

// Bytes that a call is about to send. They are counted before the call, because who receives them may look at once;
// what was not taken is subtracted afterwards.
class SentBytes {
 public:
  explicit SentBytes(std::size_t offered) : counts_(counted), offered_(offered) {
    if (counts_ != nullptr) counts_->sent.fetch_add(offered_, std::memory_order_relaxed);
  }
  ssize_t taken(ssize_t bytes) const {
    const std::size_t taken = bytes > 0 ? static_cast<std::size_t>(bytes) : 0;
    if (counts_ != nullptr && taken < offered_)
      counts_->sent.fetch_sub(offered_ - taken, std::memory_order_relaxed);
    return bytes;
  }

 private:
  Counts* const counts_;
  const std::size_t offered_;
};

std::size_t bytes_of(const msghdr& message) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < message.msg_iovlen; ++i) bytes += message.msg_iov[i].iov_len;
  return bytes;
}

void count_copy(std::size_t bytes) {
  if (bytes >= tzc::bench::least_copy_bytes) count(&Counts::copied, static_cast<ssize_t>(bytes));
}

using Copy = void* (*)(void*, const void*, std::size_t);
Copy libc_memcpy = nullptr;
Copy libc_memmove = nullptr;

__attribute__((constructor)) void find_copies() {
  libc_memcpy = libc<Copy>("memcpy");
  libc_memmove = libc<Copy>("memmove");
}

// Until find_copies has run, which other constructors and the dynamic linker do not wait for.
void* copy_bytes(void* to, const void* from, std::size_t size) {
  auto* out = static_cast<volatile char*>(to);
  const auto* in = static_cast<const volatile char*>(from);
  if (out <= in) {
    for (std::size_t i = 0; i < size; ++i) out[i] = in[i];
  } else {
    for (std::size_t i = size; i > 0; --i) out[i - 1] = in[i - 1];
  }
  return to;
}

void* count_allocation(void* memory) {
  if (counted != nullptr) counted->allocations.fetch_add(1, std::memory_order_relaxed);
  return memory;
}

}  // namespace

extern "C" {

// glibc's own names of what the next functions replace: dlsym allocates itself.
void* __libc_malloc(std::size_t);                 // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void*, std::size_t);         // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t bytes) noexcept {
  return count_allocation(__libc_malloc(bytes));
}

void* calloc(std::size_t count, std::size_t bytes) noexcept {
  return count_allocation(__libc_calloc(count, bytes));
}

void* realloc(void* memory, std::size_t bytes) noexcept {
  return count_allocation(__libc_realloc(memory, bytes));
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
  return count_allocation(__libc_memalign(alignment, bytes));
}

void* memcpy(void* to, const void* from, std::size_t size) noexcept {
  count_copy(size);
  return libc_memcpy != nullptr ? libc_memcpy(to, from, size) : copy_bytes(to, from, size);
}

void* memmove(void* to, const void* from, std::size_t size) noexcept {
  count_copy(size);
  return libc_memmove != nullptr ? libc_memmove(to, from, size) : copy_bytes(to, from, size);
}

ssize_t send(int socket, const void* data, std::size_t size, int flags) {
  static const auto call = libc<decltype(&::send)>("send");
  return SentBytes(size).taken(call(socket, data, size, flags));
}

ssize_t sendto(int socket, const void* data, std::size_t size, int flags, const sockaddr* address,
               socklen_t length) {
  static const auto call = libc<decltype(&::sendto)>("sendto");
  return SentBytes(size).taken(call(socket, data, size, flags, address, length));
}

ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  static const auto call = libc<decltype(&::sendmsg)>("sendmsg");
  return SentBytes(bytes_of(*message)).taken(call(socket, message, flags));
}

ssize_t recv(int socket, void* data, std::size_t size, int flags) {
  static const auto call = libc<decltype(&::recv)>("recv");
  return count(&Counts::received, call(socket, data, size, flags));
}

ssize_t recvfrom(int socket, void* data, std::size_t size, int flags, sockaddr* address, socklen_t* length) {
  static const auto call = libc<decltype(&::recvfrom)>("recvfrom");
  return count(&Counts::received, call(socket, data, size, flags, address, length));
}

ssize_t recvmsg(int socket, msghdr* message, int flags) {
  static const auto call = libc<decltype(&::recvmsg)>("recvmsg");
  return count(&Counts::received, call(socket, message, flags));
}

}  // extern "C"

#endif
