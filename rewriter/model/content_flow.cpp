// SPDX-License-Identifier: BSD-3-Clause
#include "model/content_flow.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "model/erase_if.h"

namespace tzc::rewriter {
namespace {

void append(std::vector<ContentBlock>& blocks, ContentFlow flow, unsigned exit) {
  const auto first = static_cast<unsigned>(blocks.size());
  for (ContentBlock& block : flow.blocks)
    for (unsigned& next : block.next) next += first;
  flow.blocks[flow.exit].next.push_back(exit);
  std::move(flow.blocks.begin(), flow.blocks.end(), std::back_inserter(blocks));
}

/// The blocks to which no other leads: the first, and those of code that never runs.
std::vector<unsigned> roots_of(const std::vector<ContentBlock>& blocks) {
  std::vector<bool> led_to(blocks.size());
  for (const ContentBlock& block : blocks)
    for (const unsigned next : block.next) led_to[next] = true;
  std::vector<unsigned> roots{0};
  for (unsigned i = 1; i < blocks.size(); ++i)
    if (!led_to[i]) roots.push_back(i);
  return roots;
}

std::vector<bool> reached_from(std::vector<unsigned> open, const std::vector<ContentBlock>& blocks) {
  std::vector<bool> reached(blocks.size());
  while (!open.empty()) {
    const unsigned at = open.back();
    open.pop_back();
    if (reached[at]) continue;
    reached[at] = true;
    open.insert(open.end(), blocks[at].next.begin(), blocks[at].next.end());
  }
  return reached;
}

}  // namespace

bool operator==(const ContentEvent& a, const ContentEvent& b) {
  return std::tie(a.kind, a.part, a.other, a.site, a.empties, a.callee, a.passed, a.where.line, a.named_by) ==
         std::tie(b.kind, b.part, b.other, b.site, b.empties, b.callee, b.passed, b.where.line, b.named_by);
}

void ContentFlow::add_alternative(ContentFlow other) {
  if (blocks == other.blocks) return;
  const auto mine = static_cast<unsigned>(blocks.size()), others = static_cast<unsigned>(other.blocks.size());
  const unsigned new_exit = 1 + mine + others;
  std::vector<ContentBlock> all{{{}, {1, 1 + mine}}};
  append(all, std::move(*this), new_exit);
  append(all, std::move(other), new_exit);
  all.emplace_back();
  blocks = std::move(all);
  exit = new_exit;
}

void ContentFlow::leave_out_all_but(const std::set<std::string>& shown) {
  const std::vector<unsigned> roots = roots_of(blocks);
  const std::vector<bool> before = reached_from(roots, blocks);
  const auto is_out = [&](unsigned block) { return !blocks[block].if_shown.is_met_by(shown); };
  for (ContentBlock& block : blocks) erase_if(block.next, is_out);
  const std::vector<bool> after = reached_from(roots, blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (before[i] && !after[i]) blocks[i] = ContentBlock();
}

bool ContentFlow::is_empty() const {
  return std::all_of(blocks.begin(), blocks.end(), [](auto& block) { return block.events.empty(); });
}

}  // namespace tzc::rewriter
