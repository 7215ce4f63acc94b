// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Factories: functions that make a message for their callers, far from its publisher. They can be given the
// publisher:
//   Image make(int n);        ->  tzc::Image make(const tzc::Publisher& publisher, int n);
//   pub.publish(make(3));     ->  pub.publish(make(pub, 3));

#include <optional>

#include "facts/sites/allocation_sites.h"

namespace tzc::rewriter {

/// The factory that a function definition is; none: it is none.
std::optional<Factory> factory_of(const Unit& unit, const clang::FunctionDecl* function);

/// The call of a factory, as the site of its message.
std::optional<AllocationDraft> factory_call(const Unit& unit, EntityTable& entities,
                                            const clang::CallExpr* call);

}  // namespace tzc::rewriter
