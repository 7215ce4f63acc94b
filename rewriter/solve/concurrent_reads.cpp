// SPDX-License-Identifier: BSD-3-Clause
#include "solve/concurrent_reads.h"

#include <algorithm>
#include <vector>

namespace tzc::rewriter {

namespace {

/// "c:@S@Node@F@Node#...": no other thread has the object yet.
bool is_constructor(const std::string& usr) {
  const std::size_t function = usr.rfind("@F@");
  if (function == std::string::npos) return false;
  const std::string name = "@" + usr.substr(function + 3, usr.find('#', function) - function - 3);
  return function >= name.size() && usr.compare(function - name.size(), name.size(), name) == 0;
}

}  // namespace

ConcurrentReads::ConcurrentReads(const Facts& facts, const Components& components)
    : facts_(facts), components_(components) {
  for (const auto& [usr, events] : facts.effects)
    for (const PublishEvent& event : events)
      if (!event.callee.empty()) callers_[event.callee].insert(usr);
}

bool ConcurrentReads::is_in(const EntityId& message, const Component& component) const {
  const Component* of = components_.of(message);
  return of && of->id == component.id;
}

/// The function and all that lead to it.
ConcurrentReads::Functions ConcurrentReads::callers_of(const std::string& function) const {
  Functions found{function};
  std::vector<std::string> open{function};
  while (!open.empty()) {
    const auto callers = callers_.find(open.back());
    open.pop_back();
    if (callers == callers_.end()) continue;
    for (const std::string& caller : callers->second)
      if (!is_constructor(caller) && found.insert(caller).second) open.push_back(caller);
  }
  return found;
}

/// Those that a library, the system or a thread calls: no function of the package does, or one that is not called is named.
ConcurrentReads::Functions ConcurrentReads::roots_among(const Functions& functions) const {
  Functions roots;
  for (const std::string& function : functions)
    if (callers_.count(function) == 0 || facts_.addressed.count(function) != 0) roots.insert(function);
  return roots;
}

bool ConcurrentReads::excludes_others(const Functions& functions) const {
  return std::any_of(functions.begin(), functions.end(),
                     [&](const std::string& function) { return facts_.excluding.count(function) != 0; });
}

ConcurrentReads::Publishers ConcurrentReads::publishers_of(const Component& component) {
  Publishers publishers;
  for (const auto& [usr, events] : facts_.effects) {
    const bool publishes = std::any_of(events.begin(), events.end(), [&](const PublishEvent& event) {
      return event.kind == PublishEvent::Kind::publish &&
             std::any_of(event.messages.begin(), event.messages.end(),
                         [&](const EntityId& message) { return is_in(message, component); });
    });
    if (!publishes) continue;
    const Functions callers = callers_of(usr);
    publishers.roots.merge(roots_among(callers));
    publishers.exclude = publishers.exclude && excludes_others(callers);
  }
  return publishers;
}

/// One root is one callback, which roscpp does not call a second time meanwhile.
bool ConcurrentReads::may_meet(const ElementUse& use, const Publishers& publishers) {
  if (use.function.empty()) return !publishers.roots.empty();
  const Functions callers = callers_of(use.function);
  if (publishers.exclude && excludes_others(callers)) return false;
  const Functions roots = roots_among(callers);
  return std::any_of(roots.begin(), roots.end(), [&](const std::string& root) {
    return std::any_of(publishers.roots.begin(), publishers.roots.end(),
                       [&](const std::string& other) { return other != root; });
  });
}

const ElementUse* ConcurrentReads::of(const Component& component) {
  if (!component.has_lasting_message()) return nullptr;
  Functions writing;
  for (const ElementUse& use : facts_.element_uses)
    if (use.kind == ElementUse::Kind::write && is_in(use.message, component)) writing.insert(use.function);
  const Publishers publishers = publishers_of(component);
  const ElementUse* walk = nullptr;
  bool moves = false;
  for (const ElementUse& use : facts_.element_uses) {
    if (!is_in(use.message, component) || writing.count(use.function) != 0 || !may_meet(use, publishers))
      continue;
    moves = moves || !use.read_only;
    if (use.kind == ElementUse::Kind::walk && walk == nullptr) walk = &use;
  }
  return moves ? walk : nullptr;
}

}  // namespace tzc::rewriter
