// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {

/// What `allocate` does when the publisher's memory is full. None of them ever blocks.
///
/// Memory is reclaimed lazily, oldest published block first. The policies differ in how they pass a block
/// that is still in use (referenced by this process, in flight to a subscriber, or held by one):
///  - worst_effort stops at the first one: the new message is discarded while the oldest one is in use;
///  - medium_effort passes over at most `attempts` of them, then discards the new message;
///  - best_effort passes over all of them and, when there is still no room, revokes blocks in flight, oldest
///  first.
///    A subscriber that loses one counts it as lost; a block that a subscriber already took is never revoked.
enum class PolicyKind { best_effort, medium_effort, worst_effort };

struct Policy {
  PolicyKind kind = PolicyKind::medium_effort;
  unsigned attempts = 64;  ///< medium_effort: blocks in use that one allocate passes over

  static Policy best_effort() { return make(PolicyKind::best_effort, 0); }
  static Policy medium_effort(unsigned attempts = 64) { return make(PolicyKind::medium_effort, attempts); }
  static Policy worst_effort() { return make(PolicyKind::worst_effort, 0); }

 private:
  static Policy make(PolicyKind kind, unsigned attempts) {
    Policy policy;
    policy.kind = kind;
    policy.attempts = attempts;
    return policy;
  }
};

}  // namespace tzc
