// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tzc::msggen {

/// MD5 (RFC 1321) as 32 lower-case hexadecimal digits. ROS identifies message types by it; it protects
/// nothing.
std::string md5_hex(std::string_view bytes);

}  // namespace tzc::msggen
