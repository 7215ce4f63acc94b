// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unbound_messages.h"

#include <vector>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

std::string root_of(const MessagePart& part) {
  return part.substr(0, part.find_first_of("/["));
}

/// Whether the part is another object afterwards, or has another one's elements.
bool replaces(const ContentEvent& event) {
  using Kind = ContentEvent::Kind;
  return (event.kind == Kind::reset && !event.empties) || event.kind == Kind::exchange ||
         event.kind == Kind::alias;
}

}  // namespace

UnboundMessages::UnboundMessages(const Facts& facts) : facts_(facts) {
  read_contents();
  for (const auto& [site, holders] : facts.given.published_from)
    published_.insert(holders.begin(), holders.end());
  add_what_is_passed();
  for (const GivenMessage& given : facts.given.messages)
    if (!is_bound(given.message)) add(given);
  for (const GivenMessage& given : facts.given.refills)
    if (facts.given.emptied.count(given.holder) != 0) add(given);
  hand_on();
}

void UnboundMessages::add(const GivenMessage& given) {
  const std::string line = "line " + std::to_string(given.where.line);
  const std::string why =
      given.is_copy ? "it is a copy (" + given.how + " in " + line +
                          "), whose elements lie outside shared memory until it is published"
      : given.message.empty() ? line + " puts new messages into the container (" + given.how +
                                    "), whose elements lie outside shared memory until they are published"
                              : "its elements come from a message that is never published itself (" +
                                    given.how + " in " + line + "), and lie outside shared memory";
  unbound_.emplace(given.holder, Obstacle{codes::TZC1022, why, given.where});
}

/// What is made from such content lies outside shared memory, too, by whatever name it is published.
void UnboundMessages::hand_on() {
  std::vector<std::string> open;
  for (const auto& [holder, why] : unbound_) open.push_back(holder);
  while (!open.empty()) {
    const std::string holder = std::move(open.back());
    open.pop_back();
    const auto add_from = [&](const std::map<std::string, std::set<std::string>>& next) {
      const auto found = next.find(holder);
      if (found == next.end()) return;
      for (const std::string& other : found->second)
        if (unbound_.emplace(other, unbound_.at(holder)).second) open.push_back(other);
    };
    add_from(facts_.given.handed_on);
    add_from(names_);
  }
}

void UnboundMessages::read_contents() {
  for (const auto& [usr, flow] : facts_.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) {
        if (event.kind == ContentEvent::Kind::publish) published_.insert(root_of(event.part));
        if (event.kind == ContentEvent::Kind::alias || event.kind == ContentEvent::Kind::perhaps)
          names_[root_in(usr, root_of(event.other))].insert(root_in(usr, root_of(event.part)));
        for (const auto& [parameter, part] : event.passed) given_[parameter].insert(root_of(part));
        if (replaces(event) && root_of(event.part) == event.part) replaced_.insert(event.part);
      }
}

/// What is passed to a parameter that is published is published itself.
void UnboundMessages::add_what_is_passed() {
  std::set<std::string> open = published_;
  while (!open.empty()) {
    const std::string name = *open.begin();
    open.erase(open.begin());
    const auto found = given_.find(name);
    if (found == given_.end()) continue;
    for (const std::string& passed : found->second)
      if (published_.insert(passed).second) open.insert(passed);
  }
}

bool UnboundMessages::is_bound(const MessagePart& message) const {
  return published_.count(message) != 0 || replaced_.count(message) != 0;
}

std::optional<Obstacle> UnboundMessages::why_copied(const SiteId& site) const {
  const auto holders = facts_.given.published_from.find({site.file, site.begin});
  if (holders == facts_.given.published_from.end()) return {};
  for (const std::string& holder : holders->second) {
    if (const auto found = unbound_.find(holder); found != unbound_.end()) return found->second;
    const auto passed = given_.find(holder);
    if (passed == given_.end()) continue;
    for (const std::string& name : passed->second)
      if (const auto found = unbound_.find(name); found != unbound_.end()) return found->second;
  }
  return {};
}

}  // namespace tzc::rewriter
