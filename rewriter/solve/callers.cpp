// SPDX-License-Identifier: BSD-3-Clause
#include "solve/callers.h"

namespace tzc::rewriter {

const std::set<std::string>& overrides_of(const std::string& usr, const Facts& facts) {
  static const std::set<std::string> none;
  const auto found = facts.overrides.find(usr);
  return found == facts.overrides.end() ? none : found->second;
}

ContentEvent call_of_override(const ContentEvent& call, const std::string& function) {
  ContentEvent other = call;
  other.callee = function;
  other.passed.clear();
  for (const auto& [parameter, given] : call.passed)  // "parameter 0 of CALLEE"
    other.passed.emplace(parameter.substr(0, parameter.size() - call.callee.size()) + function, given);
  return other;
}

Callers::Callers(const Facts& facts) {
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) {
        if (event.kind != ContentEvent::Kind::call || event.callee == usr) continue;
        callers_[event.callee].insert(usr);
        for (const std::string& other : overrides_of(event.callee, facts))
          if (other != usr) callers_[other].insert(usr);
      }
}

void Callers::learn(const Learn& learns) const {
  std::set<std::string> open;
  for (const auto& [callee, callers] : callers_) open.insert(callee);
  while (!open.empty()) {
    const std::string callee = *open.begin();
    open.erase(open.begin());
    const auto found = callers_.find(callee);
    if (found == callers_.end()) continue;
    for (const std::string& caller : found->second)
      if (learns(caller, callee)) open.insert(caller);
  }
}

}  // namespace tzc::rewriter
