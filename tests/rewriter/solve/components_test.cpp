// SPDX-License-Identifier: BSD-3-Clause
#include "solve/components.h"

#include <gtest/gtest.h>

#include "solve/facts_of.h"

namespace tzc::rewriter::test {
namespace {

TEST(Components, flow_unites_entities_of_one_role_only) {
  const Facts facts = FactsBuilder()
                          .add(entity("a", EntityRole::message))
                          .add(entity("b", EntityRole::message))
                          .add(entity("pub", EntityRole::publisher))
                          .flow("a", "b")
                          .flow("b", "pub")
                          .facts;
  const Components components(facts);
  EXPECT_EQ(components.of(id("a")), components.of(id("b")));
  EXPECT_NE(components.of(id("a")), components.of(id("pub")));
  EXPECT_EQ(components.of(id("a"))->kind, ComponentKind::message);
  EXPECT_EQ(components.of(id("pub"))->kind, ComponentKind::publisher);
  EXPECT_EQ(components.of(id("unknown")), nullptr);
}

TEST(Components, one_written_type_unites_its_declarators) {
  FactsBuilder builder;
  for (const char* name : {"a", "b"}) {
    Entity one = entity(name, EntityRole::message);
    one.changes = {{{"/p/node.cpp", 7, 12, 1, 1}, "tzc::", "message-type", {}}};
    builder.add(one);
  }
  const Components components(builder.facts);
  EXPECT_EQ(components.of(id("a")), components.of(id("b")));
}

TEST(Components, without_all_or_nothing_every_entity_stands_alone) {
  const Facts facts = FactsBuilder()
                          .add(entity("a", EntityRole::message))
                          .add(entity("b", EntityRole::message))
                          .flow("a", "b")
                          .facts;
  const Components components(facts, false);
  EXPECT_NE(components.of(id("a")), components.of(id("b")));
}

TEST(Components, a_subscription_is_a_component_of_its_own) {
  const Facts facts =
      FactsBuilder().add(entity("in", EntityRole::message)).subscribe("in").subscribe("").facts;
  const Components components(facts);
  ASSERT_EQ(components.all().size(), 3u);
  for (const auto& [site, fact] : facts.subscribes) {
    const Component* component = components.of(site);
    ASSERT_NE(component, nullptr);
    EXPECT_EQ(component->kind, ComponentKind::subscription);
    EXPECT_EQ(component->subscription, &fact);
    EXPECT_EQ(&components[component->id], component);
  }
}

}  // namespace
}  // namespace tzc::rewriter::test
