// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>

namespace tzc::rewriter {

/// Whether a local message is filled by its fields and otherwise only copied into arrays of messages: `cloud.channels.push_back(channel)`. The
/// array copies it to where it is published from, so memory for the message itself buys nothing.
bool is_only_copied_in(const clang::VarDecl* variable);

}  // namespace tzc::rewriter
