// SPDX-License-Identifier: BSD-3-Clause
// What is decided, from facts by hand: no source, no compiler.
#include "solve/solve.h"

#include <gtest/gtest.h>

#include "solve/describe_sites.h"
#include "solve/facts_of.h"
#include "solve/port_edits.h"

namespace tzc::rewriter::test {
namespace {

/// A solved package.
class Solved {
 public:
  explicit Solved(FactsBuilder builder, SolveOptions options = {}, const std::string& demoted = "")
      : facts_(std::move(builder.facts)), components_(facts_), options_(std::move(options)) {
    options_.packages = std::string("/p");
    Demotions demotions;
    if (!demoted.empty())
      demotions[components_.of(id(demoted))->id] = {"TZC1009", "it would not compile", {"/p/node.cpp", 8, 1}};
    solution_ = solve(facts_, components_, options_, demotions);
  }

  const Decision* of(const std::string& entity) const { return solution_.of(components_.of(id(entity))->id); }
  Outcome outcome(const std::string& entity) const { return of(entity)->outcome; }
  std::string code(const std::string& entity) const { return of(entity)->why_not.code; }
  Site site(SiteKind kind) const {
    for (const Site& site : describe_sites(facts_, components_, options_, solution_))
      if (site.kind == kind) return site;
    ADD_FAILURE() << "no such site";
    return {};
  }
  Level level(SiteKind kind) const { return site(kind).level; }
  std::vector<std::string> edits() const {
    std::vector<std::string> texts;
    for (const Edit& edit : edits_of(facts_, components_, solution_, options_).edits)
      texts.push_back(edit.text);
    return texts;
  }

