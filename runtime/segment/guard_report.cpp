// SPDX-License-Identifier: BSD-3-Clause
#include "segment/guard_report.h"

#include <unistd.h>
#if __has_include(<execinfo.h>)
#include <execinfo.h>
#define TZC_HAS_BACKTRACE 1
#endif

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "posix/fork_epoch.h"
#include "segment/guard_settings.h"

namespace tzc {
namespace guard {
namespace {

std::atomic<std::uint64_t> published{0};
std::atomic<std::uint64_t> late_accesses{0};
std::atomic<std::uint32_t> places{0};

constexpr std::size_t most_places = 256;
std::atomic<std::uint64_t> known_places[most_places];
std::atomic_flag is_writing = ATOMIC_FLAG_INIT;

/// Text on its way to stderr, without memory from the heap.
class Text {
 public:
  ~Text() { (void)!::write(STDERR_FILENO, bytes_, size_); }
  Text& operator<<(const char* text) {
    const std::size_t room = sizeof bytes_ - size_, length = std::strlen(text);
    std::memcpy(bytes_ + size_, text, length < room ? length : room);
    size_ += length < room ? length : room;
    return *this;
  }
  Text& operator<<(std::uint64_t number) { return digits(number, 10); }
  Text& operator<<(const void* address) {
    return (*this << "0x").digits(reinterpret_cast<std::uintptr_t>(address), 16);
  }

 private:
  Text& digits(std::uint64_t number, unsigned base) {
    char reversed[24], text[24];
    std::size_t count = 0;
    do {
      reversed[count++] = "0123456789abcdef"[number % base];
      number /= base;
    } while (number != 0);
    for (std::size_t i = 0; i < count; ++i) text[i] = reversed[count - 1 - i];
    text[count] = '\0';
    return *this << text;
  }

  char bytes_[1024];
  std::size_t size_ = 0;
};

struct Words {
  const char* access;
  const char* since;
  const char* access_here;
  const char* advice;
};

const Words& words_for(Stale::Kind kind) {
  static constexpr Words published_words{"a write to a message after it was published",
                                         "published here:", "written here:",
                                         "In the port, subscribers may read this memory while it is written. "
                                         "Write before publish, or through the message, "
                                         "which then gets fresh memory."};
  static constexpr Words free_words{
      "an access to memory of a message that no message has any more",
      "last published here:", "accessed here:",
      "In the port, this memory may hold another message by now. Let the message live longer than pointers "
      "into it."};
  static constexpr Words replaced_words{
      "an access to the old memory of an array that allocate has moved to shared memory",
      "moved here:", "accessed here:",
      "In the port, this memory is freed. Call allocate before pointers into the array are taken."};
  if (kind == Stale::Kind::published) return published_words;
  return kind == Stale::Kind::free ? free_words : replaced_words;
}

// Without the frames of the signal handler, which are the latest.
void drop_handler(CallStack& stack, const void* instruction) {
  for (int i = 0; i < stack.size; ++i) {
    if (stack.frames[i] != instruction) continue;
    stack.size -= i;
    std::memmove(stack.frames, stack.frames + i,
                 sizeof stack.frames[0] * static_cast<std::size_t>(stack.size));
    return;
  }
}

bool is_new_place(const CallStack& stack) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (int i = 0; i < stack.size; ++i)
    hash = (hash ^ reinterpret_cast<std::uintptr_t>(stack.frames[i])) * 1099511628211u;
  for (std::atomic<std::uint64_t>& known : known_places) {
    std::uint64_t none = 0;
    if (known.compare_exchange_strong(none, hash)) return true;
    if (none == hash) return false;
  }
  return false;
}

void write_stack(const char* title, const CallStack& stack) {
  if (stack.size == 0) return;
  Text() << "  " << title << "\n";
#ifdef TZC_HAS_BACKTRACE
  ::backtrace_symbols_fd(stack.frames, stack.size, STDERR_FILENO);
#endif
}

void write_report(const Stale& stale, const posix::WriteFault& fault, const CallStack& access) {
  const Words& words = words_for(stale.kind);
  while (is_writing.test_and_set(std::memory_order_acquire)) ::usleep(1000);  // another thread's report
  Text() << "TZC guard: " << words.access << "\n  topic " << stale.topic
         << (stale.kind == Stale::Kind::replaced ? ", allocation " : ", message ") << stale.number
         << ", byte " << static_cast<std::uint64_t>(fault.address - stale.begin) << " of "
         << std::uint64_t{stale.size} << " at " << static_cast<const void*>(fault.address) << ", process "
         << static_cast<std::uint64_t>(::getpid()) << "\n";
  write_stack(words.since, *stale.since);
  write_stack(words.access_here, access);
  Text() << "  " << words.advice << " (share/doc/tzc/guard.md)\n";
  is_writing.clear(std::memory_order_release);
}

// At the end of the process that began to publish; a forked child has nothing to say.
void write_summary() {
  static const std::uint32_t epoch = posix::fork_epoch();
  static const int registered = std::atexit([] {
    if (posix::forked_since(epoch)) return;
    Text line;
    line << "TZC guard: process " << static_cast<std::uint64_t>(::getpid()) << ": " << published.load()
         << " blocks of published messages were watched, ";
    if (late_accesses.load() == 0)
      line << "no late access\n";
    else
      line << late_accesses.load() << " late accesses from " << std::uint64_t{places.load()} << " places\n";
  });
  (void)registered;
}

}  // namespace

void CallStack::capture() noexcept {
#ifdef TZC_HAS_BACKTRACE
  size = ::backtrace(frames, most);
#else
  size = 0;
#endif
}

// The first call of backtrace loads a library, which a signal handler must not.
void prepare_reports() {
  CallStack stack;
  stack.capture();
  write_summary();
}

void count_published() noexcept {
  published.fetch_add(1, std::memory_order_relaxed);
}

void report(const Stale& stale, const posix::WriteFault& fault) noexcept {
  CallStack access;
  access.capture();
  drop_handler(access, fault.instruction);
  late_accesses.fetch_add(1, std::memory_order_relaxed);
  const bool is_new = is_new_place(access);
  if (is_new) places.fetch_add(1, std::memory_order_relaxed);
  if (is_new || action() == Action::abort) write_report(stale, fault, access);
  if (action() == Action::abort) std::abort();
}

}  // namespace guard
}  // namespace tzc
