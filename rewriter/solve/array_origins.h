// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// A cast that may make an array of the subscription's messages writable. Any message may come to it whose type has an array of such elements:
/// by a pointer that something keeps, a result, a function object. Harmless are those to which nothing but other arrays come, or messages
/// that are followed there (DataWrite).
std::optional<Obstacle> array_cast(const Facts& facts, const Subscribe& site);

}  // namespace tzc::rewriter
