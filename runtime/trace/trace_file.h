// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

#include "posix/file_descriptor.h"

namespace tzc {
namespace trace {

/// The file of a trace: an array of JSON, whose lines are appended. Lines that find no room (a full disk) are left out as a
/// whole, which is said once on standard error; what comes later is written as soon as there is room.
class TraceFile {
 public:
  /// Makes the file, or empties it. False: errno says why not.
  bool open(const std::string& name);
  /// One write, for all of these lines. False: they are left out.
  bool append(const std::string& lines);

 private:
  const char* beginning() const;
  void leave_out(std::size_t written);

  std::string name_;
  posix::FileDescriptor file_;
  off_t size_ = 0;       ///< of what stands in the file and stays there
  bool is_cut_ = false;  ///< its last line is half a line
  bool has_said_ = false;
};

}  // namespace trace
}  // namespace tzc
