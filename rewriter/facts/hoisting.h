// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the expression that names a publisher can be evaluated earlier in the function, where a message is
// allocated: it must have the same value there and no side effect, and must not follow a pointer or an index
// that is only valid at the publish call.

#include <clang/AST/Expr.h>

#include <string>
#include <vector>

#include "facts/unit.h"
#include "model/ids.h"

namespace tzc::rewriter {

/// A place that names a publisher: a publish call, or an argument.
struct PublisherMention {
  const clang::Expr* object;  ///< the expression that names it
  bool pointer;
  EntityId id;
  std::vector<EntityId> messages;       ///< that are published there
  const clang::FunctionDecl* function;  ///< around it
  unsigned begin;                       ///< offset of the call
};

enum class Availability { none, guarded, safe };  ///< guarded: by a smart pointer that may be null there

class Hoisting {
 public:
  explicit Hoisting(const Unit& unit) : unit_(unit) {}

  /// Whether the publisher's name can be evaluated at an offset of the function that mentions it.
  Availability availability_at(const PublisherMention& publisher, unsigned at) const;
  /// The text that names it there.
  std::string name_text(const PublisherMention& publisher) const;

 private:
  const Unit& unit_;
};

}  // namespace tzc::rewriter
