// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace channel {

/// \name The share of the process's descriptors that TZC leaves to the program, for transports (posix/descriptor_use.h)
/// @{
bool has_spare_descriptors() noexcept;
std::string descriptors_in_use();
/// @}

}  // namespace channel
}  // namespace tzc
