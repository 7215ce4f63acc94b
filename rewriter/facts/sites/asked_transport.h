// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>

namespace tzc::rewriter {

/// What the hints among a subscription's arguments ask for that memory is not shared for, in words: "the transport 'compressed'", "UDPROS".
/// Empty: nothing, or what only the run tells.
std::string asked_transport(llvm::ArrayRef<const clang::Expr*> arguments);

}  // namespace tzc::rewriter
