// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// One generated file, its path relative to the output folder.
struct Header {
  std::string path;
  std::string text;
};

/// The header `tzc/PACKAGE/NAME.h` of a good message: its twin when it has a data part, else another name for
/// the stock type.
Header emit_message(const Message& message, Analysis& analysis);

/// The header of a message that has faults: whoever includes it is told why there is no twin of it.
Header emit_refusal(const std::string& full_name, const std::string& why);

/// The header of a service: another name for the stock type, whose messages roscpp alone carries.
Header emit_service(const std::string& package, const std::string& name);

}  // namespace tzc::msggen
