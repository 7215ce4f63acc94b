// SPDX-License-Identifier: BSD-3-Clause
#include <clang/Analysis/CFG.h>

#include "facts/content_events.h"
#include "facts/content_reader.h"
#include "facts/decided_branches.h"

namespace tzc::rewriter {
namespace {

void append(std::vector<ContentEvent>& events, std::vector<ContentEvent> more) {
  std::move(more.begin(), more.end(), std::back_inserter(events));
}

/// Blocks in Clang's order, the entry first.
ContentFlow flow_of(const clang::CFG& cfg, const clang::FunctionDecl* function, ContentReader& reader,
                    const DecidedValues& values) {
  ContentFlow flow;
  flow.blocks.resize(cfg.size());
  append(flow.blocks.front().events, reader.events_of(function));
  const auto index = [&](const clang::CFGBlock& block) { return cfg.size() - 1 - block.getBlockID(); };
  for (const clang::CFGBlock* block : cfg) {
    ContentBlock& mine = flow.blocks[index(*block)];
    for (const clang::CFGElement& element : *block)
      if (const auto stmt = element.getAs<clang::CFGStmt>())
        append(mine.events, reader.events_of(stmt->getStmt()));
      else if (const auto initializer = element.getAs<clang::CFGInitializer>())
        append(mine.events, reader.events_of(initializer->getInitializer()));
    unsigned successor = 0;
    for (const clang::CFGBlock::AdjacentBlock& next : block->succs()) {
      const clang::CFGBlock* const reached = next.getReachableBlock();
      if (reached && may_go(*block, successor, values)) mine.next.push_back(index(*reached));
      ++successor;
    }
  }
  flow.exit = index(cfg.getExit());
  return flow;
}

/// The flow of a function of the view, or of a closure in it; none: it has no events.
std::optional<ContentFlow> flow_of(const Unit& unit, const FunctionView& view,
                                   const clang::FunctionDecl* function) {
  clang::CFG::BuildOptions options;
  options.setAllAlwaysAdd();
  options.AddInitializers = true;
  const std::unique_ptr<clang::CFG> cfg =
      clang::CFG::buildCFG(function, function->getBody(), &unit.ast(), options);
  if (!cfg) return {};
  ContentReader reader(unit, view);
  const std::vector<DecidedValues> ways = decided_ways(view, *cfg);
  ContentFlow flow = flow_of(*cfg, function, reader, ways.front());
  for (auto way = std::next(ways.begin()); way != ways.end(); ++way)
    flow.add_alternative(flow_of(*cfg, function, reader, *way));
  const bool is_empty =
      llvm::all_of(flow.blocks, [](const ContentBlock& block) { return block.events.empty(); });
  return is_empty ? std::nullopt : std::optional(std::move(flow));
}

}  // namespace

std::optional<ContentFlow> content_flow(const Unit& unit, const FunctionView& view) {
  std::optional<ContentFlow> flow = flow_of(unit, view, view.function());
  const bool has_lambda = llvm::any_of(
      view.statements(), [](const clang::Stmt* stmt) { return llvm::isa<clang::LambdaExpr>(stmt); });
  if (flow) flow->makes_object = llvm::isa<clang::CXXConstructorDecl>(view.function()) && !has_lambda;
  return flow;
}

std::optional<ContentFlow> content_flow(const Unit& unit, const FunctionView& view,
                                        const clang::LambdaExpr* closure) {
  return flow_of(unit, view, closure->getCallOperator());
}

}  // namespace tzc::rewriter
