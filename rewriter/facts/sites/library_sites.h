// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Libraries that publish or subscribe for the package. Their code cannot be ported, so their sites stay on
// TCPROS; the report names them.

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/flow/value_flow.h"
#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// realtime_tools::RealtimePublisher<M>(nh, "topic", 1)
std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXConstructExpr* construct);
/// std::make_shared<realtime_tools::RealtimePublisher<M>>(nh, "topic", 1)
std::optional<Advertise> library_advertise_made(const Unit& unit, const clang::CallExpr* call);
/// publisher.init(nh, "topic", 1)
std::optional<Advertise> library_advertise(const Unit& unit, const clang::CXXMemberCallExpr* call);
/// laser_proc::LaserTransport::advertiseLaser(nh, 20): its topics can be attached.
std::optional<Advertise> library_transport(const Unit& unit, const clang::CallExpr* call);
/// publisher.unlockAndPublish(), and whatever else of a library publishes a message with large arrays that it is given
std::optional<Publish> library_publish(const Unit& unit, const clang::CXXMemberCallExpr* call);
/// An object that is made, and what with.
struct MadeObject {
  clang::QualType type;
  llvm::ArrayRef<const clang::Expr*> arguments;
};
/// Adds the publishers that an object of a library is made with to Facts::library_publishers. One without a name: it is not known which.
void note_given_publishers(const Unit& unit, ValueFlow& flow, const MadeObject& object, Facts& facts);
/// ros::topic::waitForMessage<M>("topic")
std::optional<Subscribe> library_subscribe(const Unit& unit, const clang::CallExpr* call);

}  // namespace tzc::rewriter
