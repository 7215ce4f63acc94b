// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/flow/value_flow.h"
#include "facts/sites/hoisting.h"

namespace tzc::rewriter {

struct PublishCall {
  Publish site;
  std::optional<PublisherMention> publisher;
  FlowSources publishers;  ///< (is_left ? left_ : right_).publish(message): several
};

/// publisher.publish(message). None: the call is a template's pattern.
std::optional<PublishCall> publish_call(const Unit& unit, ValueFlow& flow,
                                        const clang::CXXMemberCallExpr* call);

/// tzc::publish(publisher, message): an earlier run wrote it.
Publish attached_publish(const Unit& unit, ValueFlow& flow, const clang::CallExpr* call);

/// The publishers that are passed to a function of the package.
std::vector<PublisherMention> publisher_arguments(const Unit& unit, ValueFlow& flow,
                                                  const clang::CallExpr* call);

}  // namespace tzc::rewriter
