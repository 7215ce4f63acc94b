// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "model/api_call.h"
#include "model/folder_set.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// Every call in the package that advertises, publishes or subscribes, with roscpp's and image_transport's
/// functions or TZC's. Independent of the collectors of facts (both share only the AST), so it finds a call
/// that they overlook. `exported`: folders and headers whose functions advertise for their callers, as a library's do.
std::set<ApiCall> api_calls(clang::ASTContext& ast, const FolderSet& packages,
                            const std::set<std::string>& exported);

}  // namespace tzc::rewriter
