// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the expression that names a publisher can be evaluated earlier in the function, where a message is
// allocated: it must have the same value there and no side effect, and must not follow a pointer or an index
// that is only valid at the publish call. tzc::find_publisher(container, key) may be evaluated anywhere.

#include <clang/AST/Expr.h>

#include <string>
#include <variant>
#include <vector>

#include "facts/sites/must_execute.h"
#include "facts/syntax/unit.h"
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
  std::string published = "";           ///< the message, as written
};

/// How a publisher can be named earlier than its mention does.
struct EarlyName {
  std::string text;
  bool guarded = false;                ///< by a smart pointer that may be null there
  std::set<std::string> callees = {};  ///< none of which may take a lock, by USR
};

/// An element of a standard container: pubs_[key], pubs_.at(key), pubs_.front(), pubs_.back().
struct Lookup {
  const clang::Expr* container;
  const clang::Expr* key;  ///< null: the first or the last
  bool is_last = false;
};

class Hoisting {
 public:
  explicit Hoisting(const Unit& unit) : unit_(unit) {}

  /// The name at an offset of the function that mentions the publisher; none: there it cannot be named.
  std::optional<EarlyName> name_at(const PublisherMention& publisher, unsigned at) const;
  /// Whether the expression names the same object at an offset of its function, can be evaluated there, and once more.
  bool names_the_same(const clang::Expr* object, const clang::FunctionDecl* function, unsigned at) const;

 private:
  std::optional<EarlyName> as_written_at(const PublisherMention& publisher, unsigned at) const;
  /// As an element of a standard container.
  std::optional<EarlyName> looked_up_at(const PublisherMention& publisher, const Lookup& lookup,
                                        unsigned at) const;
  /// Whether the name means the same at the offset, and may be evaluated once more, but for the steps it takes.
  bool means_the_same(const PublisherMention& publisher, const NameParts& parts, unsigned at) const;
  /// Whether every path through the offset follows each pointer and index of the name.
  bool takes_steps(const PublisherMention& publisher, const NameParts& parts, unsigned at) const;
  bool comes_later(const PublisherMention& publisher, const NameParts& parts, unsigned at) const;
  bool is_in_expression_of(const PublisherMention& publisher, unsigned at) const;
  bool may_change_elsewhere(const NameParts& parts) const;
  /// What may run between the mention and the offset.
  Waits waits_between(const PublisherMention& publisher, const NameParts& parts, unsigned at) const;

  const Unit& unit_;
};

}  // namespace tzc::rewriter
