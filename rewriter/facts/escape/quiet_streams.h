// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

namespace tzc::rewriter {

/// Whether an argument is no stream for output, or one that is known to write to a buffer of its own (std::ostringstream,
/// std::ofstream), by its type, or to a file of the process (std::cout), by its name. A stream that is only known as a std::ostream
/// writes to wherever its buffer lies, which may be the elements of a message.
bool is_quiet_stream(const clang::Expr* argument);

}  // namespace tzc::rewriter
