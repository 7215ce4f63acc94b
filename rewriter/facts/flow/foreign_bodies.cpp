// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/foreign_bodies.h"

#include <string>

#include "facts/flow/call_effects.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// By the outermost namespace: ROS may be installed anywhere, or be built in another workspace.
bool is_of_known_library(const clang::FunctionDecl* function) {
  static const std::set<std::string> libraries = {"Eigen",
                                                  "boost",
                                                  "cv",
                                                  "cv_bridge",
                                                  "fmt",
                                                  "image_geometry",
                                                  "image_transport",
                                                  "message_filters",
                                                  "pcl",
                                                  "pcl_ros",
                                                  "ros",
                                                  "rosbag",
                                                  "std",
                                                  "tf",
                                                  "tf2",
                                                  "tf2_ros",
                                                  "tzc"};
  const std::string name = qualified_name_of(function);
  return libraries.count(name.substr(0, name.find("::"))) != 0;
}

bool is_installed(const std::string& file) {
  return file.empty() || file.rfind("/usr/", 0) == 0 || file.rfind("/opt/", 0) == 0;
}

}  // namespace

bool ForeignBodies::is_looked_into(const clang::FunctionDecl* function) const {
  if (unit_.declares(function) || is_of_known_library(function)) return false;
  const clang::SourceLocation where = unit_.ast().getSourceManager().getExpansionLoc(function->getLocation());
  return where.isValid() && !unit_.ast().getSourceManager().isInSystemHeader(where) &&
         !is_installed(unit_.source.file_of(where));
}

/// A function that is being looked into, because it calls itself, has no answer yet: the one that asked first gets it.
clang::QualType ForeignBodies::loses_const(const clang::FunctionDecl* function) {
  const clang::FunctionDecl* body = nullptr;
  if (!function || !function->hasBody(body) || body->isDependentContext()) return {};
  const auto [known, is_new] = known_.emplace(body, clang::QualType());
  if (!is_new || !is_looked_into(body)) return known->second;
  clang::QualType found = in(body->getBody());
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(body))
    for (const clang::CXXCtorInitializer* initializer : constructor->inits())
      if (found.isNull()) found = in(initializer->getInit());
  return known_[body] = found;
}

clang::QualType ForeignBodies::in(const clang::Stmt* stmt) {
  if (!stmt) return {};
  if (const clang::QualType found = by(stmt); !found.isNull()) return found;
  for (const clang::Stmt* child : stmt->children())
    if (const clang::QualType found = in(child); !found.isNull()) return found;
  const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
  return lambda ? in(lambda->getBody()) : clang::QualType();
}

clang::QualType ForeignBodies::by(const clang::Stmt* stmt) {
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(stmt)) {
    const bool is_of_message =
        carried_by(cast->getSubExpr()->getType(), unit_.rules) && carried_by(cast->getType(), unit_.rules);
    return is_of_message && removes_const(cast) && !serves_plain_field(unit_, cast) ? cast->getType()
                                                                                    : clang::QualType();
  }
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return loses_const(made->getConstructor());
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  if (!function) return {};
  if (casts_pointer(function) && call->getNumArgs() == 1 && carried_by(call->getType(), unit_.rules))
    return removes_const(call) && !serves_plain_field(unit_, call) ? call->getType() : clang::QualType();
  return loses_const(function);
}

}  // namespace tzc::rewriter
