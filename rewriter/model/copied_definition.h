// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tzc::rewriter {

/// A definition that a header of another package holds, too, word for word: one program may have both.
struct CopiedDefinition {
  std::string file;
  std::size_t begin = 0, end = 0;
  std::string copy;  ///< the other package's header
};

}  // namespace tzc::rewriter
