// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "model/builtin.h"

namespace tzc::msggen {

/// A constant's value, or what is wrong with it.
struct Value {
  std::string text;  ///< see Constant::value
  std::string error;
  std::string hint;
};

/// Converts a constant's stripped text as genmsg does (Python's int() and float(): no hexadecimal), within
/// its range.
Value convert_value(const Builtin& type, std::string_view text);

}  // namespace tzc::msggen
