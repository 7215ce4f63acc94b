// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which message a callback takes, and whether it may write to it.

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

/// The message of a callback's parameter, and whether the callback may write to it.
struct CallbackParameter {
  std::optional<MessageType> message;
  bool writes = false;
  bool converts = false;  ///< it is of another type, made from the message
};

/// Of one parameter of a callback.
CallbackParameter callback_parameter_of(clang::QualType type);
/// Of the callback that a subscribe call is given.
CallbackParameter callback_parameter_of(const clang::CallExpr* call);

}  // namespace tzc::rewriter
