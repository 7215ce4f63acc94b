// SPDX-License-Identifier: BSD-3-Clause
#include "channel/nonce.h"

#include "posix/nonce.h"

namespace tzc {
namespace channel {

std::string nonce() {
  return posix::nonce();
}

}  // namespace channel
}  // namespace tzc
