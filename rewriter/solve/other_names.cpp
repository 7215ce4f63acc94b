// SPDX-License-Identifier: BSD-3-Clause
#include "solve/other_names.h"

#include <algorithm>
#include <cctype>

#include "solve/callers.h"

namespace tzc::rewriter {
namespace {

/// "frames_[i]/data" -> "frames_[i]"
MessagePart message_of(const MessagePart& part) {
  return part.substr(0, part.find('/'));
}

/// "frames_[i]/data" -> "frames_"
std::string stem_of(const MessagePart& part) {
  return part.substr(0, part.find_first_of("/["));
}

/// "frames_[0]": two such names of one container are two messages.
bool has_constant_index(const MessagePart& message) {
  const std::size_t begin = message.find('[');
  return begin != std::string::npos && message.size() > begin + 2 &&
         std::all_of(message.begin() + static_cast<std::ptrdiff_t>(begin) + 1, message.end() - 1,
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool are_two_messages(const MessagePart& one, const MessagePart& other) {
  return stem_of(one) == stem_of(other) && has_constant_index(one) && has_constant_index(other);
}

/// Whether it makes a part another name of what another one leads to.
bool is_name(const ContentEvent& event) {
  return event.kind == ContentEvent::Kind::alias || event.kind == ContentEvent::Kind::perhaps;
}

bool is_element(const MessagePart& message) {
  return is_element_of(message, stem_of(message));
}

/// "frames_[i@120@]" with the index "@120@", the container "frames_" and the element "frames_[i@120@]"; "it" with the iterator "it".
bool changes_with(const MessagePart& message, const MessagePart& changed) {
  if (changed.front() == '@') return message.find(changed) != MessagePart::npos;
  return stem_of(message) == stem_of(changed);
}

template <class Visitor>
void for_each_event(const Facts& facts, const Visitor& visit) {
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) visit(event);
}

/// What outlives functions and is named in a function, or in what it calls.
std::map<std::string, std::set<std::string>> lasting_stems(const Facts& facts) {
  std::map<std::string, std::set<std::string>> stems;
  for (const auto& [usr, flow] : facts.contents) {
    std::set<std::string>& names = stems[usr];
    const auto add = [&names = names](const MessagePart& part) {
      if (outlives_functions(part)) names.insert(stem_of(part));
    };
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) {
        add(event.part);
        add(event.other);
        for (const auto& [parameter, part] : event.passed) add(part);
      }
  }
  Callers(facts).learn([&](const std::string& caller, const std::string& callee) {
    const auto found = stems.find(callee);
    if (found == stems.end()) return false;
    std::set<std::string>& names = stems[caller];
    const std::size_t before = names.size();
    names.insert(found->second.begin(), found->second.end());
    return names.size() > before;
  });
  return stems;
}

}  // namespace

bool is_element_of(const MessagePart& part, const MessagePart& container) {
  return part.size() > container.size() && part[container.size()] == '[' &&
         part.compare(0, container.size(), container) == 0;
}

OtherNames::OtherNames(const Facts& facts) {
  std::set<MessagePart> changed;
  for_each_event(facts, [&](const ContentEvent& event) {
    if (event.kind == ContentEvent::Kind::moved) {
      changed.insert(event.part);
      return;
    }
    add_name(event.part);
    add_name(event.other);
    for (const auto& [parameter, part] : event.passed) add_name(part);
    if (is_name(event)) unite(stem_of(event.part), stem_of(event.other));
    if (event.kind == ContentEvent::Kind::call) unite_results(facts, event.callee);
  });
  unite_kept_parameters(facts);
  unite_named_arguments(facts);
  add_elements(changed);
  for (const auto& [stem, names] : by_stem_) by_family_[family_of(stem)].insert(names.begin(), names.end());
}

void OtherNames::add_name(const MessagePart& part) {
  if (!part.empty()) by_stem_[stem_of(part)].insert(message_of(part));
}

/// What any element of a container has, and which elements change with what.
void OtherNames::add_elements(const std::set<MessagePart>& changed) {
  for (auto& [stem, names] : by_stem_) {
    const bool has_elements = std::any_of(names.begin(), names.end(), is_element);
    if (has_elements) names.insert(stem + "[" + any_element() + "]");
  }
  for (const MessagePart& what : changed)
    for (const auto& [stem, names] : by_stem_)
      for (const MessagePart& name : names)
        if (!is_one_of_several(name) && changes_with(name, what)) moved_[what].insert(name);
}

const std::set<MessagePart>& OtherNames::moved_with(const MessagePart& changed) const {
  static const std::set<MessagePart> none;
  const auto found = moved_.find(changed);
  return found == moved_.end() ? none : found->second;
}

const std::string& OtherNames::family_of(const std::string& stem) const {
  const std::string* name = &stem;
  for (auto found = families_.find(*name); found != families_.end(); found = families_.find(*name))
    name = &found->second;
  return *name;
}

void OtherNames::unite(const std::string& one, const std::string& other) {
  const std::string& first = family_of(one);
  const std::string& second = family_of(other);
  if (first != second) families_.emplace(first, second);
}

std::vector<MessagePart> OtherNames::in_same_container(const MessagePart& part) const {
  std::vector<MessagePart> names;
  const auto found = by_stem_.find(stem_of(part));
  if (found == by_stem_.end()) return names;
  for (const MessagePart& other : found->second)
    if (other != message_of(part)) names.push_back(other);
  return names;
}

/// What a function stores, or returns, of what it is given: a pointer or reference to it stays, and is another name.
void OtherNames::unite_kept_parameters(const Facts& facts) {
  std::set<std::string> kept;
  std::multimap<std::string, std::string> given;  // parameter -> what calls give it
  for_each_event(facts, [&](const ContentEvent& event) {
    if (is_name(event) && !is_local(event.part) && is_parameter(event.other))
      kept.insert(stem_of(event.other));
    for (const auto& [parameter, part] : event.passed) given.emplace(parameter, stem_of(part));
  });
  while (!kept.empty()) {
    const std::string parameter = *kept.begin();
    kept.erase(kept.begin());
    const auto [first, last] = given.equal_range(parameter);
    for (auto item = first; item != last; ++item) {
      unite(parameter, item->second);
      if (is_parameter(item->second)) kept.insert(item->second);
    }
    given.erase(first, last);
  }
}

/// A function that is given what it names itself, too, as filled(image_) of a member function that reads image_; also by a function
/// that was given it.
void OtherNames::unite_named_arguments(const Facts& facts) {
  GivenAs given;
  const auto note = [&](const ContentEvent& call) {
    for (const auto& [parameter, part] : call.passed)
      given.emplace(stem_of(part), std::pair(call.callee, stem_of(parameter)));
  };
  for_each_event(facts, [&](const ContentEvent& event) {
    note(event);
    for (const std::string& other : overrides_of(event.callee, facts)) note(call_of_override(event, other));
  });
  const NamedStems named = lasting_stems(facts);
  for (auto next = given.begin(); next != given.end(); next = given.upper_bound(next->first))
    if (outlives_functions(next->first)) unite_with_parameters(next->first, given, named);
}

void OtherNames::unite_with_parameters(const std::string& stem, const GivenAs& given,
                                       const NamedStems& named) {
  std::set<std::string> seen;
  std::vector<std::string> open{stem};
  while (!open.empty()) {
    const auto [first, last] = given.equal_range(open.back());
    open.pop_back();
    for (auto item = first; item != last; ++item) {
      const auto& [function, parameter] = item->second;
      if (!seen.insert(parameter).second) continue;
      open.push_back(parameter);
      const auto names = named.find(function);
      if (names != named.end() && names->second.count(stem) != 0) unite(parameter, stem);
    }
  }
}

/// A call returns what any function that overrides the callee does.
void OtherNames::unite_results(const Facts& facts, const std::string& callee) {
  const auto found = facts.overrides.find(callee);
  if (found == facts.overrides.end()) return;
  for (const std::string& other : found->second) unite(result_root(callee), result_root(other));
}

std::vector<MessagePart> OtherNames::of(const MessagePart& part) const {
  std::vector<MessagePart> names;
  const auto found = by_family_.find(family_of(stem_of(part)));
  if (found == by_family_.end()) return names;
  const MessagePart message = message_of(part);
  for (const MessagePart& other : found->second)
    if (other != message && !are_two_messages(other, message))
      names.push_back(other + part.substr(message.size()));
  return names;
}

}  // namespace tzc::rewriter
