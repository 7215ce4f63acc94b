// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/quiet_streams.h"

#include <clang/AST/ExprCXX.h>

#include <set>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// Or what a pointer points to: out->operator<<(1).
const clang::CXXRecordDecl* class_of(const clang::Expr* stream) {
  const clang::QualType type = stream->getType();
  return type->isPointerType() ? type->getPointeeCXXRecordDecl() : type->getAsCXXRecordDecl();
}

bool owns_buffer(const clang::CXXRecordDecl* record) {
  static const std::set<std::string> known = {"std::basic_ostringstream", "std::basic_stringstream",
                                              "std::basic_ofstream", "std::basic_fstream"};
  return known.count(qualified_name_of(record)) != 0;
}

bool is_stream(const clang::CXXRecordDecl* record) {
  if (qualified_name_of(record) == "std::basic_ostream") return true;
  return record->hasDefinition() && llvm::any_of(record->bases(), [](const clang::CXXBaseSpecifier& base) {
           const clang::CXXRecordDecl* parent = base.getType()->getAsCXXRecordDecl();
           return !parent || is_stream(parent);
         });
}

bool is_of_process(const clang::VarDecl* variable) {
  static const std::set<std::string> known = {"std::cout",  "std::cerr",  "std::clog",
                                              "std::wcout", "std::wcerr", "std::wclog"};
  return known.count(qualified_name_of(variable)) != 0;
}

/// Of `out << 1 << 2`, and of references to references. All steps of one question count, so that a long chain, and references to choices
/// between references, cost no more than this for each call.
constexpr unsigned max_steps = 100;

bool has_known_target(const clang::Expr* stream, unsigned& steps);

/// A reference stays what it was bound to.
bool is_quiet_variable(const clang::VarDecl* variable, unsigned& steps) {
  if (is_of_process(variable)) return true;
  return variable->getType()->isReferenceType() && !llvm::isa<clang::ParmVarDecl>(variable) &&
         variable->getInit() && has_known_target(variable->getInit(), steps);
}

/// The stream that it was given: `out << 1` << 2, std::endl(out), std::move(out).
bool returns_stream(const clang::CallExpr* call) {
  static const std::set<std::string> known = {"std::endl",       "std::flush", "std::ends",
                                              "std::operator<<", "std::move",  "std::forward"};
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!callee || call->getNumArgs() == 0) return false;
  const std::string name = qualified_name_of(callee);
  return known.count(name) != 0 ||
         (name == "std::basic_ostream::operator<<" && llvm::isa<clang::CXXOperatorCallExpr>(call));
}

bool has_known_target(const clang::Expr* stream, unsigned& steps) {
  if (++steps > max_steps) return false;
  stream = stream->IgnoreParenImpCasts();
  const clang::CXXRecordDecl* record = class_of(stream);
  if (record && owns_buffer(record)) return true;
  if (const auto* choice = llvm::dyn_cast<clang::AbstractConditionalOperator>(stream))
    return has_known_target(choice->getTrueExpr(), steps) && has_known_target(choice->getFalseExpr(), steps);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stream))
    return returns_stream(call) && has_known_target(call->getArg(0), steps);
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stream);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  return variable && is_quiet_variable(variable, steps);
}

}  // namespace

bool is_quiet_stream(const clang::Expr* argument) {
  const clang::CXXRecordDecl* record = class_of(argument->IgnoreParenImpCasts());
  unsigned steps = 0;
  return !record || !is_stream(record) || has_known_target(argument, steps);
}

}  // namespace tzc::rewriter
