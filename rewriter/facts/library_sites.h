// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Libraries that publish or subscribe for the package. Their code cannot be ported, so their sites stay on
// TCPROS; the report names them.

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// realtime_tools::RealtimePublisher<M>(nh, "topic", 1)
std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXConstructExpr* construct);
/// publisher.init(nh, "topic", 1)
std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXMemberCallExpr* call);
/// publisher.unlockAndPublish()
std::optional<Publish> library_publish(const Unit& unit, const clang::CXXMemberCallExpr* call);
/// ros::topic::waitForMessage<M>("topic")
std::optional<Subscribe> library_subscribe(const Unit& unit, const clang::CallExpr* call);

}  // namespace tzc::rewriter
