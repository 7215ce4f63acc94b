// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "channel/connect/trunk.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

struct TrunkTarget {
  std::string socket;   ///< the address that publishers listen at
  Credentials process;  ///< the one that does so now
};

/// A number on this process's trunk to that one, which is opened where there is none. Error: another process listens there
/// now, or none, or it did not answer in time. Thread-safe; two threads that come at once may open one each.
Expected<std::unique_ptr<TrunkPlace>> trunk_to(Service& service, const TrunkTarget& target,
                                               std::chrono::milliseconds timeout);

}  // namespace channel
}  // namespace tzc
