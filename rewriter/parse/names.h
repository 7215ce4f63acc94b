// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace clang {
class Decl;
class FunctionDecl;
class NamedDecl;
}  // namespace clang

namespace tzc::rewriter {

/// With the namespaces and classes around it, inline and anonymous namespaces left out. A tzc::MessageArray goes by std::vector, which it is, so
/// that a port is seen as its original.
std::string qualified_name_of(const clang::NamedDecl* decl);
/// Clang's name for a declaration in all translation units.
std::string usr_of(const clang::Decl* decl);
/// The function that a template instance was made from, else itself.
const clang::FunctionDecl* pattern_of(const clang::FunctionDecl* function);

}  // namespace tzc::rewriter
