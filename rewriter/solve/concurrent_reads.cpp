// SPDX-License-Identifier: BSD-3-Clause
#include "solve/concurrent_reads.h"

#include <algorithm>

namespace tzc::rewriter {

namespace {

/// "c:@S@Node@F@Node#...": no other thread has the object yet.
bool is_constructor(const std::string& usr) {
  const std::size_t function = usr.rfind("@F@");
  if (function == std::string::npos) return false;
  const std::string name = "@" + usr.substr(function + 3, usr.find('#', function) - function - 3);
  return function >= name.size() && usr.compare(function - name.size(), name.size(), name) == 0;
}

const std::string& code_of(const std::string& function, const PublishEvent& event) {
  return event.closure.empty() ? function : event.closure;
}

}  // namespace

ConcurrentReads::ConcurrentReads(const Facts& facts, const Components& components)
    : facts_(facts), components_(components) {
  for (const auto& [usr, events] : facts.effects)
    for (const PublishEvent& event : events)
      if (!event.callee.empty()) callers_[event.callee].insert(code_of(usr, event));
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
    for (const PublishEvent& event : events) {
      const bool publishes = event.kind == PublishEvent::Kind::publish &&
                             std::any_of(event.messages.begin(), event.messages.end(),
                                         [&](const EntityId& message) { return is_in(message, component); });
      if (!publishes) continue;
      const Functions callers = callers_of(code_of(usr, event));
      publishers.roots.merge(roots_among(callers));
      publishers.exclude = publishers.exclude && excludes_others(callers);
    }
  }
  return publishers;
}

/// Whether no two threads run the root at once. What no code of the package names is main, or a library's to call.
bool ConcurrentReads::is_run_by_one(const std::string& root) const {
  const auto places = facts_.run_by_one.find(root);
  return facts_.run_by_any.count(root) == 0 &&
         (places == facts_.run_by_one.end() || places->second.size() == 1);
}

bool ConcurrentReads::may_meet(const Functions& roots, const Functions& others) const {
  return std::any_of(roots.begin(), roots.end(), [&](const std::string& root) {
    return std::any_of(others.begin(), others.end(),
                       [&](const std::string& other) { return other != root || !is_run_by_one(root); });
  });
}

/// What reads the component's elements, and is not kept from doing so while others publish.
std::vector<ConcurrentReads::Reader> ConcurrentReads::readers_of(const Component& component,
                                                                 const Publishers& publishers) const {
  Functions writing;
  for (const ElementUse& use : facts_.element_uses)
    if (use.kind == ElementUse::Kind::write && is_in(use.message, component)) writing.insert(use.code);
  std::vector<Reader> readers;
  for (const ElementUse& use : facts_.element_uses) {
    if (!is_in(use.message, component) || writing.count(use.code) != 0) continue;
    const Functions callers = callers_of(use.code);
    if (publishers.exclude && excludes_others(callers)) continue;
    readers.push_back({&use, roots_among(callers)});
  }
  return readers;
}

/// A closure that another thread may run uses a message of the function around it.
bool ConcurrentReads::is_captured(const Component& component) const {
  const auto is_here = [&](const EntityId& message) { return is_in(message, component); };
  for (const ElementUse& use : facts_.element_uses)
    if (use.captured && is_here(use.message)) return true;
  for (const auto& [usr, events] : facts_.effects)
    for (const PublishEvent& event : events)
      if (event.captured && std::any_of(event.messages.begin(), event.messages.end(), is_here)) return true;
  return false;
}

const ElementUse* ConcurrentReads::of(const Component& component) {
  if (!component.has_lasting_message() && !is_captured(component)) return nullptr;
  const Publishers publishers = publishers_of(component);
  const std::vector<Reader> readers = readers_of(component, publishers);
  for (const Reader& reader : readers) {
    if (!may_meet(reader.roots, publishers.roots)) continue;
    const bool walks = reader.use->kind == ElementUse::Kind::walk;
    const bool moved = std::any_of(readers.begin(), readers.end(), [&](const Reader& other) {
      return !other.use->read_only &&
             (may_meet(reader.roots, other.roots) || (walks && may_meet(other.roots, publishers.roots)));
    });
    if (moved) return reader.use;
  }
  return nullptr;
}

}  // namespace tzc::rewriter
