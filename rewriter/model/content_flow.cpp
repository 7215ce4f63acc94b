// SPDX-License-Identifier: BSD-3-Clause
#include "model/content_flow.h"

#include <iterator>
#include <tuple>

namespace tzc::rewriter {
namespace {

void append(std::vector<ContentBlock>& blocks, ContentFlow flow, unsigned exit) {
  const auto first = static_cast<unsigned>(blocks.size());
  for (ContentBlock& block : flow.blocks)
    for (unsigned& next : block.next) next += first;
  flow.blocks[flow.exit].next.push_back(exit);
  std::move(flow.blocks.begin(), flow.blocks.end(), std::back_inserter(blocks));
}

}  // namespace

bool operator==(const ContentEvent& a, const ContentEvent& b) {
  return std::tie(a.kind, a.part, a.other, a.site, a.empties, a.callee, a.passed, a.where.line) ==
         std::tie(b.kind, b.part, b.other, b.site, b.empties, b.callee, b.passed, b.where.line);
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

}  // namespace tzc::rewriter
