// SPDX-License-Identifier: BSD-3-Clause
// Which publishers can be named where a message is allocated, before they are named in the source.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facts/facts_of.h"

namespace tzc::rewriter::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* node_and_index = "Node* node, bool ready, int i";

Facts facts_with(const std::string& body, const std::string& parameters) {
  return facts_of(
      "#include <map>\n#include <memory>\n#include <vector>\n"
      "struct Node { ros::Publisher pub; std::vector<ros::Publisher> pubs; };\n"
      "ros::Publisher& choose();\n"
      "void f(" +
      parameters + ") {\n  " + body + "\n}\n");
}

/// The publishers that are available where the function's only local message is allocated; in question marks
/// those that may be null there.
std::vector<std::string> available(const std::string& body, const std::string& parameters = node_and_index) {
  const Facts facts = facts_with(body, parameters);
  std::vector<std::string> names;
  for (const AllocationSite& site : facts.allocations)
    if (std::holds_alternative<InsertedAllocation>(site.how))
      for (const PublisherName& name : site.publishers)
        names.push_back(name.guarded ? "?" + name.text + "?" : name.text);
  return names;
}

TEST(Hoisting, a_reference_to_a_publisher_is_available_everywhere_in_its_function) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  pub.publish(image);", "ros::Publisher& pub"),
              ElementsAre("pub"));
}

TEST(Hoisting, a_pointer_that_is_followed_in_any_case_may_be_followed_earlier) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  node->pub.publish(image);"), ElementsAre("node->pub"));
}

TEST(Hoisting, a_pointer_that_is_followed_under_a_condition_may_not) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  if (ready) node->pub.publish(image);"), IsEmpty());
}

TEST(Hoisting, a_way_out_before_the_pointer_is_followed_forbids_it) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  if (!ready) return;\n  node->pub.publish(image);"),
              IsEmpty());
}

TEST(Hoisting, a_pointer_that_was_followed_before_may_be_followed_again) {
  EXPECT_THAT(available("const ros::Publisher& pub = node->pub;\n  sensor_msgs::Image image;\n  if (ready) "
                        "node->pub.publish(image);"),
              ElementsAre("node->pub"));
}

TEST(Hoisting, an_index_that_changes_in_between_names_another_publisher) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  ++i;\n  node->pubs[i].publish(image);"), IsEmpty());
  EXPECT_THAT(available("sensor_msgs::Image image;\n  node->pubs[i].publish(image);"),
              ElementsAre("node->pubs[i]"));
}

TEST(Hoisting, a_call_is_not_made_earlier) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  choose().publish(image);"), IsEmpty());
}

TEST(Hoisting, a_smart_pointer_that_may_be_null_is_asked_first) {
  EXPECT_THAT(available("sensor_msgs::Image image;\n  if (pub) pub->publish(image);",
                        "std::shared_ptr<ros::Publisher> pub"),
              ElementsAre("?pub?"));
}

TEST(Hoisting, a_local_publisher_is_available_behind_its_declaration_only) {
  EXPECT_THAT(
      available("sensor_msgs::Image image;\n  ros::Publisher pub = node->pub;\n  pub.publish(image);"),
      ElementsAre("pub"));
  EXPECT_THAT(available("sensor_msgs::Image image;\n  image.data.resize(9);\n  ros::Publisher pub = "
                        "node->pub;\n  pub.publish(image);"),
              IsEmpty());
}

TEST(Hoisting, a_division_that_a_condition_guards_is_not_made_earlier) {
  const std::string image = "sensor_msgs::Image image;\n  ";
  EXPECT_THAT(available(image + "if (i) node->pubs[7 % i].publish(image);"), IsEmpty());
}

TEST(Hoisting, a_container_that_changes_in_between_is_not_looked_into) {
  const std::string image = "sensor_msgs::Image image;\n  ";
  EXPECT_THAT(available(image + "node->pubs.clear();\n  node->pubs[i].publish(image);"), IsEmpty());
}

}  // namespace
}  // namespace tzc::rewriter::test
