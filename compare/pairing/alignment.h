// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tzc::compare {

using IndexPair = std::pair<std::size_t, std::size_t>;

/// A longest common subsequence of two sequences of digests, as index pairs in ascending order (E. W. Myers,
/// "An O(ND) difference algorithm and its variations", 1986). Beyond a bound of differences, which keeps time
/// and memory small, only the equal beginning and end are found.
std::vector<IndexPair> align(const std::vector<std::uint64_t>& first,
                             const std::vector<std::uint64_t>& second);

/// How many of the pairs are out of order: all but a longest ascending subsequence of the second indices.
/// @param pairs ascending in their first indices
std::size_t count_reordered(const std::vector<IndexPair>& pairs);

}  // namespace tzc::compare
