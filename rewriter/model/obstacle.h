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
  bool in_exported_header = false;  ///< --exported-headers=change may take it away
};

}  // namespace tzc::rewriter
