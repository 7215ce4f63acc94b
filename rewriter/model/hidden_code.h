// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Code of the package that libraries call without being given it: deleters that shared pointers keep, and what overrides virtual
// functions of their classes. One unit shows it, and others depend on it. So each notes what such code may do under the
// names that would make it happen, until all units are known.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace tzc::rewriter {

/// The name of a deleter. That of an override is its library's class: "std::basic_streambuf".
constexpr const char* a_deleter = "a deleter";

/// When something happens: always, or only if a unit shows hidden code of one of the names. Copies share the names.
class IfShown {
 public:
  using Names = std::set<std::string>;

  /// Always.
  IfShown() = default;
  explicit IfShown(Names names) : names_(std::make_shared<const Names>(std::move(names))) {}

  bool is_always() const { return !names_; }
  bool is_met_by(const Names& shown) const;
  /// Whether it happens whenever the other happens.
  bool covers(const IfShown& other) const;
  /// None: always.
  const Names* names() const { return names_.get(); }

  friend bool operator==(const IfShown& a, const IfShown& b) {
    return a.names_ == b.names_ || (a.names_ && b.names_ && *a.names_ == *b.names_);
  }

 private:
  std::shared_ptr<const Names> names_;
};

/// When one of two things happens; none: never.
std::optional<IfShown> either(const std::optional<IfShown>& a, const std::optional<IfShown>& b);

}  // namespace tzc::rewriter
