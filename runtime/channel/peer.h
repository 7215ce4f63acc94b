// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tzc/credentials.h"

namespace tzc {
namespace channel {

/// A subscriber that sent Hello. The kernel recorded the credentials; the rest is not trusted.
struct Peer {
  Credentials credentials;
  std::string hello{};
  bool reads_ring = false;
};

}  // namespace channel
}  // namespace tzc
