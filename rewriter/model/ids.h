// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace tzc::rewriter {

/// Names an entity in all translation units: a USR where the linker knows the entity, else its place.
class EntityId {
 public:
  EntityId() = default;  ///< names nothing
  explicit EntityId(std::string text) : text_(std::move(text)) {}

  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

  friend bool operator==(const EntityId& a, const EntityId& b) { return a.text_ == b.text_; }
  friend bool operator!=(const EntityId& a, const EntityId& b) { return a.text_ != b.text_; }
  friend bool operator<(const EntityId& a, const EntityId& b) { return a.text_ < b.text_; }

 private:
  std::string text_;
};

/// Names a component among the Components of one run.
enum class ComponentId : unsigned {};

/// Names a call that advertises, publishes or subscribes. The instances of a template differ in the type.
struct SiteId {
  std::string file;
  unsigned begin = 0;  ///< byte offset of the call
  std::string type;
  std::vector<unsigned> in_macros{};  ///< of the calls that one macro makes, this one

  friend bool operator<(const SiteId& a, const SiteId& b) {
    return std::tie(a.file, a.begin, a.type, a.in_macros) < std::tie(b.file, b.begin, b.type, b.in_macros);
  }
};

}  // namespace tzc::rewriter
