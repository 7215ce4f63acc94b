// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// A point in a source file, as a reader is shown it.
struct Location {
  std::string file;     ///< absolute, canonical
  unsigned line = 0;    ///< from 1
  unsigned column = 0;  ///< from 1
};

/// A byte range of a file, with the line and column of its begin (from 1).
struct Place {
  std::string file;  ///< absolute, canonical
  unsigned begin = 0;
  unsigned end = 0;
  unsigned line = 0;
  unsigned column = 0;
};

inline Location location_of(const Place& place) {
  return {place.file, place.line, place.column};
}

}  // namespace tzc::rewriter
