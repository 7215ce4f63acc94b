// SPDX-License-Identifier: BSD-3-Clause
#include "trace/trace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "posix/size_signal.h"

namespace tzc {
namespace trace {
namespace {

/// The bytes that were written; fewer than all: errno says why.
std::size_t write_to(int file, const std::string& text) {
  const posix::SizeSignalBlocked blocked;
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t size = ::write(file, text.data() + done, text.size() - done);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) break;
    done += static_cast<std::size_t>(size);
  }
  return done;
}

}  // namespace

bool TraceFile::open(const std::string& name) {
  name_ = name;
  // A program that this one starts does not have it.
  file_ =
      posix::FileDescriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
  return static_cast<bool>(file_);
}

bool TraceFile::append(const std::string& lines) {
  const std::string text = beginning() + lines;
  const std::size_t written = write_to(file_.get(), text);
  if (written < text.size()) {
    leave_out(written);
    return false;
  }
  size_ += static_cast<off_t>(written);
  is_cut_ = false;
  return true;
}

const char* TraceFile::beginning() const {
  if (is_cut_) return "\n";  // half a line spoils no other
  return size_ == 0 ? "[\n" : "";
}

// Viewers give up at half a line that is not the last one, so it is taken away, where the file is one that can be cut.
void TraceFile::leave_out(std::size_t written) {
  if (!std::exchange(has_said_, true))
    std::fprintf(stderr, "TZC: TZC_TRACE: %s: %s; events are left out of the trace\n", name_.c_str(),
                 std::strerror(errno));
  if (written == 0 || ::ftruncate(file_.get(), size_) == 0) return;
  size_ += static_cast<off_t>(written);
  is_cut_ = true;
}

}  // namespace trace
}  // namespace tzc
