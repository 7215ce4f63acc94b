// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/error.h>

#include <string>

namespace tzc {
namespace posix {

/// The error of the system call that just failed: errno, and a hint for the ones that a user can do something
/// about.
Error system_error(const std::string& what, const std::string& where = std::string());

}  // namespace posix
}  // namespace tzc
