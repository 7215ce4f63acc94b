// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {
namespace channel {

/// \name The share of the process's descriptors that TZC leaves to the program, for transports (posix/descriptor_use.h)
/// @{
std::size_t descriptor_limit() noexcept;
bool has_spare_descriptors() noexcept;
/// @}

}  // namespace channel
}  // namespace tzc
