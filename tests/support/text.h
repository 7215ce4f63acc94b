// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::test {

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tzc::test
