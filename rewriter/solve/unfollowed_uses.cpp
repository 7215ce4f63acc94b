// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unfollowed_uses.h"

#include <algorithm>
#include <vector>

#include "model/codes.h"

namespace tzc::rewriter {

/// A variable that nothing outside of its function has a name of.
bool UnfollowedUses::is_of_function(const MessagePart& part) const {
  std::vector<MessagePart> names = other_names_.of(part);
  names.push_back(part);
  return std::all_of(names.begin(), names.end(),
                     [](const MessagePart& name) { return is_local(name) || is_choice(name); });
}

void UnfollowedUses::note(const std::string& usr, const ContentEvent& event) {
  if (event.kind == ContentEvent::Kind::any) {
    any_.emplace(event.part, event.where);
    any_in_[usr].emplace(event.part, event.where);
  }
  if (event.kind != ContentEvent::Kind::publish) return;
  const bool is_first = local_.count(event.site) == 0;
  std::set<std::string>& functions = local_[event.site];
  if (!is_of_function(event.part))
    functions.clear();
  else if (is_first || !functions.empty())
    functions.insert(usr);
}

/// A message of a function's own can only be what this function does not follow.
std::optional<Obstacle> UnfollowedUses::why(const SiteId& site) const {
  const auto obstacle_in = [&](const std::map<MessagePart, Location>& some) -> std::optional<Obstacle> {
    const auto found = some.find(any_message(site.type));
    if (found == some.end()) return {};
    const Location& where = found->second;
    return Obstacle{codes::TZC1022,
                    "line " + std::to_string(where.line) + " of " +
                        where.file.substr(where.file.rfind('/') + 1) + " uses a " + site.type +
                        ", and nothing shows which: it may be this one, and be written to after this publish",
                    where};
  };
  const auto local = local_.find({site.file, site.begin});
  if (local == local_.end() || local->second.empty()) return obstacle_in(any_);
  for (const std::string& usr : local->second)
    if (const auto some = any_in_.find(usr); some != any_in_.end())
      if (const std::optional<Obstacle> obstacle = obstacle_in(some->second)) return obstacle;
  return {};
}

}  // namespace tzc::rewriter
