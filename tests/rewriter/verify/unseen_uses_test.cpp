// SPDX-License-Identifier: BSD-3-Clause
// Which components code names that no unit compiles.
#include "verify/unseen_uses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solve/facts_of.h"

namespace tzc::rewriter::test {
namespace {

const char* const branch_file = "/p/node.cpp";

/// A node with the entity at line 2 and a branch that one of its units does not compile.
class Branch {
 public:
  Branch(std::string text, Entity entity) : text_(std::move(text)) {
    entity.where = {branch_file, 2, 3};
    facts_.facts.units_of_file = {{branch_file, {"node"}}};
    facts_.add(entity);
  }

  /// The code of the entity's obstacle; empty: it has none.
  std::string obstacle() const {
    const Components components(facts_.facts);
    const ComponentId component = components.all().front().id;
    const auto begin = static_cast<unsigned>(text_.find("#if")),
               end = static_cast<unsigned>(text_.find("#endif"));
    const auto line = static_cast<unsigned>(1 + std::count(text_.begin(), text_.begin() + begin, '\n'));
    const UnseenCode code{{{branch_file, begin, end, line, 1}}, {}};
    const UnseenUses uses(code, facts_.facts, components, [this](const std::string&) { return text_; });
    const auto found = uses.users_of({{branch_file, 0, 0, "x", component, "rule"}});
    return found.empty() ? "" : found.at(component).code;
  }

