// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is no message is taken for one: void*, bytes, a number, an object that begins with one, another member of a union.

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>

#include "facts/syntax/unit.h"
#include "model/obstacle.h"

namespace tzc::rewriter {

/// A message of the type, any, may be what lies there: how it was found says nothing about which one.
struct ForeignCast {
  std::string type;    ///< "sensor_msgs/Image"
  std::string reason;  ///< what makes it so
};

/// The others compute an address, or make a new object, by what the classes say.
bool keeps_bits(const clang::CastExpr* cast);

/// A cast that looks at the same address, or number, as something else. Casts between related classes find the same object, and null
/// pointers find none.
std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::ExplicitCastExpr* cast);
/// static_pointer_cast<sensor_msgs::Image>(untyped)
std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::CallExpr* call);
/// A mention of a union's member: another member may have been written to. How deep a message, or a pointer to one, lies in it does not matter.
std::optional<ForeignCast> foreign_cast(const Unit& unit, const clang::MemberExpr* member);

}  // namespace tzc::rewriter
