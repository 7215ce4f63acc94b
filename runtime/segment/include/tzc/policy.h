// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {

/// What `allocate` does when the publisher's memory is full. None of them ever blocks.
///
/// Memory is reclaimed lazily. Before a message is discarded, what is in flight by the grace of PublisherOptions::buffered_bytes
/// is revoked, with every policy. The policies differ in what happens to blocks that are still in use (referenced by
/// this process, in flight to a subscriber, or held by one):
///  - worst_effort reclaims in order of publication: the new message is discarded while the oldest one is in use;
///  - medium_effort reclaims everything that is free, wherever it lies, and discards the new message when that is not
///    enough;
///  - best_effort does the same, then revokes blocks in flight, oldest first. A subscriber that loses one counts it as
///    lost; a block that a subscriber already took is never revoked, nor one to which the program has a BufferPtr of its
///    own (which would free nothing).
enum class PolicyKind { best_effort, medium_effort, worst_effort };

/// What a publisher does when its memory is used up. A value, free to copy.
struct Policy {
  PolicyKind kind = PolicyKind::medium_effort;
  /// medium_effort: how many blocks that one holder released and another still uses one allocate examines
  /// before it takes fresh memory. Before it discards a message it examines all.
  unsigned attempts = 64;

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