 private:
  std::string text_;
  FactsBuilder facts_;
};

std::string function_with(const std::string& branch) {
  return "void run() {\n  Image image;\n" + branch + "}\nvoid other() {}\n";
}

/// One source for two versions of ROS, with changes at the given words; the code of the obstacle of `pub_`.
std::string obstacle_of_twofold_class(const std::vector<std::string>& changed) {
  const std::string text =
      "#ifdef ROS1\n  struct Node { Publisher pub_; void send() { pub_.publish(1); } };\n#endif\n"
      "#ifdef ROS2\nstruct Node { Other pub_; void send() { pub_.publish(2); } };\n#endif\n"
      "void run(Node& node) { node.send(3); }\n";
  Entity publisher = entity("pub_", EntityRole::publisher, Storage::member);
  publisher.where = {branch_file, 2, 27};
  FactsBuilder facts;
  facts.facts.units_of_file = {{branch_file, {"node"}}};
  facts.add(publisher);
  const Components components(facts.facts);
  const ComponentId component = components.all().front().id;
  const auto begin = static_cast<unsigned>(text.find("#ifdef ROS2")),
             end = static_cast<unsigned>(text.rfind("#endif"));
  const UnseenUses uses({{{branch_file, begin, end, 4, 1}}, {}}, facts.facts, components,
                        [&](const std::string&) { return text; });
  Edits edits;
  for (const std::string& word : changed)
    edits.push_back({branch_file, text.find(word), 0, "x", component, "rule"});
  const auto found = uses.users_of(edits);
  return found.empty() ? "" : found.at(component).code;
}

TEST(UnseenUses, a_branch_that_is_never_compiled_with_the_changes_does_not_count) {
  EXPECT_EQ(obstacle_of_twofold_class({"Publisher", "publish(1)"}), "");
}

TEST(UnseenUses, a_change_in_code_that_is_compiled_with_either_class_counts) {
  EXPECT_EQ(obstacle_of_twofold_class({"Publisher", "send(3)"}), "TZC3007");
}

TEST(UnseenUses, a_local_that_the_branch_names_keeps_its_type) {
  EXPECT_EQ(Branch(function_with("#ifdef X\n use(image);\n#endif\n"), entity("image", EntityRole::message))
                .obstacle(),
            "TZC3007");
}

std::string obstacle_of_publisher(const std::string& branch,
                                  const std::string& ported_as = "tzc::Publisher") {
  Entity publisher = entity("pub", EntityRole::publisher);
  publisher.ported_as.name = ported_as;
  return Branch(function_with("#ifdef X\n" + branch + "\n#endif\n"), publisher).obstacle();
}

TEST(UnseenUses, calls_that_either_publisher_has_do_not_count) {
  for (const char* branch : {"pub.publish(stock);", "if (pub.getNumSubscribers() > 0) pub . publish(make());",
                             "pub->publish(stock);", "this->pub.shutdown();",
                             "ROS_INFO(\"%s\", pub.getTopic().c_str());  // keep(pub)"})
    EXPECT_EQ(obstacle_of_publisher(branch), "") << branch;
}

TEST(UnseenUses, a_long_comment_in_a_call_is_no_obstacle) {
  EXPECT_EQ(obstacle_of_publisher("pub /*" + std::string(1 << 20, 'x') + "*/ .publish(stock);"), "");
}

TEST(UnseenUses, whatever_else_is_done_to_a_publisher_counts) {
  for (const char* branch : {"keep(pub);", "pub = nh.advertise<Image>(1);", "ros::Publisher pub;", "&pub;",
                             "pub.publish(keep(pub));", "pub.publish<Image>(stock);", "pub.stock_only();",
                             "pub.publish;", "#define PUB pub", "pub\n"})
    EXPECT_EQ(obstacle_of_publisher(branch), "TZC3007") << branch;
}

TEST(UnseenUses, a_call_of_an_image_publisher_counts) {
  EXPECT_EQ(obstacle_of_publisher("pub.publish(stock);", "tzc::image_transport::Publisher"), "TZC3007");
}

TEST(UnseenUses, another_name_does_not_count) {
  EXPECT_EQ(Branch(function_with("#ifdef X\n use(images);  // image\n#endif\n"),
                   entity("image", EntityRole::message))
                .obstacle(),
            "");
}

TEST(UnseenUses, dead_code_does_not_count) {
  EXPECT_EQ(
      Branch(function_with("#if 0\n use(image);\n#endif\n"), entity("image", EntityRole::message)).obstacle(),
      "");
}

TEST(UnseenUses, a_branch_that_one_unit_compiles_does_not_count) {
  const Place first{branch_file, 10, 40, 2, 1}, second{branch_file, 60, 80, 5, 1};
  const std::vector<Place> unseen = compiled_by_none({first, second, first}, {{branch_file, 2}});
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_EQ(unseen[0].begin, 60u);
}

TEST(UnseenUses, what_follows_an_elif_that_one_unit_compiles_does_not_count) {
  const Place to_endif{branch_file, 10, 80, 2, 1}, to_elif{branch_file, 10, 40, 2, 1};
  const std::vector<Place> unseen = compiled_by_none({to_endif, to_elif}, {{branch_file, 4}});
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_EQ(unseen[0].end, 40u);
}

TEST(UnseenUses, a_local_of_another_function_does_not_count) {
  const std::string text =
      "void run() {\n  Image image;\n}\nvoid other() {\n#ifdef X\n use(image);\n#endif\n}\n";
  EXPECT_EQ(Branch(text, entity("image", EntityRole::message)).obstacle(), "");
}

TEST(UnseenUses, a_member_counts_in_every_function) {
  const std::string text =
      "class A {\n  Image image_;\n};\nvoid A::run() {\n#ifdef X\n use(image_);\n#endif\n}\n";
  EXPECT_EQ(Branch(text, entity("image_", EntityRole::message, Storage::member)).obstacle(), "TZC3007");
}

TEST(UnseenUses, a_call_of_the_function_counts_for_its_parameter) {
  const std::string text = "void use(\n  Image image);\nvoid run() {\n#ifdef X\n use(stock);\n#endif\n}\n";
  EXPECT_EQ(Branch(text, entity("image", EntityRole::message, Storage::parameter)).obstacle(), "TZC3007");
}

/// The code of the obstacle of an entity of a header that a file which is not compiled includes; empty: it has none.
std::string obstacle_by_file(const std::string& text, Entity member,
                             const std::string& included = "/p/node.h",
                             UnseenFile::Place place = UnseenFile::Place::package) {
  FactsBuilder facts;
  member.where = {"/p/node.h", 2, 3};
  facts.facts.units_of_file = {{"/p/node.h", {"/p/node.cpp"}}};
  facts.add(member);
  const Components components(facts.facts);
  const ComponentId component = components.all().front().id;
  const UnseenCode code{{}, {{"/p/test.cpp", {included}, place}}};
  const UnseenUses uses(code, facts.facts, components, [&](const std::string& file) {
    return file == "/p/test.cpp" ? text : "struct Node {\n  ros::Publisher pub;\n};\n";
  });
  const auto found = uses.users_of({{"/p/node.h", 0, 0, "x", component, "rule"}});
  return found.empty() ? "" : found.at(component).code;
}

Entity member_of_node(bool is_private = false) {
  Entity member = entity("pub", EntityRole::publisher);
  member.storage = Storage::member;
  member.member_of.record = "c:@N@robot@S@Node";
  member.member_of.is_private = is_private;
  return member;
}

TEST(UnseenUses, a_member_that_a_file_names_keeps_its_type) {
  EXPECT_EQ(obstacle_by_file("void test(Node& n) { send(n.pub); }", member_of_node()), "TZC3007");
  EXPECT_EQ(obstacle_by_file("void test(Node& n) { send(n.publisher); }  // pub", member_of_node()), "");
}

TEST(UnseenUses, a_file_that_only_publishes_counts_since_its_target_may_not_be_linked_with_tzc) {
  Entity member = member_of_node();
  member.ported_as.name = "tzc::Publisher";
  EXPECT_EQ(obstacle_by_file("void run(Node& node) { node.pub.publish(stock); }\n", member), "TZC3007");
}

TEST(UnseenUses, a_file_that_does_not_include_the_header_does_not_count) {
  EXPECT_EQ(obstacle_by_file("void test(Node& n) { send(n.pub); }", member_of_node(), "/p/other.h"), "");
}

TEST(UnseenUses, a_private_member_counts_where_its_class_is_named) {
  EXPECT_EQ(obstacle_by_file("void Node::test() { send(pub); }", member_of_node(true)), "TZC3007");
  EXPECT_EQ(obstacle_by_file("void test() { ros::Publisher pub; }", member_of_node(true)), "");
}

TEST(UnseenUses, another_package_cannot_name_a_private_member) {
  const std::string text = "struct Mine : Node { ros::Publisher pub; };";
  const auto place = UnseenFile::Place::other_package;
  EXPECT_EQ(obstacle_by_file(text, member_of_node(true), "/p/node.h", place), "");
  EXPECT_EQ(obstacle_by_file(text, member_of_node(), "/p/node.h", place), "TZC3007");
}

}  // namespace
}  // namespace tzc::rewriter::test
