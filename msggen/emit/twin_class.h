// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// The twin's struct, its typedefs, conversions and operators, in namespace tzc::PACKAGE.
std::string twin_class(const Message& message, Analysis& analysis);

}  // namespace tzc::msggen
