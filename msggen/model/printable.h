// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tzc::msggen {

/// The text as a terminal may have it: at most so many bytes, tabs, but no other control characters (C0, DEL,
/// C1) and no bytes that are not UTF-8. A '?' stands for each, so that columns stay where they are.
std::string printable(std::string_view text, std::size_t longest);

}  // namespace tzc::msggen
