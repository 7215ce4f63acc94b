// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/location.h"

namespace tzc::rewriter {

/// An error, or code that compiles and yet cannot stay.
struct Diagnostic {
  Location where;
  std::string text;
  std::vector<Location> notes;  ///< "in instantiation of ...": places that led there
  bool compiles = false;
};

}  // namespace tzc::rewriter
