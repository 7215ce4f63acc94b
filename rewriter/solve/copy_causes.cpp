// SPDX-License-Identifier: BSD-3-Clause
#include "solve/copy_causes.h"

#include <string>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

Obstacle because(const std::string& reason, const Location& where) {
  return {codes::TZC1022, reason, where};
}

std::string line_of(const Location& where) {
  return "line " + std::to_string(where.line);
}

}  // namespace

std::optional<Obstacle> CopyCauses::why(const PublishPlace& site) const {
  if (const auto found = taken_.find(site); found != taken_.end()) {
    const auto& [where, by_copy] = found->second;
    return because(by_copy ? "it is a copy (made in " + line_of(where) +
                                 "), whose elements lie outside shared memory until it is published"
                           : line_of(where) + " gives it elements that lie outside shared memory",
                   where);
  }
  if (const auto found = writes_.find(site); found != writes_.end())
    return because(
        line_of(found->second) + " may use its elements for writing after this publish, which copies them",
        found->second);
  if (const auto found = grows_.find(site); found != grows_.end())
    return because(line_of(found->second) +
                       " may give it more elements after this publish, which copies those that it has",
                   found->second);
  return {};
}

}  // namespace tzc::rewriter
