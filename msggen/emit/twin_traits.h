// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// What makes the twin a ROS message (traits, printing and wire format, all those of the stock type) and a
/// TZC message (where its data arrays are).
std::string twin_traits(const Message& message, Analysis& analysis);

}  // namespace tzc::msggen
