// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "model/site.h"

namespace tzc::rewriter {

/// A call that advertises, publishes or subscribes, as engine/api_calls.h finds it.
struct ApiCall {
  SiteKind kind = SiteKind::publish;
  Location where;
  std::string type;                   ///< "sensor_msgs/Image"; empty: unknown at the call
  std::vector<unsigned> in_macros{};  ///< as a SiteId's
};

/// By place, then by kind and type.
inline bool operator<(const ApiCall& a, const ApiCall& b) {
  return std::tie(a.where.file, a.where.line, a.where.column, a.kind, a.type, a.in_macros) <
         std::tie(b.where.file, b.where.line, b.where.column, b.kind, b.type, b.in_macros);
}

}  // namespace tzc::rewriter
