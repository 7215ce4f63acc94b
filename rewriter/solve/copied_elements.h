// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/facts.h"
#include "solve/content_state.h"
#include "solve/copy_causes.h"
#include "solve/other_names.h"
#include "solve/unfollowed_uses.h"

namespace tzc::rewriter {

/// Which publishes of a tzc:: message cost a copy of its elements all the same: because they lie outside shared memory when
/// they are published, or because the program writes them again later, while subscribers share them. It decides
/// levels only, never whether a port is right.
class CopiedElements {
 public:
  explicit CopiedElements(const Facts& facts, IsTwin is_twin = any_is_twin);

  /// None: no path to the call, and none from it, copies them.
  std::optional<Obstacle> why_copied(const SiteId& site) const;
  /// None: the member that is published there may have been published before.
  std::optional<Obstacle> why_new(const SiteId& site) const;

 private:
  struct Function {
    const ContentFlow* flow = nullptr;
    std::set<std::string> touched;      ///< what outlives functions and it, or what it calls, names
    std::vector<std::string> may_call;  ///< where nothing shows what it calls: what others may call, too
    std::optional<ContentState> entry, exit;  ///< none: the function is not called, does not return

    bool touches(const MessagePart& part) const;
    ContentState touched_of(const ContentState& state) const;
  };
  /// The functions that the unknown calls of one function may run.
  struct Others {
    ContentState left;                  ///< by any of them
    std::optional<ContentState> given;  ///< to them, by any of the calls

    void run(ContentState& state);
  };

  void add_functions();
  void touch_what_callees_touch();
  bool called_from_outside(const std::string& usr) const;
  bool may_be_any(const std::string& usr) const;
  void find_what_may_be_any();
  void run(const std::string& usr, Function& function);
  bool step(const std::string& usr, const ContentBlock& block, Others& others, ContentState& state);
  void apply(const ContentEvent& event, ContentState& state);
  std::optional<ContentState> after_call(const ContentEvent& event, const ContentState& before,
                                         const std::string& caller);
  bool calls_unknown(const ContentEvent& call) const;
  ContentState left_by_others(const Function& caller) const;
  void enter_others(const Function& caller, const ContentState& given);
  std::optional<ContentState> after(const ContentEvent& call, const ContentState& before);
  void enter(const std::string& usr, const ContentState& state);
  void leave(const std::string& usr, Function& function);

  const Facts& facts_;
  const OtherNames other_names_;
  UnfollowedUses unfollowed_;
  std::map<std::string, Function> functions_;
  std::set<std::string> called_;
  std::set<std::string> calls_unknown_;  ///< functions that call what nothing shows
  ContentState anytime_;                 ///< of what outlives functions, when one is called from outside
  CopyCauses causes_;
  std::map<PublishPlace, bool> new_;  ///< whether what is published there is new, on all paths so far
  bool changed_ = true;
};

}  // namespace tzc::rewriter
