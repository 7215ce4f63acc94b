// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/location.h"

namespace tzc::rewriter {

/// Why an entity cannot be ported.
struct Obstacle {
  std::string code;
  std::string reason;
  Location where;
};

}  // namespace tzc::rewriter
