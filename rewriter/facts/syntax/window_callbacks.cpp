// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/window_callbacks.h"

#include <set>

#include "facts/syntax/calls.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

bool calls_one_of(const clang::CallExpr* call, const std::set<std::string>& names) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  return callee && names.count(qualified_name_of(callee)) != 0;
}

bool is_function_pointer(clang::QualType type) {
  return type->isFunctionPointerType() || type->isFunctionType();
}

const clang::FunctionDecl* function_named_by(const clang::Expr* expr) {
  expr = expr->IgnoreParenCasts();
  if (const auto* address = llvm::dyn_cast<clang::UnaryOperator>(expr))
    expr = address->getSubExpr()->IgnoreParenCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  return name ? llvm::dyn_cast<clang::FunctionDecl>(name->getDecl()) : nullptr;
}

bool is_none(const clang::Expr* expr, clang::ASTContext& context) {
  return llvm::isa<clang::CXXDefaultArgExpr>(expr) ||
         expr->IgnoreParenCasts()->isNullPointerConstant(context, clang::Expr::NPC_NeverValueDependent);
}

}  // namespace

bool runs_window_callbacks(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  return call && calls_one_of(call, {"cv::waitKey", "cv::waitKeyEx", "cv::pollKey", "cv::selectROI",
                                     "cv::selectROIs"});
}

std::vector<std::string> callbacks_given_to_windows(const clang::CallExpr* call) {
  std::vector<std::string> given;
  if (!calls_one_of(call, {"cv::createTrackbar", "cv::setMouseCallback", "cv::createButton",
                           "cv::setOpenGlDrawCallback"}))
    return given;
  for (const clang::Expr* argument : call->arguments()) {
    clang::ASTContext& context = call->getDirectCallee()->getASTContext();
    if (!is_function_pointer(argument->getType()) || is_none(argument, context)) continue;
    const clang::FunctionDecl* function = function_named_by(argument);
    given.push_back(function ? usr_of(pattern_of(function)) : "");
  }
  return given;
}

}  // namespace tzc::rewriter
