// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

namespace tzc {
namespace channel {

/// The process at the other end of a socket, as the kernel recorded it.
struct Credentials {
  pid_t pid = -1;
  uid_t uid = static_cast<uid_t>(-1);
  gid_t gid = static_cast<gid_t>(-1);
};

}  // namespace channel
}  // namespace tzc
