// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "report/completeness.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// Every call in the package that advertises, publishes or subscribes, with roscpp's and image_transport's
/// functions or TZC's. A second look that shares nothing with the collecting of facts but the AST, so that a
/// call which that one overlooks does not go unnoticed.
std::set<ApiCall> api_calls(clang::ASTContext& ast, const std::string& package_dir);

}  // namespace tzc::rewriter
