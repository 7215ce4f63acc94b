// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace tzc::rewriter {

/// Calls work(0) ... work(count - 1) on `jobs` threads (0: one per processor).
void in_parallel(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace tzc::rewriter
