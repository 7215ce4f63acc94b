// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "channel/verdict.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

/// The page that a publisher and one subscriber share to decide who gets a record.
class SharedPage {
 public:
  static Expected<SharedPage> create(std::uint32_t first_sequence);
  /// From a peer: checked like every received file.
  static Expected<SharedPage> open(posix::FileDescriptor file, std::size_t size);

  std::atomic<std::uint64_t>& verdict() const;
  int fd() const { return file_.shared_fd(); }
  std::size_t size() const { return mapping_.size(); }
  void close_descriptor() { file_.descriptor.reset(); }

 private:
  posix::MemoryFile file_;
  posix::Mapping mapping_;
};

}  // namespace channel
}  // namespace tzc
