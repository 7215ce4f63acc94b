// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/shared_types.h"

#include <clang/AST/DeclTemplate.h>
#include "facts/syntax/calls.h"

#include <set>
#include <string>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

const clang::CXXRecordDecl* record_of(clang::QualType type) {
  return type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
}

std::string class_of(clang::QualType type) {
  const clang::CXXRecordDecl* record = record_of(type);
  return record ? qualified_name_of(record) : "";
}

bool is_handle(const std::string& name) {
  static const std::set<std::string> names = {
      "cv::Mat",           "cv::Mat_", "cv::UMat",        "cv_bridge::CvImage", "_IplImage",
      "boost::shared_ptr", "CvMat",    "std::shared_ptr", "boost::optional"};
  return names.count(name) != 0;
}

bool leads(clang::QualType type, unsigned depth) {
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isAnyPointerType() || type->isArrayType()) return true;
  const clang::CXXRecordDecl* record = record_of(type);
  if (!record || depth > 4) return false;
  const std::string name = qualified_name_of(record);
  if (is_handle(name)) return true;
  if (llvm::StringRef(name).contains("Iterator")) return !llvm::StringRef(name).contains("Const");
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  const bool of_library = record->isInStdNamespace() || name.rfind("__gnu_cxx::", 0) == 0;
  return made && of_library &&
         llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& argument) {
           return argument.getKind() == clang::TemplateArgument::Type &&
                  leads(argument.getAsType(), depth + 1);
         });
}

/// Algorithms of the standard library that write to no range, and those that write from their third argument on.
bool only_reads(const clang::FunctionDecl* function, unsigned parameter) {
  static const std::set<std::string> readers = {"accumulate",    "adjacent_find", "advance",
                                                "all_of",        "any_of",        "binary_search",
                                                "count",         "count_if",      "distance",
                                                "equal",         "equal_range",   "find",
                                                "find_if",       "find_if_not",   "for_each_n",
                                                "inner_product", "is_sorted",     "lower_bound",
                                                "max_element",   "min_element",   "minmax_element",
                                                "mismatch",      "next",          "none_of",
                                                "prev",          "reduce",        "search",
                                                "upper_bound",   "begin",         "end",
                                                "make_pair",     "make_tuple",    "lexicographical_compare"};
  static const std::set<std::string> copiers = {"copy",        "copy_backward", "copy_if",
                                                "copy_n",      "partial_sum",   "reverse_copy",
                                                "rotate_copy", "transform",     "uninitialized_copy"};
  const std::string name = function->getNameAsString();
  return readers.count(name) != 0 || (parameter < 2 && copiers.count(name) != 0);
}

}  // namespace

bool is_mat(clang::QualType type) {
  const std::string name = class_of(type);
  return name == "cv::Mat" || name == "cv::Mat_" || name == "cv::UMat";
}

bool leads_to_elements(clang::QualType type) {
  return leads(type, 0);
}

bool shares_message(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  return function && qualified_name_of(function) == "cv_bridge::toCvShare" && call->getNumArgs() > 0;
}

bool hands_on(const clang::FunctionDecl* function) {
  const std::string name = function->getIdentifier() ? function->getName().str() : "";
  return casts_pointer(function) || name == "cvIplImage" || name == "cvMat" ||
         qualified_name_of(function) == "cv_bridge::cvtColorForDisplay";
}

bool is_output(const clang::CXXRecordDecl* record) {
  const std::string name = qualified_name_of(record);
  return name == "cv::_OutputArray" || name == "cv::_InputOutputArray";
}

bool may_write_through(const clang::FunctionDecl* function, unsigned parameter) {
  if (parameter >= function->getNumParams()) return false;
  const clang::QualType type = function->getParamDecl(parameter)->getType();
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  const bool of_library = method ? method->getParent()->isInStdNamespace() : function->isInStdNamespace();
  const bool is_range = of_library && !type->isReferenceType() && function->getPrimaryTemplate();
  if (is_range && (method || only_reads(function, parameter))) return false;
  const clang::QualType target = type->getPointeeType();
  if (target.isNull()) return llvm::StringRef(class_of(type)).contains("Iterator") && leads_to_elements(type);
  if (type->isRValueReferenceType() || target.isConstQualified()) return false;
  const std::string name = class_of(target);
  return name != "boost::shared_ptr" && name != "std::shared_ptr";
}

}  // namespace tzc::rewriter
