// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// The header of a message with a data part.
std::string twin_header(const Message& message, Analysis& analysis);

}  // namespace tzc::msggen