 private:
  Facts facts_;
  Components components_;
  SolveOptions options_;
  Solution solution_;
};

TEST(Solve, a_message_with_a_publisher_at_its_allocation_goes_without_a_copy) {
  const Solved camera_node(camera());
  EXPECT_EQ(camera_node.outcome("pub"), Outcome::ported);
  EXPECT_EQ(camera_node.outcome("image"), Outcome::ported);
  EXPECT_EQ(camera_node.level(SiteKind::publish), Level::zero_copy);
  EXPECT_EQ(camera_node.level(SiteKind::advertise), Level::zero_copy);
  EXPECT_EQ(camera_node.edits(), (std::vector<std::string>{"\npub.allocate(image);"}));
}

TEST(Solve, an_obstacle_of_the_message_costs_one_copy) {
  const Solved node(camera().obstacle("image", "TZC1003"));
  EXPECT_EQ(node.outcome("pub"), Outcome::ported);
  EXPECT_EQ(node.code("image"), "TZC1003");
  EXPECT_EQ(node.level(SiteKind::publish), Level::one_copy);
  EXPECT_EQ(node.level(SiteKind::advertise), Level::one_copy);
  EXPECT_TRUE(node.edits().empty());
}

TEST(Solve, an_obstacle_anywhere_in_a_component_refuses_all_of_it) {
  const Solved node(camera()
                        .add(entity("other", EntityRole::message))
                        .flow("image", "other", 4)
                        .obstacle("other", "TZC1002"));
  EXPECT_EQ(node.code("image"), "TZC1002");
  EXPECT_EQ(node.of("image")->at, id("other"));
  const Site site = node.site(SiteKind::publish);
  ASSERT_EQ(site.flow_path.size(), 2u);
  EXPECT_EQ(site.flow_path[0].what, "image to other");
  EXPECT_EQ(site.flow_path[1].what, "reason of TZC1002");
}

TEST(Solve, an_obstacle_of_the_publisher_leaves_everything_plain) {
  const Solved node(camera().obstacle("pub", "TZC1010"));
  EXPECT_EQ(node.code("pub"), "TZC1010");
  EXPECT_EQ(node.code("image"), "TZC1009");
  EXPECT_EQ(node.level(SiteKind::publish), Level::plain);
  EXPECT_EQ(node.level(SiteKind::advertise), Level::plain);
}

TEST(Solve, a_publisher_that_the_package_does_not_advertise_is_refused) {
  const Solved node(FactsBuilder()
                        .add(entity("pub", EntityRole::publisher))
                        .add(entity("image", EntityRole::message))
                        .allocation("image", "pub")
                        .publish("pub", "image"));
  EXPECT_EQ(node.code("pub"), "TZC1017");
}

TEST(Solve, an_allocation_without_a_publisher_takes_memory_of_the_node) {
  const Solved node(FactsBuilder()
                        .add(entity("pub", EntityRole::publisher))
                        .add(entity("image", EntityRole::message))
                        .advertise("pub")
                        .allocation("image", "")
                        .publish("pub", "image"));
  EXPECT_EQ(node.level(SiteKind::publish), Level::zero_copy);
  EXPECT_EQ(node.edits(), (std::vector<std::string>{"\ntzc::allocate(image);"}));
}

TEST(Solve, an_allocation_that_has_no_place_costs_one_copy) {
  FactsBuilder builder = camera();
  std::get<InsertedAllocation>(builder.facts.allocations[0].how).at.reset();
  const Solved node(builder);
  EXPECT_EQ(node.code("image"), "TZC1019");
  EXPECT_EQ(node.level(SiteKind::publish), Level::one_copy);
}

TEST(Solve, instances_of_one_text_take_memory_of_the_node_if_one_of_them_names_no_publisher) {
  FactsBuilder builder = camera();
  AllocationSite unnamed = builder.facts.allocations[0];
  unnamed.publishers.clear();
  builder.facts.allocations.push_back(unnamed);
  EXPECT_EQ(Solved(builder).edits(),
            (std::vector<std::string>{"\ntzc::allocate(image);", "\ntzc::allocate(image);"}));
}

TEST(Solve, a_message_that_starts_as_a_copy_is_not_allocated) {
  FactsBuilder builder = camera();
  std::get<InsertedAllocation>(builder.facts.allocations[0].how).filled = true;
  EXPECT_EQ(Solved(builder).code("image"), "TZC1020");
}

TEST(Solve, a_message_that_is_never_filled_needs_nothing) {
  FactsBuilder builder = camera();
  builder.facts.data_uses.clear();
  const Solved node(builder);
  EXPECT_EQ(node.outcome("image"), Outcome::not_needed);
  EXPECT_EQ(node.outcome("pub"), Outcome::not_needed);
  EXPECT_EQ(node.level(SiteKind::publish), Level::not_needed);
}

TEST(Solve, a_demoted_message_stays_a_copy_and_a_demoted_publisher_plain) {
  EXPECT_EQ(Solved(camera(), {}, "image").level(SiteKind::publish), Level::one_copy);
  EXPECT_EQ(Solved(camera(), {}, "pub").level(SiteKind::publish), Level::plain);
}

TEST(Solve, the_options_limit_the_level) {
  SolveOptions options;
  options.max_level = Level::one_copy;
  EXPECT_EQ(Solved(camera(), options).code("image"), "TZC1015");
  options.max_level = Level::plain;
  EXPECT_EQ(Solved(camera(), options).code("pub"), "TZC1015");
  options = {};
  options.wanted = [](const Site& site) { return site.topic != "image"; };
  EXPECT_EQ(Solved(camera(), options).code("pub"), "TZC1016");
}

TEST(Solve, a_factory_whose_call_can_name_the_publisher_is_given_it) {
  FactsBuilder builder = FactsBuilder()
                             .add(entity("pub", EntityRole::publisher))
                             .add(entity("image", EntityRole::message))
                             .add(entity("make#r", EntityRole::message, Storage::result))
                             .flow("image", "make#r")
                             .advertise("pub")
                             .allocation("image", "")
                             .publish("pub", "make#r");
  builder.facts.allocations[0].function = id("make#r");
  builder.facts.factories[id("make#r")] = {{{"/p/node.cpp", 1, 1, 1, 1}}, false, "publisher"};
  AllocationSite call;
  call.entity = id("make#r");
  call.how = FactoryAllocation{id("make#r"), {{{"/p/node.cpp", 40, 40, 4, 1}, "$PUB", "factory", {}}}};
  call.publishers = {{id("pub"), "pub", false, false, {id("make#r")}, {}}};
  builder.facts.allocations.push_back(call);
  const Solved node(builder);
  EXPECT_EQ(node.outcome("image"), Outcome::ported);
  EXPECT_EQ(node.edits(), (std::vector<std::string>{"\npublisher.allocate(image);", "pub",
                                                    "const tzc::Publisher& publisher"}));
  builder.facts.allocations[1].publishers.clear();
  EXPECT_EQ(Solved(builder).edits(), (std::vector<std::string>{"\ntzc::allocate(image);"}));
}

TEST(Solve, a_subscription_is_shared_unless_its_callback_may_write) {
  EXPECT_EQ(Solved(FactsBuilder().subscribe("")).level(SiteKind::subscribe), Level::shared);
  FactsBuilder writes = FactsBuilder().subscribe("");
  writes.facts.subscribes.begin()->second.writes = true;
  EXPECT_EQ(Solved(writes).level(SiteKind::subscribe), Level::copied);
}

TEST(Solve, a_callback_that_casts_const_away_leaves_its_subscription_plain) {
  const Solved node(
      FactsBuilder().add(entity("in", EntityRole::message)).subscribe("in").obstacle("in", "TZC2002"));
  EXPECT_EQ(node.site(SiteKind::subscribe).code, "TZC2002");
  EXPECT_TRUE(node.edits().empty());
}

TEST(Solve, a_callback_that_casts_const_away_from_a_message_of_its_own_harms_nobody) {
  FactsBuilder builder = FactsBuilder()
                             .add(entity("own", EntityRole::message))
                             .subscribe("own")
                             .subscribe("")
                             .obstacle("own", "TZC2002");
  builder.facts.subscribes.begin()->second.writes = true;
  EXPECT_TRUE(Solved(builder).edits().empty());
  builder.facts.add_parameter(id("own"), true);
  EXPECT_EQ(Solved(builder).level(SiteKind::subscribe), Level::copied);
  EXPECT_EQ(Solved(builder).edits().size(), 2u);
  builder.facts.add_parameter(id("own"), false);  // in another instance of a template
  EXPECT_TRUE(Solved(builder).edits().empty());
}

/// A callback in node.cpp that casts const away, and a subscription in viewer.cpp.
FactsBuilder two_files() {
  FactsBuilder builder =
      FactsBuilder().add(entity("in", EntityRole::message)).subscribe("in").obstacle("in", "TZC2002");
  Subscribe viewer = builder.facts.subscribes.begin()->second;
  viewer.callbacks.clear();
  viewer.where.file = viewer.changes[0].where.file = "/p/viewer.cpp";
  builder.facts.subscribes.emplace(viewer.id(), viewer);
  builder.facts.units_of_file = {{"/p/node.cpp", {"/p/node.cpp"}}, {"/p/viewer.cpp", {"/p/viewer.cpp"}}};
  return builder;
}

TEST(Solve, what_a_callback_does_matters_to_subscriptions_that_may_be_in_its_process) {
  FactsBuilder builder = two_files();
  EXPECT_TRUE(Solved(builder).edits().empty());
  builder.facts.programs = {"/p/node.cpp", "/p/viewer.cpp"};
  EXPECT_EQ(Solved(builder).edits().size(), 1u);
}

TEST(Solve, a_file_with_main_may_be_part_of_another_program) {
  FactsBuilder builder = two_files();
  builder.facts.programs = {"/p/node.cpp", "/p/viewer.cpp"};
  FactsBuilder compiled_twice = builder;
  compiled_twice.facts.parts = {"/p/viewer.cpp"};
  EXPECT_TRUE(Solved(compiled_twice).edits().empty());
  builder.facts.units_of_file["/p/node.cpp"].insert("/p/viewer.cpp");
  EXPECT_TRUE(Solved(builder).edits().empty());
}

TEST(Solve, a_transport_with_a_topic_of_its_own_harms_nobody) {
  FactsBuilder builder = two_files();
  std::string& transport = builder.facts.subscribes.begin()->second.asked_transport;
  transport = "the transport 'compressed'";
  EXPECT_EQ(Solved(builder).edits().size(), 1u);
  transport = udpros;
  EXPECT_TRUE(Solved(builder).edits().empty());
}

TEST(Solve, subscriptions_that_would_change_one_text_in_two_ways_stay) {
  FactsBuilder builder = FactsBuilder().subscribe("");
  Subscribe other = builder.facts.subscribes.begin()->second;
  other.type = "sensor_msgs/PointCloud2";
  builder.facts.subscribes.emplace(other.id(), other);
  EXPECT_EQ(Solved(builder).edits().size(), 2u);
  builder.facts.subscribes.at(other.id()).changes[0].text = "tzc::subscribe<sensor_msgs::PointCloud2>(";
  EXPECT_EQ(Solved(builder).site(SiteKind::subscribe).code, "TZC1007");
  EXPECT_TRUE(Solved(builder).edits().empty());
}

TEST(Solve, a_subscription_shares_the_fate_of_its_filter) {
  FactsBuilder builder = FactsBuilder().add(entity("sub", EntityRole::filter)).subscribe("");
  builder.facts.subscribes.begin()->second.filter = id("sub");
  EXPECT_EQ(Solved(builder).level(SiteKind::subscribe), Level::shared);
  EXPECT_EQ(Solved(builder.obstacle("sub", "TZC1005")).site(SiteKind::subscribe).code, "TZC1005");
}

TEST(Solve, sites_of_one_function_count_up_whatever_their_lines_are) {
  const Solved node(FactsBuilder().subscribe("").subscribe(""));
  EXPECT_EQ(node.site(SiteKind::subscribe).id, "subscribe:node.cpp:main#1");
}

}  // namespace
}  // namespace tzc::rewriter::test
