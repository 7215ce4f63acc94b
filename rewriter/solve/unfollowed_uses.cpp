// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unfollowed_uses.h"

#include <algorithm>

#include "model/codes.h"

namespace tzc::rewriter {

/// A variable that nothing outside of its function has a name of.
bool UnfollowedUses::is_of_function(const MessagePart& part) const {
  std::vector<MessagePart> names = other_names_.of(part);
  names.push_back(part);
  return std::all_of(names.begin(), names.end(),
                     [](const MessagePart& name) { return is_local(name) || is_choice(name); });
}

/// All that names the message has its type. Where nothing shows what does, it may be one of any.
bool UnfollowedUses::may_be_twin(const ContentEvent& any) const {
  return any.named_by.empty() || std::any_of(any.named_by.begin(), any.named_by.end(), is_twin_);
}

void UnfollowedUses::note(const std::string& usr, const ContentEvent& event) {
  if (event.kind == ContentEvent::Kind::any && may_be_twin(event)) {
    any_[event.part].push_back(event.where);
    any_in_[usr][event.part].push_back(event.where);
  }
  if (event.kind != ContentEvent::Kind::publish) return;
  const bool is_first = local_.count(event.site) == 0;
  std::set<std::string>& functions = local_[event.site];
  if (!is_of_function(event.part))
    functions.clear();
  else if (is_first || !functions.empty())
    functions.insert(usr);
}

/// Code that cannot run in the program of the site does not use its message.
std::optional<Obstacle> UnfollowedUses::obstacle_in(const Uses& uses, const SiteId& site) const {
  const auto found = uses.find(any_message(site.type));
  if (found == uses.end()) return {};
  for (const Location& where : found->second)
    if (facts_.share_a_process(site.file, where.file))
      return Obstacle{
          codes::TZC1022,
          "line " + std::to_string(where.line) + " of " + where.file.substr(where.file.rfind('/') + 1) +
              " uses a " + site.type +
              ", and nothing shows which: it may be this one, and be written to after this publish",
          where};
  return {};
}

/// A message of a function's own can only be what this function does not follow.
std::optional<Obstacle> UnfollowedUses::why(const SiteId& site) const {
  const auto local = local_.find({site.file, site.begin});
  if (local == local_.end() || local->second.empty()) return obstacle_in(any_, site);
  for (const std::string& usr : local->second)
    if (const auto some = any_in_.find(usr); some != any_in_.end())
      if (const std::optional<Obstacle> obstacle = obstacle_in(some->second, site)) return obstacle;
  return {};
}

}  // namespace tzc::rewriter
