// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/flow/entity_table.h"

namespace tzc::rewriter {

/// Calls that advertise. Adds the publisher that a call returns to the table.
class AdvertiseCollector {
 public:
  AdvertiseCollector(const Unit& unit, EntityTable& entities) : unit_(unit), entities_(entities) {}

  /// nh.advertise<M>(...), as `rule` matches it.
  Advertise of_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule);
  /// What `rule` wrote in an earlier run: tzc::advertise<M>(nh, ...).
  Advertise of_ported_call(const clang::CallExpr* call, const MethodCall& rule);

  /// A library's call that advertises for the package and returns the publisher.
  struct LibraryCall {
    Advertise site;
    const clang::CallExpr* publisher;  ///< the call whose value is the publisher that the package keeps
  };
  std::optional<LibraryCall> of_library_call(const clang::CallExpr* call);

 private:
  Advertise site_at(const clang::CallExpr* call, const char* rule) const;
  void describe_type(Advertise& site, clang::QualType type) const;
  void describe_topic(Advertise& site, const clang::CallExpr* call) const;
  void change(Advertise& site, const clang::CXXMemberCallExpr* call, const MethodCall& rule) const;
  void add_memory(Advertise& site, const clang::CXXMemberCallExpr* call, const MethodCall& rule) const;
  void attach(Advertise& site, const clang::CallExpr* call, const LibraryAdvertise& rule);
  std::string attach_text(Advertise& site, const clang::CallExpr* call, const LibraryAdvertise& rule) const;

  const Unit& unit_;
  EntityTable& entities_;
};

}  // namespace tzc::rewriter
