// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace posix {

/// 128 random bits as 32 hexadecimal digits: a name that cannot be guessed and does not collide.
std::string nonce();

}  // namespace posix
}  // namespace tzc
