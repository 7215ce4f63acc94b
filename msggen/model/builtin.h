// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tzc::msggen {

enum class BuiltinKind { integer, boolean, floating, string, time };

/// The properties of a builtin type.
struct Builtin {
  std::string_view name;
  std::string_view cpp;  ///< the C++ type that roscpp uses for it
  BuiltinKind kind;
  std::size_t size;        ///< bytes on the wire and in memory; of a string: its length word
  std::size_t alignment;   ///< in memory
  bool is_signed = false;  ///< integers only

  bool fixed_length() const { return kind != BuiltinKind::string; }
  bool may_be_constant() const { return kind != BuiltinKind::time; }
};

/// The builtin of that name, or null.
const Builtin* find_builtin(std::string_view name);

const std::vector<Builtin>& builtins();

}  // namespace tzc::msggen
