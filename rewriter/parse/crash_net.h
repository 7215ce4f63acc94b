// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace tzc::rewriter {

/// Runs `work` to its end, on a thread of its own that has a large stack, and returns 0; or the signal that ended it, such as
/// SIGSEGV, which an exhausted stack sends, too. Nothing that `work` had begun may be used then: it is left as the signal
/// found it, never destroyed. Throws what `work` throws. Thread-safe.
///
/// Clang, and what looks at its tree, will meet code that nobody has tried them on. One unit that crashes them must not take
/// the results of all other packages with it, and has to be named.
int signal_that_ends(const std::function<void()>& work);

}  // namespace tzc::rewriter
