// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "tzc/error.h"

namespace tzc {
namespace channel {

/// posix::start_small_thread (posix/thread.h), for transports.
Status start_small_thread(const char* name, std::function<void()> body);

}  // namespace channel
}  // namespace tzc
