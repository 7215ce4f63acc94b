// SPDX-License-Identifier: BSD-3-Clause
#include "solve/content_state.h"

#include <algorithm>

namespace tzc::rewriter {
namespace {

const MessagePart& name_of(const MessagePart& part) {
  return part;
}
template <class Value>
const MessagePart& name_of(const std::pair<const MessagePart, Value>& item) {
  return item.first;
}

template <class Container>
void erase_inside(Container& parts, const MessagePart& whole) {
  for (auto it = parts.begin(); it != parts.end();)
    it = lies_in(name_of(*it), whole) ? parts.erase(it) : std::next(it);
}

/// Whether the part is, or lies in, an element of a message's own array of messages, "cloud/channels". Of what containers of the program get,
/// given_messages.cpp tells.
bool is_element_of(const MessagePart& part, const MessagePart& array) {
  return array.find('/') != MessagePart::npos && part.size() > array.size() &&
         part.compare(0, array.size(), array) == 0 && part[array.size()] == '[';
}

bool lies_in_any(const MessagePart& part, const std::set<MessagePart>& wholes) {
  return std::any_of(wholes.begin(), wholes.end(),
                     [&](const MessagePart& whole) { return lies_in(part, whole); });
}

std::map<MessagePart, Taken> renamed_parts(const std::map<MessagePart, Taken>& parts,
                                           const ContentState::Renaming& rename) {
  std::map<MessagePart, Taken> names;
  for (const auto& [part, taken] : parts)
    if (MessagePart name = rename(part); !name.empty()) names.emplace(std::move(name), taken);
  return names;
}

std::set<MessagePart> renamed_parts(const std::set<MessagePart>& parts,
                                    const ContentState::Renaming& rename) {
  std::set<MessagePart> names;
  for (const MessagePart& part : parts)
    if (MessagePart name = rename(part); !name.empty()) names.insert(std::move(name));
  return names;
}

}  // namespace

bool lies_in(const MessagePart& part, const MessagePart& whole) {
  return (part.compare(0, whole.size(), whole) == 0 &&
          (part.size() == whole.size() || part[whole.size()] == '/')) ||
         is_element_of(part, whole);
}

std::set<PublishPlace> ContentState::sharers_of(const MessagePart& part) const {
  std::set<PublishPlace> sites;
  if (lies_in_any(part, own_)) return sites;
  for (const auto& [whole, sharers] : shared_)
    if (lies_in(part, whole)) sites.insert(sharers.begin(), sharers.end());
  return sites;
}

void ContentState::unshare(const MessagePart& part) {
  if (is_one_of_several(part)) return;
  erase_inside(shared_, part);
  erase_inside(own_, part);
  if (!sharers_of(part).empty()) own_.insert(part);
}

void ContentState::make(const MessagePart& message) {
  reset(message);
  if (!is_one_of_several(message)) new_.insert(message);
}

bool ContentState::is_new(const MessagePart& part) const {
  return lies_in_any(part, new_);
}

/// A part of it, or what it is a part of.
bool ContentState::is_unsent(const MessagePart& part) const {
  return lies_in_any(part, unsent_) ||
         std::any_of(unsent_.begin(), unsent_.end(),
                     [&](const MessagePart& inner) { return lies_in(inner, part); });
}

void ContentState::reset(const MessagePart& part) {
  unshare(part);
  if (is_one_of_several(part)) return;
  erase_inside(taken_, part);
  erase_inside(borrowed_, part);
  erase_inside(unsent_, part);
}

void ContentState::fill(const MessagePart& part) {
  unsent_.insert(part);
  for (const auto& [copy, made] : borrowed_)
    if (lies_in(part, copy)) taken_.emplace(part, made);
}

void ContentState::take(const MessagePart& part, const Taken& taken) {
  reset(part);
  fill(part);
  taken_.emplace(part, taken);
}

void ContentState::copy(const MessagePart& message, const MessagePart& original, const Location& where) {
  if (original.empty() || is_unsent(original)) return take(message, {where, true});
  const std::set<PublishPlace> sites = sharers_of(original);
  reset(message);
  share_anew(message, sites);
  borrowed_.emplace(message, Taken{where, true});
}

std::optional<Taken> ContentState::publish(const MessagePart& part, const PublishPlace& site) {
  std::optional<Taken> found;
  for (const auto& [array, taken] : taken_)
    if (!found && (lies_in(array, part) || is_element_of(part, array))) found = taken;
  if (!is_one_of_several(part)) {
    erase_inside(taken_, part);
    erase_inside(borrowed_, part);
    erase_inside(unsent_, part);
  }
  erase_inside(own_, part);
  shared_[part].insert(site);
  for (auto it = new_.begin(); it != new_.end();) it = lies_in(part, *it) ? new_.erase(it) : std::next(it);
  return found;
}

bool ContentState::share(const MessagePart& part, const std::set<PublishPlace>& sites) {
  if (sites.empty()) return false;
  std::set<PublishPlace>& known = shared_[part];
  const std::size_t before = known.size();
  known.insert(sites.begin(), sites.end());
  return known.size() > before;
}

void ContentState::share_anew(const MessagePart& part, const std::set<PublishPlace>& sites) {
  share(part, sites);
  if (!sites.empty()) erase_inside(own_, part);
}

void ContentState::exchange(const MessagePart& one, const MessagePart& other) {
  if (lies_in(one, other) || lies_in(other, one)) return;
  ContentState moved = renamed([&](const MessagePart& part) {
    if (lies_in(part, one)) return other + part.substr(one.size());
    return lies_in(part, other) ? one + part.substr(other.size()) : MessagePart();
  });
  moved.new_.clear();
  const std::set<PublishPlace> of_one = sharers_of(one), of_other = sharers_of(other);
  const bool one_is_unsent = lies_in_any(one, unsent_), other_is_unsent = lies_in_any(other, unsent_);
  reset(one);
  reset(other);
  if (one_is_unsent) fill(other);
  if (other_is_unsent) fill(one);
  share_anew(one, of_other);
  share_anew(other, of_one);
  add(moved);
}

void ContentState::alias(const MessagePart& pointer, const MessagePart& other) {
  if (lies_in(pointer, other) || lies_in(other, pointer)) return;
  reset(pointer);
  alias_perhaps(pointer, other);
}

void ContentState::alias_perhaps(const MessagePart& pointer, const MessagePart& other) {
  if (lies_in(pointer, other) || lies_in(other, pointer)) return;
  const ContentState same = renamed([&](const MessagePart& part) {
    return lies_in(part, other) ? pointer + part.substr(other.size()) : MessagePart();
  });
  for (const auto& [part, sites] : same.shared_) share_anew(part, sites);
  share_anew(pointer, sharers_of(other));
  taken_.insert(same.taken_.begin(), same.taken_.end());
  borrowed_.insert(same.borrowed_.begin(), same.borrowed_.end());
  unsent_.insert(same.unsent_.begin(), same.unsent_.end());
  if (lies_in_any(other, unsent_)) fill(pointer);
}

std::set<PublishPlace> ContentState::write(const MessagePart& array) {
  std::set<PublishPlace> sites = sharers_of(array);
  if (!sites.empty() && !is_one_of_several(array)) own_.insert(array);
  return sites;
}

/// An array stays its owner's where each path has made it so, or shares nothing.
bool ContentState::join(const ContentState& other) {
  std::set<MessagePart> own;
  for (const MessagePart& part : own_)
    if (other.sharers_of(part).empty()) own.insert(part);
  for (const MessagePart& part : other.own_)
    if (sharers_of(part).empty()) own.insert(part);
  bool grown = own != own_;
  own_ = std::move(own);
  for (const auto& [part, sites] : other.shared_) grown |= share(part, sites);
  for (auto it = new_.begin(); it != new_.end();) {
    const bool stays = other.new_.count(*it) != 0;
    grown |= !stays;
    it = stays ? std::next(it) : new_.erase(it);
  }
  const auto size = [this] { return taken_.size() + borrowed_.size() + unsent_.size(); };
  const std::size_t before = size();
  taken_.insert(other.taken_.begin(), other.taken_.end());
  borrowed_.insert(other.borrowed_.begin(), other.borrowed_.end());
  unsent_.insert(other.unsent_.begin(), other.unsent_.end());
  return grown || size() > before;
}

void ContentState::join_others(const ContentState& other) {
  std::set<MessagePart> made = new_;
  join(other);
  new_ = std::move(made);
}

void ContentState::add(const ContentState& other) {
  for (const auto& [part, sites] : other.shared_) share(part, sites);
  own_.insert(other.own_.begin(), other.own_.end());
  taken_.insert(other.taken_.begin(), other.taken_.end());
  borrowed_.insert(other.borrowed_.begin(), other.borrowed_.end());
  unsent_.insert(other.unsent_.begin(), other.unsent_.end());
  new_.insert(other.new_.begin(), other.new_.end());
}

ContentState ContentState::renamed(const Renaming& rename) const {
  ContentState result;
  for (const auto& [part, sites] : shared_)
    if (const MessagePart name = rename(part); !name.empty()) result.share(name, sites);
  result.taken_ = renamed_parts(taken_, rename);
  result.borrowed_ = renamed_parts(borrowed_, rename);
  result.own_ = renamed_parts(own_, rename);
  result.unsent_ = renamed_parts(unsent_, rename);
  result.new_ = renamed_parts(new_, rename);
  return result;
}

}  // namespace tzc::rewriter
