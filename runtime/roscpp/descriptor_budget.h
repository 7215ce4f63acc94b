// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "channel/spare_descriptors.h"

namespace tzc {
namespace detail {

/// False: the others are left to roscpp's own sockets, which every topic needs.
using channel::has_spare_descriptors;

/// A text for users: why has_spare_descriptors() is false, and what to do about it.
std::string descriptor_advice();

}  // namespace detail
}  // namespace tzc
