// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {
namespace test {

/// Bytes that all allocations of this process asked for since it was last set.
extern std::size_t requested_bytes;

/// Allocations of at least `big_size` bytes since big_allocations was last set. A copy of something big needs
/// a place to go to: this bounds the number of copies.
extern std::size_t big_size;
extern std::size_t big_allocations;

}  // namespace test
}  // namespace tzc
