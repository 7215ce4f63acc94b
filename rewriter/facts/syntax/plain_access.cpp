// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/plain_access.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/ADT/STLExtras.h>

#include <set>
#include <string>

#include "facts/syntax/message_type.h"
#include "facts/syntax/package_types.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

using Names = std::set<std::string>;

const Names pointers = {"std::shared_ptr",     "std::__shared_ptr",    "std::__shared_ptr_access",
                        "std::unique_ptr",     "std::optional",        "boost::shared_ptr",
                        "boost::scoped_ptr",   "boost::intrusive_ptr", "boost::shared_array",
                        "boost::scoped_array", "boost::optional"};
const Names iterators = {"__gnu_cxx::__normal_iterator",  "std::_Deque_iterator",
                         "std::_List_iterator",           "std::_List_const_iterator",
                         "std::__detail::_Node_iterator", "std::__detail::_Node_const_iterator",
                         "std::_Rb_tree_iterator",        "std::_Rb_tree_const_iterator"};
const Names sequences = {"std::vector", "std::array",        "std::deque",
                         "std::list",   "std::forward_list", "boost::array"};
const Names sorted = {"std::map", "std::multimap", "std::set", "std::multiset"};

const Names of_pointers = {"operator*", "operator->", "operator[]", "operator bool",
                           "get",       "has_value",  "_M_get"};
const Names of_iterators = {"operator*",  "operator->", "operator++", "operator--", "operator+",  "operator-",
                            "operator+=", "operator-=", "operator[]", "operator==", "operator!=", "base"};
const Names of_containers = {"size", "empty", "max_size", "begin", "end", "cbegin", "cend", "rbegin", "rend"};
const Names of_sequences = {"operator[]", "at", "front", "back", "data", "capacity"};

/// A pointer of its own deleter, or an allocator's, may be a class of the package.
bool has_usual_memory(const Unit& unit, const clang::ClassTemplateSpecializationDecl* record) {
  static const Names usual = {"std::default_delete", "std::allocator"};
  const auto is_usual = [&](const clang::TemplateArgument& argument) {
    if (argument.getKind() != clang::TemplateArgument::Type) return true;
    const clang::CXXRecordDecl* of = argument.getAsType()->getAsCXXRecordDecl();
    return !of || usual.count(qualified_name_of(of)) != 0 || !involves_package(unit, argument.getAsType());
  };
  const llvm::ArrayRef<clang::TemplateArgument> all = record->getTemplateArgs().asArray();
  return all.empty() || is_usual(all.back()) || all.size() == 1;
}

/// Over raw pointers, as the standard containers' are.
bool walks_raw_pointer(const clang::ClassTemplateSpecializationDecl* iterator) {
  const bool wraps = qualified_name_of(iterator) == "__gnu_cxx::__normal_iterator";
  return !wraps || first_argument(iterator)->isPointerType();
}

bool is_plain(const Unit& unit, const clang::CXXMethodDecl* method) {
  const auto* record = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(method->getParent());
  if (!record) return false;
  const std::string of = qualified_name_of(record), name = method->getNameAsString();
  if (pointers.count(of) != 0) return of_pointers.count(name) != 0 && has_usual_memory(unit, record);
  if (iterators.count(of) != 0) return of_iterators.count(name) != 0 && walks_raw_pointer(record);
  const bool is_sequence = sequences.count(of) != 0;
  if (!is_sequence && sorted.count(of) == 0) return false;
  return (of_containers.count(name) != 0 || (is_sequence && of_sequences.count(name) != 0)) &&
         has_usual_memory(unit, record);
}

/// pointer == nullptr, begin != end: of two pointers or iterators, which compare addresses.
bool compares_addresses(const Unit& unit, const clang::FunctionDecl* function) {
  static const Names comparisons = {"operator==", "operator!="};
  if (comparisons.count(function->getNameAsString()) == 0 || function->getNumParams() != 2) return false;
  return llvm::all_of(function->parameters(), [&](const clang::ParmVarDecl* parameter) {
    const clang::QualType type = parameter->getType().getNonReferenceType();
    const auto* record =
        llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
    if (!record) return type->isNullPtrType() || type->isPointerType();
    const std::string name = qualified_name_of(record);
    if (iterators.count(name) != 0) return walks_raw_pointer(record);
    return name != "std::optional" && pointers.count(name) != 0 && has_usual_memory(unit, record);
  });
}

}  // namespace

bool is_plain_access(const Unit& unit, const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method ? is_plain(unit, method) : compares_addresses(unit, function);
}

}  // namespace tzc::rewriter
