// SPDX-License-Identifier: BSD-3-Clause
#include "solve/copied_elements.h"

#include <algorithm>
#include <utility>

#include "model/codes.h"
#include "solve/callers.h"

namespace tzc::rewriter {
namespace {

MessagePart only_lasting(const MessagePart& part) {
  return outlives_functions(part) ? part : MessagePart();
}

std::string root_of(const MessagePart& part) {
  return part.substr(0, part.find('/'));
}

/// A function's next result is another object.
ContentState without(const MessagePart& result, ContentState state) {
  if (!result.empty()) state.reset(result);
  return state;
}

/// What callers give that are not known has content which none of the package's publishes shares.
ContentState given_from_outside(const std::string& usr, const ContentFlow& flow) {
  ContentState state;
  const auto fill = [&](const MessagePart& part) {
    const MessagePart root = root_of(part);
    if (is_parameter(root) && root.size() > usr.size() &&
        root.compare(root.size() - usr.size(), usr.size(), usr) == 0)
      state.fill(root);
  };
  for (const ContentBlock& block : flow.blocks)
    for (const ContentEvent& event : block.events) {
      fill(event.part);
      fill(event.other);
      for (const auto& [parameter, part] : event.passed) fill(part);
    }
  return state;
}

/// The name may denote what any other one of its family does; an element is not its container.
void refresh(const OtherNames& names, const MessagePart& name, ContentState& state) {
  for (const MessagePart& other : names.of(name))
    if (!is_element_of(name, other)) state.alias_perhaps(name, other);
}

/// Whatever else it may be called has such elements, too, perhaps.
void fill(const OtherNames& names, const MessagePart& part, ContentState& state) {
  state.fill(part);
  for (const MessagePart& other : names.of(part)) state.fill(other);
}

/// Its other names denote the same.
void spread(const OtherNames& names, const MessagePart& part, ContentState& state) {
  for (const MessagePart& other : names.of(part)) state.alias_perhaps(other, part);
}

}  // namespace

CopiedElements::CopiedElements(const Facts& facts, IsTwin is_twin)
    : facts_(facts), other_names_(facts), unfollowed_(facts, other_names_, std::move(is_twin)) {
  add_functions();
  touch_what_callees_touch();
  find_what_may_be_any();
  for (auto& [usr, function] : functions_)
    if (called_from_outside(usr)) function.entry = given_from_outside(usr, *function.flow);
  while (changed_) {
    changed_ = false;
    for (auto& [usr, function] : functions_)
      if (function.entry) run(usr, function);
  }
}

/// A function is followed with the state of what it touches alone: of a whole package's members that may be little.
bool CopiedElements::Function::touches(const MessagePart& part) const {
  return outlives_functions(part) && touched.count(root_of(part)) != 0;
}

ContentState CopiedElements::Function::touched_of(const ContentState& state) const {
  return state.renamed([this](const MessagePart& part) { return touches(part) ? part : MessagePart(); });
}

void CopiedElements::add_functions() {
  for (const auto& [usr, flow] : facts_.contents) {
    Function& function = functions_[usr];
    function.flow = &flow;
    const auto touch = [&](const MessagePart& part) {
      if (outlives_functions(part)) function.touched.insert(root_of(part));
      for (const MessagePart& other : other_names_.of(part))
        if (outlives_functions(other)) function.touched.insert(root_of(other));
    };
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) {
        unfollowed_.note(usr, event);
        touch(event.part);
        if (event.kind == ContentEvent::Kind::moved)
          for (const MessagePart& name : other_names_.moved_with(event.part)) touch(name);
        touch(event.other);
        for (const auto& item : event.passed) touch(item.second);
        if (event.kind != ContentEvent::Kind::call || event.callee == usr) continue;
        if (event.callee.empty()) calls_unknown_.insert(usr);
        called_.insert(event.callee);
        const std::set<std::string>& others = overrides_of(event.callee, facts_);
        called_.insert(others.begin(), others.end());
      }
  }
}

void CopiedElements::touch_what_callees_touch() {
  Callers(facts_).learn([this](const std::string& caller, const std::string& callee) {
    const auto found = functions_.find(callee);
    if (found == functions_.end()) return false;
    std::set<std::string>& touched = functions_.at(caller).touched;
    const std::size_t before = touched.size();
    touched.insert(found->second.touched.begin(), found->second.touched.end());
    const bool learns = calls_unknown_.count(callee) != 0 && calls_unknown_.insert(caller).second;
    return learns || touched.size() > before;
  });
}

/// By the middleware, a timer or main's caller: no function of the package calls it. Objects may also end, or be called, in a library.
bool CopiedElements::called_from_outside(const std::string& usr) const {
  return called_.count(usr) == 0 || facts_.addressed.count(usr) != 0 || is_called_by_holders(usr);
}

