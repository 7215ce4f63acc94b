// SPDX-License-Identifier: BSD-3-Clause
#include "solve/running_code.h"

#include <algorithm>
#include <iterator>

namespace tzc::rewriter {
namespace {

/// "c:@S@Node@F@Node#...": no other thread has the object yet.
bool is_constructor(const std::string& usr) {
  const std::size_t function = usr.rfind("@F@");
  if (function == std::string::npos) return false;
  const std::string name = "@" + usr.substr(function + 3, usr.find('#', function) - function - 3);
  return function >= name.size() && usr.compare(function - name.size(), name.size(), name) == 0;
}

/// main, and onInit of a nodelet.
bool is_called_once(const std::string& usr) {
  return usr.rfind("c:@F@main#", 0) == 0 || usr.find("@F@onInit#") != std::string::npos;
}

RunningCode::Names common(const RunningCode::Names& one, const RunningCode::Names& other) {
  RunningCode::Names both;
  std::set_intersection(one.begin(), one.end(), other.begin(), other.end(),
                        std::inserter(both, both.begin()));
  return both;
}

}  // namespace

const std::string& code_of(const std::string& function, const PublishEvent& event) {
  return event.closure.empty() ? function : event.closure;
}

RunningCode::RunningCode(const Facts& facts) : facts_(facts) {
  add_calls();
  find_locks();
  find_synchronizing();
}

void RunningCode::add_calls() {
  for (const auto& [usr, events] : facts_.effects)
    for (const PublishEvent& event : events)
      if (!event.callee.empty()) calls_[event.callee].push_back({code_of(usr, event), event.locks});
  for (const auto& [function, others] : facts_.overrides)
    for (const std::string& other : others) calls_[other].push_back({function, {}});
}

/// No function of the package calls it, or one that is not called is named.
bool RunningCode::is_root(const std::string& code) const {
  return calls_.count(code) == 0 || facts_.addressed.count(code) != 0;
}

/// What all ways into the code have. None: no way is known yet.
std::optional<RunningCode::Names> RunningCode::locks_at_entry(const std::string& code) const {
  if (is_root(code)) return Names();
  std::optional<Names> all;
  for (const Call& call : calls_.at(code)) {
    if (is_constructor(call.caller)) continue;
    const auto caller = locks_.find(call.caller);
    if (caller == locks_.end() && !is_root(call.caller)) continue;
    Names here = call.locks;
    if (caller != locks_.end()) here.insert(caller->second.begin(), caller->second.end());
    all = all ? common(*all, here) : std::move(here);
  }
  return all;
}

/// Each pass takes locks away that another way does not have.
void RunningCode::find_locks() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& item : calls_) {
      const std::optional<Names> now = locks_at_entry(item.first);
      if (!now) continue;
      const auto [known, is_new] = locks_.emplace(item.first, *now);
      changed |= is_new || known->second != *now;
      known->second = *now;
    }
  }
}

/// And all code that calls such code.
RunningCode::Names RunningCode::with_callers(Names codes) const {
  std::vector<std::string> open(codes.begin(), codes.end());
  while (!open.empty()) {
    const auto calls = calls_.find(open.back());
    open.pop_back();
    if (calls == calls_.end()) continue;
    for (const Call& call : calls->second)
      if (codes.insert(call.caller).second) open.push_back(call.caller);
  }
  return codes;
}

void RunningCode::find_synchronizing() {
  for_threads_ = with_callers(facts_.synchronizing);
  Names unknown = for_threads_;
  unknown.insert(facts_.handing_over.begin(), facts_.handing_over.end());
  for (const auto& [usr, events] : facts_.effects)
    for (const PublishEvent& event : events)
      if (event.kind == PublishEvent::Kind::unknown) unknown.insert(code_of(usr, event));
  for (const auto& item : calls_)
    if (facts_.bodies.count(item.first) == 0) unknown.insert(item.first);
  synchronizing_ = with_callers(std::move(unknown));
}

RunningCode::Names RunningCode::roots_of(const std::string& code) const {
  Names seen{code}, roots;
  std::vector<std::string> open{code};
  while (!open.empty()) {
    const std::string here = std::move(open.back());
    open.pop_back();
    if (is_root(here)) roots.insert(here);
    const auto calls = calls_.find(here);
    if (calls == calls_.end()) continue;
    for (const Call& call : calls->second)
      if (!is_constructor(call.caller) && seen.insert(call.caller).second) open.push_back(call.caller);
  }
  return roots;
}

RunningCode::Spot RunningCode::spot(const std::string& code, const Names& locks) const {
  Spot spot{code, roots_of(code), locks};
  if (const auto entry = locks_.find(code); entry != locks_.end())
    spot.locks.insert(entry->second.begin(), entry->second.end());
  return spot;
}

/// Whether no two threads run the root at once. What nobody hands over, users of the package call, or a library does that has the function
/// which it overrides: by the language's convention not for one object at once, unless it says how threads meet there.
bool RunningCode::is_run_by_one(const std::string& root) const {
  const auto starts = facts_.starts.find(root);
  if (starts == facts_.starts.end())
    return is_called_once(root) || (facts_.bodies.count(root) != 0 && for_threads_.count(root) == 0);
  return !starts->second.by_any && starts->second.by_one.size() == 1;
}

bool RunningCode::is_for_thread(const Spot& spot) const {
  return std::any_of(spot.roots.begin(), spot.roots.end(), [&](const std::string& root) {
    const auto starts = facts_.starts.find(root);
    return starts != facts_.starts.end() && starts->second.by_thread;
  });
}

bool RunningCode::may_meet(const Spot& one, const Spot& other) const {
  return std::any_of(one.roots.begin(), one.roots.end(), [&](const std::string& root) {
    return std::any_of(other.roots.begin(), other.roots.end(),
                       [&](const std::string& others) { return others != root || !is_run_by_one(root); });
  });
}

}  // namespace tzc::rewriter
