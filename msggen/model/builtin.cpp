// SPDX-License-Identifier: BSD-3-Clause
#include "model/builtin.h"

#include <algorithm>

namespace tzc::msggen {

const std::vector<Builtin>& builtins() {
  using Kind = BuiltinKind;
  static const std::vector<Builtin> table = {
      {"bool", "uint8_t", Kind::boolean, 1, 1},    {"int8", "int8_t", Kind::integer, 1, 1, true},
      {"uint8", "uint8_t", Kind::integer, 1, 1},   {"byte", "int8_t", Kind::integer, 1, 1, true},
      {"char", "uint8_t", Kind::integer, 1, 1},    {"int16", "int16_t", Kind::integer, 2, 2, true},
      {"uint16", "uint16_t", Kind::integer, 2, 2}, {"int32", "int32_t", Kind::integer, 4, 4, true},
      {"uint32", "uint32_t", Kind::integer, 4, 4}, {"int64", "int64_t", Kind::integer, 8, 8, true},
      {"uint64", "uint64_t", Kind::integer, 8, 8}, {"float32", "float", Kind::floating, 4, 4},
      {"float64", "double", Kind::floating, 8, 8}, {"string", "::std::string", Kind::string, 4, 8},
      {"time", "::ros::Time", Kind::time, 8, 4},   {"duration", "::ros::Duration", Kind::time, 8, 4},
  };
  return table;
}

const Builtin* find_builtin(std::string_view name) {
  const auto& table = builtins();
  auto found = std::find_if(table.begin(), table.end(), [&](const Builtin& b) { return b.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace tzc::msggen
