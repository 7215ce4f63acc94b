// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/definition.h"

namespace tzc::msggen {

/// The integer constants as an enum inside the class, like gencpp's; empty without any.
std::string integer_constants(const Message& message);

/// Constants that C++14 requires to be defined outside the class. They live in a class template, the twin's
/// base, because only a template's static members may be defined in a header.
struct OutOfLineConstants {
  std::string base;         ///< the base class, empty without such constants
  std::string definitions;  ///< what precedes the twin
};

OutOfLineConstants out_of_line_constants(const Message& message);

}  // namespace tzc::msggen
