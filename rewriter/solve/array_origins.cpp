// SPDX-License-Identifier: BSD-3-Clause
#include "solve/array_origins.h"

#include <algorithm>

namespace tzc::rewriter {
namespace {

/// Whether all that the parameter is given is known. What no call gives anything to is called by something that is not seen.
bool is_known(const Facts& facts, const std::string& from, std::set<std::string>& seen) {
  if (from == own_array || from == followed_array) return true;
  if (from == unknown_array) return false;
  if (!seen.insert(from).second) return true;
  if (facts.addressed.count(from.substr(0, from.rfind('#'))) != 0) return false;
  const auto given = facts.given_arrays.find(from);
  return given != facts.given_arrays.end() &&
         std::all_of(given->second.begin(), given->second.end(),
                     [&](const std::string& origin) { return is_known(facts, origin, seen); });
}

bool has_element(const Subscribe& site, const ArrayCast& cast) {
  return std::any_of(cast.elements.begin(), cast.elements.end(),
                     [&](const std::string& element) { return site.elements.count(element) != 0; });
}

}  // namespace

std::optional<Obstacle> array_cast(const Facts& facts, const Subscribe& site) {
  const auto meets = [&](const Location& code) { return facts.share_a_process(site.where.file, code.file); };
  const bool loses_types = std::any_of(facts.untyped_arrays.begin(), facts.untyped_arrays.end(), meets);
  for (const ArrayCast& cast : facts.array_casts) {
    std::set<std::string> seen;
    if (has_element(site, cast) && meets(cast.obstacle.where) && (!cast.untyped || loses_types) &&
        !is_known(facts, cast.from, seen))
      return cast.obstacle;
  }
  return {};
}

}  // namespace tzc::rewriter
