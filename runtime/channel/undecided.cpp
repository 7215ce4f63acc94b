// SPDX-License-Identifier: BSD-3-Clause
#include "channel/undecided.h"

#include <algorithm>

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t most_spare = 64;

bool same_block(const segment::BlockName& a, const segment::BlockName& b) {
  return a.segment == b.segment && a.slot == b.slot && a.generation == b.generation;
}

bool refers_to(const Undecided::Entry& entry, const segment::BlockName& block) {
  return std::any_of(entry.claims.begin(), entry.claims.end(),
                     [&block](const Claim& claim) { return same_block(claim.block, block); });
}

}  // namespace

Undecided::Entry& Undecided::push(std::uint32_t sequence) {
  if (spare_.empty()) spare_.emplace_back();
  entries_.push_back(std::move(spare_.back()));
  spare_.pop_back();
  entries_.back().sequence = sequence;
  return entries_.back();
}

void Undecided::drop_newest() {
  entries_.pop_back();
}

void Undecided::drop_oldest() {
  Entry& entry = entries_.front();
  entry.body.clear();
  entry.record.reset();
  entry.claims.clear();
  if (spare_.size() < most_spare) spare_.push_back(std::move(entry));
  entries_.pop_front();
}

const Undecided::Entry* Undecided::find_last(const segment::BlockName& block) const {
  const auto found = std::find_if(entries_.rbegin(), entries_.rend(),
                                  [&block](const Entry& entry) { return refers_to(entry, block); });
  return found == entries_.rend() ? nullptr : &*found;
}

}  // namespace channel
}  // namespace tzc
