// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::rewriter {

/// How a site is ported. Advertise and publish: zero_copy, one_copy, plain, not_needed; subscribe: shared,
/// copied, plain, not_needed.
enum class Level { zero_copy, one_copy, plain, not_needed, shared, copied };

/// What ported code does when the segment is full.
enum class OnExhausted { deliver, drop, return_from_function };

}  // namespace tzc::rewriter
