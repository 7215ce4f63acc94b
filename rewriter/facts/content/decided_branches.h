// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/Analysis/CFG.h>

#include <map>
#include <vector>

#include "facts/syntax/function_view.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The value, as a condition, of a local variable or of a member of the function's own object.
using DecidedValues = std::map<const clang::ValueDecl*, bool>;

/// The ways in which a function may run, by the variables that decide several of its branches and that it never changes; one,
/// without variables, where there are none. Code that it calls may not change a member, either; another thread or callback may: then this tells
/// what happens as long as none does.
///   const bool wanted = publisher.getNumSubscribers() > 0;
///   if (wanted) image.data.clear();
///   ...
///   if (wanted) publisher.publish(image);  // never without the clear
std::vector<DecidedValues> decided_ways(const Unit& unit, const FunctionView& view, const clang::CFG& cfg);

/// Whether the values let control go from the block to this successor, the number of which is given.
bool may_go(const clang::CFGBlock& block, unsigned successor, const DecidedValues& values);

}  // namespace tzc::rewriter
