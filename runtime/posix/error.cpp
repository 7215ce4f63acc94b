// SPDX-License-Identifier: BSD-3-Clause
#include "posix/error.h"

#include <cerrno>
#include <string>

#include "posix/descriptor_use.h"

namespace tzc {
namespace posix {
namespace {

std::string hint_for(int code) {
  switch (code) {
    case EMFILE:
      return "too many open files: " + descriptors_in_use() +
             ", and the others are left to it: raise its limit (ulimit -n)";
    case ENFILE:
      return "too many open files in the system: raise fs.file-max";
    case ENOSPC:
      return "shared memory is full: free space in /dev/shm or make the publisher's memory smaller";
    case ENOMEM:
      return "out of memory: check the memory limit of this process and its control group";
    case EFBIG:
      return "larger than this process may create files: check ulimit -f and ulimit -v";
    case ECONNREFUSED:
    case ENOENT:
      return "no process listens there: is the publisher running, in the same network namespace?";
    case EADDRINUSE:
      return "another process listens on this address";
    case EACCES:
    case EPERM:
      return "not permitted: both sides must be processes of the same user unless the publisher allows more";
    default:
      return "";
  }
}

}  // namespace

Error system_error(const std::string& what, const std::string& where) {
  Error error;
  error.code = errno;
  error.what = what;
  error.where = where;
  error.hint = hint_for(error.code);
  return error;
}

}  // namespace posix
}  // namespace tzc
