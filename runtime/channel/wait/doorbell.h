// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "channel/wait/bell.h"
#include "posix/hot.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "segment/release_hints.h"
#include "tzc/error.h"

// One thread reads the rings of many connections (receiver.h), and sleeps at a doorbell: a page of memory of the
// receiving process that all of its publishers map. A publisher writes into its connection's ring, sets that
// connection's bit in the page, and rings the bell, so the reader looks only at rings in which something is.
//
// The page holds nothing else. Each publisher may write anything to it: a bit that is set without need makes the
// reader look in vain; one that is cleared, or a bell that is not rung, makes it look late. It looks at every ring
// once a second for that reason.

namespace tzc {
namespace channel {

/// Connections that share one doorbell.
constexpr std::uint32_t doorbell_numbers = 4096;

/// Who may sleep at a doorbell; each sleeps at the bell under its own bit (posix/futex.h).
enum Sleeper : std::uint32_t {
  reader_sleeps = 1,  // the thread of the library
  guest_sleeps = 2,   // a thread of the program that reads in its place
};

/// The words of a doorbell: Bell is a reference to an atomic of 32 bits, Set to one of 64, or both are a model's
/// (tests/model/doorbell_model.cpp).
template <class Bell, class Set>
struct DoorbellWords {
  Bell bell;      // something was written
  Bell sleeping;  // whom the bell wakes: Sleeper, or 0
  Set groups;     // of `leaf` (segment/release_hints.h)
  Set leaf;       // of the connection's bit
};

/// Publisher: after it has written into the ring or the socket.
template <class Words, class Wake>
TZC_HOT void ring_doorbell(Words& words, std::uint32_t number, Wake wake) {
  segment::add_hint(words.groups, words.leaf, number, doorbell_numbers);
  ring_bell(words, wake);
}

/// Its memory. The words of the first connections lie in one cache line.
struct DoorbellPage {
  alignas(64) std::atomic<std::uint32_t> bell{0};
  std::atomic<std::uint32_t> sleeping{0};
  std::atomic<std::uint64_t> groups{0};
  std::atomic<std::uint64_t> leaves[segment::hint_leaves(doorbell_numbers)] = {};
};
static_assert(sizeof(DoorbellPage) <= 4096, "the smallest page there is");

/// That page: the receiving process's own, or one that a publisher has got. Thread-safe.
class Doorbell {
 public:
  static Expected<std::shared_ptr<Doorbell>> create();
  /// From a peer: checked like every received file. All connections to one receiving process share one object.
  static Expected<std::shared_ptr<Doorbell>> open(posix::FileDescriptor file, std::size_t size);
  explicit Doorbell(posix::Mapping mapping) : mapping_(std::move(mapping)) {}

  /// Wakes the reader for this connection. Never blocks.
  TZC_HOT void ring(std::uint32_t number);

  DoorbellPage& page() const { return *reinterpret_cast<DoorbellPage*>(mapping_.data()); }
  /// Of the creator.
  int fd() const { return file_.shared_fd(); }
  std::size_t size() const { return mapping_.size(); }

 private:
  posix::MemoryFile file_;
  posix::Mapping mapping_;
};

}  // namespace channel
}  // namespace tzc
