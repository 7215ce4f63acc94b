// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace detail {

/// Names the machine (its boot) and the network namespace of this process: two processes with equal identities reach
/// each other's abstract sockets. Empty where the system does not tell, and while this process has no descriptor to read it with; empty
/// identities never match. Thread-safe.
std::string host_identity();

}  // namespace detail
}  // namespace tzc
