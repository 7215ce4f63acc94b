// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a constant message is a copy of a local one that has just been published: `pub.publish(image); ... const Image again = image;`. On
/// each way to the copy the original is published and not named in between, and it has no other name. So both share the published
/// elements, and since nobody writes to the copy, it goes on doing so.
bool shares_published(const Unit& unit, const clang::VarDecl* copy);

}  // namespace tzc::rewriter
