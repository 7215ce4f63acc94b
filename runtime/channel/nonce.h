// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace channel {

/// 128 random bits as 32 hexadecimal digits, for transports (posix/nonce.h). Needs no descriptor, and does not fail where a
/// sandbox forbids to ask the kernel. Any thread.
std::string nonce();

}  // namespace channel
}  // namespace tzc
