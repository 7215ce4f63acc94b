// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "wire/cursor.h"
#include "wire/definition.h"

namespace tzc::compare {

/// The first place at which one field of two messages differs.
struct FieldDifference {
  std::string field;                                ///< path without indices: "markers[].points[]"
  std::string where;                                ///< path with indices: "markers[2].points[17]"
  std::size_t first_offset = 0, second_offset = 0;  ///< bytes from each message's beginning
  std::string first_value, second_value;
};

/// Compares two messages of one type field by field; one entry for each field that differs somewhere, in wire
/// order. Bytes that do not fit the definition are compared as they are, from the field on at which that
/// shows; such an entry has the field "".
std::vector<FieldDifference> field_differences(const Field& definition, const Bytes& first,
                                               const Bytes& second);

}  // namespace tzc::compare
