// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// The traits that make the twin a ROS message (traits, printing and wire format, all those of the stock
/// type) and a TZC message (its data arrays).
std::string twin_traits(const Message& message, Analysis& analysis);

}  // namespace tzc::msggen
