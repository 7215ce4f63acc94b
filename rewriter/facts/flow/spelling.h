// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/TypeLoc.h>

#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What it takes to write a type in its ported form.
struct Respelling {
  std::vector<Change> changes;
  std::vector<Obstacle> obstacles;
};

/// Of something of that role: a pair of a publisher and a message is ported as the publisher, and the message stays in it.
Respelling respell(const Unit& unit, clang::TypeLoc written, EntityRole role);

}  // namespace tzc::rewriter
