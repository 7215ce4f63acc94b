// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {
namespace detail {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

}  // namespace detail
}  // namespace tzc