/// What a function object or pointer may call, or a library that runs callbacks.
bool CopiedElements::may_be_any(const std::string& usr) const {
  const bool is_main = usr.rfind("c:@F@main#", 0) == 0;
  return called_from_outside(usr) && !is_main && !functions_.at(usr).flow->makes_object;
}

/// Of functions that have no member in common, none can tell what the other did.
void CopiedElements::find_what_may_be_any() {
  for (const std::string& usr : calls_unknown_) {
    Function& caller = functions_.at(usr);
    for (const auto& [name, other] : functions_) {
      const bool shares =
          std::any_of(other.touched.begin(), other.touched.end(),
                      [&](const std::string& root) { return caller.touched.count(root) != 0; });
      if (shares && name != usr && may_be_any(name)) caller.may_call.push_back(name);
    }
  }
}

/// False: no call that the block makes has returned yet.
bool CopiedElements::step(const std::string& usr, const ContentBlock& block, Others& others,
                          ContentState& state) {
  for (const ContentEvent& event : block.events) {
    if (event.kind != ContentEvent::Kind::call || event.callee == usr) {
      apply(event, state);
      continue;
    }
    const bool calls_any = calls_unknown(event);
    if (calls_any) others.run(state);
    if (event.callee.empty()) continue;
    std::optional<ContentState> after = after_call(event, state, usr);
    if (!after) return false;
    state = std::move(*after);
    if (calls_any) others.run(state);
  }
  return true;
}

void CopiedElements::run(const std::string& usr, Function& function) {
  const std::vector<ContentBlock>& blocks = function.flow->blocks;
  std::vector<std::optional<ContentState>> states(blocks.size());
  states[0] = function.entry;
  Others others{left_by_others(function), {}};
  std::set<unsigned> open{0};
  while (!open.empty()) {
    const unsigned index = *open.begin();
    open.erase(open.begin());
    ContentState state = *states[index];
    if (!step(usr, blocks[index], others, state)) continue;
    for (const unsigned next : blocks[index].next) {
      const bool is_new = !states[next];
      if (is_new)
        states[next] = state;
      else if (!states[next]->join(state))
        continue;
      open.insert(next);
    }
    if (index != function.flow->exit) continue;
    if (!function.exit) {
      function.exit = state;
      changed_ = true;
    } else {
      changed_ |= function.exit->join(state);
    }
  }
  if (others.given) enter_others(function, *others.given);
  leave(usr, function);
}

/// What a call from outside leaves behind is what the next one may find.
void CopiedElements::leave(const std::string& usr, Function& function) {
  if (!called_from_outside(usr)) return;
  if (function.exit) changed_ |= anytime_.join(function.exit->renamed(only_lasting));
  if (function.flow->makes_object) return;
  changed_ |= function.entry->join(function.touched_of(anytime_));
}

void CopiedElements::apply(const ContentEvent& event, ContentState& state) {
  switch (event.kind) {
    case ContentEvent::Kind::make:
      return state.make(event.part);
    case ContentEvent::Kind::reset:
      state.reset(event.part);
      if (!event.empties) fill(other_names_, event.part, state);
      return;
    case ContentEvent::Kind::fill:
      return fill(other_names_, event.part, state);
    case ContentEvent::Kind::copy:
      return state.copy(event.part, event.other, event.where);
    case ContentEvent::Kind::exchange:
      return state.exchange(event.part, event.other);
    case ContentEvent::Kind::alias:
      state.alias(event.part, event.other);
      for (const MessagePart& name : other_names_.in_same_container(event.part))
        refresh(other_names_, name, state);
      return;
    case ContentEvent::Kind::moved:
      for (const MessagePart& name : other_names_.moved_with(event.part)) refresh(other_names_, name, state);
      return;
    case ContentEvent::Kind::perhaps:
      state.alias_perhaps(event.part, event.other);
      for (const MessagePart& name : other_names_.in_same_container(event.part))
        state.alias_perhaps(name, event.part);
      return;
    case ContentEvent::Kind::take:
      state.take(event.part, {event.where});
      if (event.part.find('/') != MessagePart::npos)
        spread(other_names_, event.part, state);  // not of a container itself
      return;
    case ContentEvent::Kind::publish:
      new_.emplace(event.site, true).first->second &=
          state.is_new(event.part);  // states only lose what is new
      if (const std::optional<Taken> taken = state.publish(event.part, event.site))
        causes_.taken(event.site, *taken);
      for (const MessagePart& other : other_names_.of(event.part)) state.share_anew(other, {event.site});
      return;
    case ContentEvent::Kind::write:
      for (const PublishPlace& site : state.write(event.part)) causes_.written(site, event.where);
      return fill(other_names_, event.part, state);
    case ContentEvent::Kind::grow:
      for (const PublishPlace& site : state.sharers_of(event.part)) causes_.grown(site, event.where);
      return fill(other_names_, event.part, state);
    case ContentEvent::Kind::any:
    case ContentEvent::Kind::call:
      return;
  }
}

