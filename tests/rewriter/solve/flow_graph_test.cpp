// SPDX-License-Identifier: BSD-3-Clause
#include "solve/flow_graph.h"

#include <gtest/gtest.h>

#include "solve/facts_of.h"

namespace tzc::rewriter::test {
namespace {

std::vector<std::string> words(const std::vector<FlowStep>& path) {
  std::vector<std::string> words;
  for (const FlowStep& step : path) words.push_back(step.what);
  return words;
}

TEST(FlowGraph, reaches_what_is_connected_in_either_direction) {
  const Facts facts = FactsBuilder().flow("a", "b").flow("c", "b").flow("x", "y").facts;
  const FlowGraph graph(facts.flows);
  EXPECT_EQ(graph.reachable(id("a")), (std::set<EntityId>{id("a"), id("b"), id("c")}));
  EXPECT_EQ(graph.reachable(id("alone")), (std::set<EntityId>{id("alone")}));
}

TEST(FlowGraph, a_path_is_the_shortest_and_in_its_order) {
  const Facts facts = FactsBuilder().flow("a", "b").flow("b", "c").flow("c", "d").flow("a", "d").facts;
  const FlowGraph graph(facts.flows);
  EXPECT_EQ(words(graph.path(id("a"), id("c"))), (std::vector<std::string>{"a to b", "b to c"}));
  EXPECT_EQ(words(graph.path(id("d"), id("a"))), (std::vector<std::string>{"a to d"}));
}

TEST(FlowGraph, there_is_no_path_to_what_is_not_connected) {
  const Facts facts = FactsBuilder().flow("a", "b").facts;
  const FlowGraph graph(facts.flows);
  EXPECT_TRUE(graph.path(id("a"), id("c")).empty());
  EXPECT_TRUE(graph.path(id("a"), EntityId()).empty());
  EXPECT_TRUE(graph.path(id("a"), id("a")).empty());
}

}  // namespace
}  // namespace tzc::rewriter::test
