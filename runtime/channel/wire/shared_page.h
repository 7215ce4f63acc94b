// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "channel/wire/delivery_cursors.h"
#include "channel/wire/ring.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

/// The page of memory that a publisher shares with one subscriber: the delivery cursors and the ring.
struct ConnectionPage {
  std::atomic<std::uint64_t> cursors;
  Ring ring;
};
static_assert(sizeof(ConnectionPage) <= 4096, "the smallest page there is");

/// Owns the mapping of a ConnectionPage, to which both processes write.
class SharedPage {
 public:
  static Expected<SharedPage> create(std::uint32_t first_sequence);
  /// From a peer: checked like every received file.
  static Expected<SharedPage> open(posix::FileDescriptor file, std::size_t size);

  std::atomic<std::uint64_t>& cursors() const { return content().cursors; }
  Ring& ring() const { return content().ring; }
  int fd() const { return file_.shared_fd(); }
  std::size_t size() const { return mapping_.size(); }
  /// What both ends call this connection in a trace; 0 when this process writes none.
  std::uint64_t trace_number() const { return trace_number_; }
  void close_descriptor() { file_.descriptor.reset(); }

 private:
  ConnectionPage& content() const { return *reinterpret_cast<ConnectionPage*>(mapping_.data()); }

  posix::MemoryFile file_;
  posix::Mapping mapping_;
  std::uint64_t trace_number_ = 0;
};

/// What both ends of that connection call a record in a trace.
inline std::uint64_t trace_id(std::uint64_t trace_number, std::uint32_t sequence) {
  return trace_number << 32 | sequence;
}

}  // namespace channel
}  // namespace tzc