void CopiedElements::enter(const std::string& usr, const ContentState& state) {
  Function& callee = functions_.at(usr);
  if (callee.entry) {
    changed_ |= callee.entry->join(state);
    return;
  }
  callee.entry = state;
  changed_ = true;
}

/// Whether the call may run what nothing names, or a function of the package does that it may run.
bool CopiedElements::calls_unknown(const ContentEvent& call) const {
  if (call.callee.empty()) return true;
  const auto& others = overrides_of(call.callee, facts_);
  return calls_unknown_.count(call.callee) != 0 ||
         std::any_of(others.begin(), others.end(),
                     [&](const std::string& other) { return calls_unknown_.count(other) != 0; });
}

/// What the callee does, or any function that overrides it. None: none of them has returned yet.
std::optional<ContentState> CopiedElements::after_call(const ContentEvent& event, const ContentState& before,
                                                       const std::string& caller) {
  const std::set<std::string>& others = overrides_of(event.callee, facts_);
  if (others.empty()) return after(event, before);
  std::optional<ContentState> all;
  const auto add = [&](const ContentEvent& call) {
    const std::optional<ContentState> one = after(call, before);
    if (one && all)
      all->join(*one);
    else if (one)
      all = one;
  };
  if (facts_.bodies.count(event.callee) != 0) add(event);
  for (const std::string& other : others)
    if (other != caller) add(call_of_override(event, other));  // which calls what it overrides itself
  return all;
}

/// They may have run before, or not. What is new to the caller stays new: others have objects of their own.
void CopiedElements::Others::run(ContentState& state) {
  if (given)
    given->join(state);
  else
    given = state;
  state.join_others(left);
}

ContentState CopiedElements::left_by_others(const Function& caller) const {
  ContentState left;
  for (const std::string& name : caller.may_call)
    if (const std::optional<ContentState>& exit = functions_.at(name).exit)
      left.join(caller.touched_of(*exit));
  return left;
}

void CopiedElements::enter_others(const Function& caller, const ContentState& given) {
  for (const std::string& name : caller.may_call) enter(name, functions_.at(name).touched_of(given));
}

/// None: no call of the function has returned yet.
std::optional<ContentState> CopiedElements::after(const ContentEvent& event, const ContentState& before) {
  const auto found = functions_.find(event.callee);
  if (found == functions_.end()) return without(event.part, before);
  const Function& callee = found->second;
  const auto to_callee = [&](const MessagePart& part) {
    for (const auto& [parameter, given] : event.passed)
      if (lies_in(part, given)) return parameter + part.substr(given.size());
    return callee.touches(part) ? part : MessagePart();
  };
  const MessagePart result = result_root(event.callee);
  const auto to_caller = [&](const MessagePart& part) {
    if (!event.part.empty() && lies_in(part, result)) return event.part + part.substr(result.size());
    for (const auto& [parameter, given] : event.passed)
      if (lies_in(part, parameter)) return given + part.substr(parameter.size());
    return only_lasting(part);
  };
  ContentState inside = before.renamed(to_callee);
  for (const auto& [parameter, given] :
       event.passed) {  // a part of a message that is shared, or filled, as a whole
    inside.share(parameter, before.sharers_of(given));
    if (before.is_unsent(given)) inside.fill(parameter);
    if (callee.touches(given)) inside.alias_perhaps(given, parameter);
  }
  enter(event.callee, inside);
  if (!callee.exit) return {};
  ContentState after = without(event.part, before).renamed([&](const MessagePart& part) {
    const bool given = std::any_of(event.passed.begin(), event.passed.end(), [&](const auto& item) {
      return lies_in(part, item.second) && !is_one_of_several(part);
    });
    return given || callee.touches(part) ? MessagePart() : part;
  });
  after.add(callee.exit->renamed(to_caller));
  for (const auto& [parameter, given] : event.passed)
    if (callee.exit->sharers_of(parameter).empty() && callee.exit->sharers_of(given).empty())
      after.unshare(given);
  for (const auto& [parameter, given] : event.passed) spread(other_names_, given, after);
  return after;
}

std::optional<Obstacle> CopiedElements::why_copied(const SiteId& site) const {
  const std::optional<Obstacle> why = causes_.why({site.file, site.begin});
  return why ? why : unfollowed_.why(site);
}

std::optional<Obstacle> CopiedElements::why_new(const SiteId& site) const {
  const auto found = new_.find({site.file, site.begin});
  if (found == new_.end() || !found->second) return {};
  return Obstacle{
      codes::TZC1022,
      "its object is new here each time, and its elements lie outside shared memory until it is published",
      {}};
}

}  // namespace tzc::rewriter
