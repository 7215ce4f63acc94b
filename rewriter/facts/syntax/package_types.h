// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>

#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a record of the package takes part in a type, so that code of a library that handles objects of the
/// type may call the package.
bool involves_package(const Unit& unit, clang::QualType type);
/// The package's operators and swap for a class or enumeration, which a library finds by the type of what it has: those of its namespace.
std::vector<const clang::FunctionDecl*> functions_beside(const Unit& unit, const clang::TagDecl* tag);
/// Whether a function that the compiler writes for a class calls code of the package: for its members and bases.
bool parts_involve_package(const Unit& unit, const clang::CXXRecordDecl* record);
/// Whether a call of the destructor by a pointer or reference may end an object of a derived class.
bool may_end_derived(const clang::CXXDestructorDecl* destructor);
/// The type of the object that ends with a variable: of a temporary, too, that the variable is a reference to.
clang::QualType object_type_of(const clang::VarDecl* variable);

}  // namespace tzc::rewriter
