// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/foreign_bodies.h"

#include <string>

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

/// All that is called is looked into until a cast is found, so where none is, none of them has one. They may call each other.
clang::QualType ForeignBodies::loses_const(const clang::FunctionDecl* function) {
  std::set<const clang::FunctionDecl*> seen;
  clang::QualType found;
  for (Functions open{function}; found.isNull() && !open.empty();) {
    const clang::FunctionDecl* body = nullptr;
    const clang::FunctionDecl* one = open.back();
    open.pop_back();
    if (!one || !one->hasBody(body) || body->isDependentContext() || !seen.insert(body).second) continue;
    if (harmless_.count(body) == 0 && is_looked_into(body)) found = in_body(body, open);
  }
  if (found.isNull()) harmless_.merge(seen);
  return found;
}

clang::QualType ForeignBodies::in_body(const clang::FunctionDecl* function, Functions& called) const {
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function))
    for (const clang::CXXCtorInitializer* initializer : constructor->inits())
      if (const clang::QualType found = in(initializer->getInit(), called); !found.isNull()) return found;
  return in(function->getBody(), called);
}

clang::QualType ForeignBodies::in(const clang::Stmt* stmt, Functions& called) const {
  if (!stmt) return {};
  if (const clang::QualType found = by(stmt, called); !found.isNull()) return found;
  for (const clang::Stmt* child : stmt->children())
    if (const clang::QualType found = in(child, called); !found.isNull()) return found;
  const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
  return lambda ? in(lambda->getBody(), called) : clang::QualType();
}

clang::QualType ForeignBodies::by(const clang::Stmt* stmt, Functions& called) const {
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(stmt)) {
    const bool is_of_message =
        carried_by(cast->getSubExpr()->getType(), unit_.rules) && carried_by(cast->getType(), unit_.rules);
    return is_of_message && removes_const(cast) ? cast->getType() : clang::QualType();
  }
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    called.push_back(made->getConstructor());
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  if (!function) return {};
  called.push_back(function);
  const bool casts = casts_pointer(function) && call->getNumArgs() == 1;
  return casts && carried_by(call->getType(), unit_.rules) && removes_const(call) ? call->getType()
                                                                                  : clang::QualType();
}

}  // namespace tzc::rewriter
