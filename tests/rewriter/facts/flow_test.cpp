// SPDX-License-Identifier: BSD-3-Clause
// Where values come from and where they go to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facts/facts_of.h"

namespace tzc::rewriter::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

/// Each flow as "from > to: how".
std::vector<std::string> flows(const Facts& facts) {
  std::vector<std::string> texts;
  for (const Flow& flow : facts.flows)
    texts.push_back(facts.entities.at(flow.from).name + " > " + facts.entities.at(flow.to).name + ": " +
                    flow.what);
  return texts;
}

/// The codes of the obstacles of an entity.
std::vector<std::string> obstacles(const Facts& facts, const std::string& name) {
  std::vector<std::string> codes;
  for (const auto& item : facts.entities)
    if (item.second.name == name)
      for (const Obstacle& obstacle : item.second.obstacles) codes.push_back(obstacle.code);
  return codes;
}

/// What the only publish call of a source may publish.
std::vector<std::string> published(const Facts& facts) {
  std::vector<std::string> names;
  if (facts.publishes.size() != 1) return {"there is more than one publish call, or none"};
  for (const EntityId& message : facts.publishes.begin()->second.messages)
    names.push_back(facts.entities.at(message).name);
  return names;
}

TEST(Flow, a_value_that_initialises_or_is_assigned_flows) {
  const Facts facts = facts_of("void f() { sensor_msgs::Image a, b; sensor_msgs::Image c = a; b = c; }");
  EXPECT_THAT(flows(facts), Contains("a > c: initialises 'c'"));
  EXPECT_THAT(flows(facts), Contains("c > b: assigned to 'b'"));
}

TEST(Flow, an_argument_flows_into_its_parameter_and_a_result_to_the_caller) {
  const Facts facts = facts_of(
      "sensor_msgs::Image turned(sensor_msgs::Image in) { return in; }\n"
      "void f() { sensor_msgs::Image a; sensor_msgs::Image b = turned(a); }");
  EXPECT_THAT(flows(facts), Contains("a > in: passed to 'turned'"));
  EXPECT_THAT(flows(facts), Contains("in > turned: returned from 'turned'"));
  EXPECT_THAT(flows(facts), Contains("turned > b: initialises 'b'"));
}

TEST(Flow, what_a_function_of_another_package_takes_escapes) {
  const Facts facts = facts_of(
      "#include <vector>\nextern \"C\" int abs(int);\n"
      "void f() { sensor_msgs::Image a; std::vector<sensor_msgs::Image> all; all.push_back(a); }");
  EXPECT_THAT(flows(facts), Contains("a > all: stored by 'push_back'"));
  EXPECT_THAT(obstacles(facts, "a"), IsEmpty());
}

TEST(Flow, a_message_that_a_callback_receives_is_pinned) {
  const Facts facts = facts_of(
      "void on_image(const sensor_msgs::ImageConstPtr& in) {}\n"
      "void f(ros::NodeHandle& nh) { ros::Subscriber s = nh.subscribe(\"t\", 1, on_image); }");
  EXPECT_THAT(obstacles(facts, "in"), ElementsAre("TZC1004"));
}

TEST(Flow, casting_const_away_is_an_obstacle) {
  const Facts facts =
      facts_of("void f(const sensor_msgs::Image& in) { const_cast<sensor_msgs::Image&>(in).data.clear(); }");
  EXPECT_THAT(obstacles(facts, "in"), Contains("TZC2002"));
}

TEST(Flow, a_pointer_cast_leads_to_the_message_that_it_is_given) {
  const Facts facts = facts_of(
      "void f(ros::Publisher& pub, const sensor_msgs::ImagePtr& in) { "
      "pub.publish(boost::const_pointer_cast<const sensor_msgs::Image>(in)); }");
  EXPECT_THAT(published(facts), ElementsAre("in"));
  EXPECT_THAT(obstacles(facts, "in"), IsEmpty());
  EXPECT_THAT(facts.const_casts, IsEmpty());
}

TEST(Flow, a_pointer_cast_that_takes_const_away_is_an_obstacle) {
  const Facts facts = facts_of(
      "void f(const sensor_msgs::ImageConstPtr& in) { "
      "boost::const_pointer_cast<sensor_msgs::Image>(in)->data.clear(); }");
  EXPECT_THAT(obstacles(facts, "in"), Contains("TZC2002"));
  ASSERT_EQ(facts.const_casts.size(), 1u);
  EXPECT_EQ(facts.const_casts[0].messages.size(), 1u);
}

TEST(Flow, a_null_pointer_leads_to_no_message) {
  const Facts facts = facts_of(
      "void look(const sensor_msgs::ImagePtr&) {}\n"
      "void look_at(const sensor_msgs::Image*) {}\n"
      "void f() { look(sensor_msgs::ImagePtr(nullptr)); look_at((sensor_msgs::Image*)NULL); "
      "look_at(static_cast<sensor_msgs::Image*>(0)); }");
  EXPECT_THAT(facts.const_casts, IsEmpty());
}

TEST(Flow, what_a_void_pointer_leads_to_is_not_known) {
  const Facts facts =
      facts_of("void f(void* user) { static_cast<sensor_msgs::Image*>(user)->data.clear(); }");
  ASSERT_EQ(facts.const_casts.size(), 1u);
  EXPECT_EQ(facts.const_casts[0].obstacle.reason,
            "a message that may be this one is cast from 'void *', which does not tell what lies there");
}

TEST(Flow, a_parameter_may_be_the_functions_own_message) {
  const Facts facts = facts_of(
      "void f(sensor_msgs::Image value, const sensor_msgs::ImagePtr& own, "
      "const sensor_msgs::ImageConstPtr& shown) {}");
  std::map<std::string, bool> own;
  for (const auto& [id, is_own] : facts.own_parameters) own[facts.entities.at(id).name] = is_own;
  EXPECT_THAT(own, UnorderedElementsAre(Pair("value", true), Pair("own", true), Pair("shown", false)));
}

TEST(Flow, a_choice_comes_from_both_of_its_values) {
  const Facts facts = facts_of(
      "void f(ros::Publisher& pub, bool left) { sensor_msgs::Image a, b; pub.publish(left ? a : b); }");
  EXPECT_THAT(published(facts), UnorderedElementsAre("a", "b"));
}

TEST(Flow, a_dereferenced_pointer_is_its_object) {
  const Facts facts = facts_of(
      "void f(ros::Publisher& pub) { auto image = boost::make_shared<sensor_msgs::Image>(); "
      "pub.publish(*image); "
      "}");
  EXPECT_THAT(published(facts), ElementsAre("image"));
}

TEST(Flow, the_elements_of_a_container_become_the_variable_of_a_loop) {
  const Facts facts = facts_of(
      "#include <vector>\n"
      "void f(std::vector<sensor_msgs::Image>& all) { for (sensor_msgs::Image& one : all) one.data.clear(); "
      "}");
  EXPECT_THAT(flows(facts), Contains("all > one: looped over"));
}

}  // namespace
}  // namespace tzc::rewriter::test
