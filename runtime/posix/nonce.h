// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace tzc {
namespace posix {

/// 128 random bits as 32 hexadecimal digits: a name that cannot be guessed and does not collide.
std::string nonce();

/// 64 random bits.
std::uint64_t random_number();

}  // namespace posix
}  // namespace tzc
