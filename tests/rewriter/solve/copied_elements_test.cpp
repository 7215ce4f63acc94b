// SPDX-License-Identifier: BSD-3-Clause
#include "solve/copied_elements.h"

#include <gtest/gtest.h>

namespace tzc::rewriter::test {
namespace {

using Kind = ContentEvent::Kind;

const char* const member = "c:@S@Node@FI@image_";
const char* const local = "local 7image";

std::string data_of(const std::string& message) {
  return message + "/data";
}

ContentEvent event(Kind kind, const std::string& part, unsigned line = 1) {
  ContentEvent one;
  one.kind = kind;
  one.part = part;
  one.where = {"/p/node.cpp", line, 1};
  return one;
}
ContentEvent publish(const std::string& message, unsigned offset = 100) {
  ContentEvent one = event(Kind::publish, message);
  one.site = {"/p/node.cpp", offset};
  return one;
}
ContentEvent call(const std::string& callee, std::map<std::string, MessagePart> passed = {}) {
  ContentEvent one = event(Kind::call, "");
  one.callee = callee;
  one.passed = std::move(passed);
  return one;
}

ContentFlow straight(std::vector<ContentEvent> events) {
  ContentFlow flow;
  flow.blocks = {{std::move(events), {1}}, {{}, {}}};
  flow.exit = 1;
  return flow;
}

/// The line that costs the publish at an offset a copy; 0: none does.
unsigned costs(const std::map<std::string, ContentFlow>& contents, unsigned offset = 100,
               std::set<std::string> addressed = {}) {
  Facts facts;
  facts.contents = contents;
  facts.addressed = std::move(addressed);
  const std::optional<Obstacle> why = CopiedElements(facts).why_copied({"/p/node.cpp", offset, ""});
  return why ? why->where.line : 0;
}

TEST(CopiedElements, a_member_that_is_written_again_at_the_next_call) {
  EXPECT_EQ(costs({{"f", straight({event(Kind::write, data_of(member), 8), publish(member)})}}), 8u);
}

TEST(CopiedElements, a_member_that_is_replaced_first) {
  EXPECT_EQ(costs({{"f", straight({event(Kind::reset, data_of(member)), event(Kind::write, data_of(member)),
                                   publish(member)})}}),
            0u);
}

TEST(CopiedElements, a_local_ends_with_its_function) {
  EXPECT_EQ(costs({{"f", straight({event(Kind::write, data_of(local)), publish(local)})}}), 0u);
  EXPECT_EQ(costs({{"f", straight({publish(local), event(Kind::write, data_of(local), 9)})}}), 9u);
}

TEST(CopiedElements, only_the_publish_before_the_write) {
  const std::map<std::string, ContentFlow> two = {
      {"f", straight({publish(local, 100), event(Kind::write, data_of(local), 5), publish(local, 200)})}};
  EXPECT_EQ(costs(two, 100), 5u);
  EXPECT_EQ(costs(two, 200), 0u);
}

TEST(CopiedElements, another_array_of_the_message) {
  EXPECT_EQ(costs({{"f", straight({publish(local), event(Kind::reset, "local 7image/ranges"),
                                   event(Kind::write, "local 7image/ranges")})}}),
            0u);
  EXPECT_EQ(costs({{"f", straight({publish(local), event(Kind::reset, "local 7image/ranges"),
                                   event(Kind::write, "local 7image/other", 4)})}}),
            4u);
  EXPECT_EQ(costs({{"f", straight({publish(local), event(Kind::write, "local 7image2/data")})}}), 0u);
}

TEST(CopiedElements, one_of_two_branches_replaces) {
  ContentFlow flow;
  flow.blocks = {{{}, {1, 2}},
                 {{event(Kind::reset, data_of(member))}, {2}},
                 {{event(Kind::write, data_of(member), 6), publish(member)}, {3}},
                 {{}, {}}};
  flow.exit = 3;
  EXPECT_EQ(costs({{"f", flow}}), 6u);
}

TEST(CopiedElements, both_branches_replace) {
  ContentFlow flow;
  flow.blocks = {{{}, {1, 2}},
                 {{event(Kind::reset, data_of(member))}, {3}},
                 {{event(Kind::reset, member)}, {3}},
                 {{event(Kind::write, data_of(member), 6), publish(member)}, {4}},
                 {{}, {}}};
  flow.exit = 4;
  EXPECT_EQ(costs({{"f", flow}}), 0u);
}

TEST(CopiedElements, the_next_turn_of_a_loop) {
  ContentFlow flow;
  flow.blocks = {{{event(Kind::reset, local)}, {1}},
                 {{event(Kind::write, data_of(local), 3), publish(local)}, {1, 2}},
                 {{}, {}}};
  flow.exit = 2;
  EXPECT_EQ(costs({{"f", flow}}), 3u);
  flow.blocks[1].events.insert(flow.blocks[1].events.begin(), event(Kind::reset, data_of(local)));
  EXPECT_EQ(costs({{"f", flow}}), 0u);
}

TEST(CopiedElements, a_helper_writes_to_what_it_is_given) {
  const std::string parameter = parameter_root("paint", 0);
  EXPECT_EQ(costs({{"f", straight({call("paint", {{parameter, member}}), publish(member)})},
                   {"paint", straight({event(Kind::write, data_of(parameter), 12)})}}),
            12u);
  EXPECT_EQ(costs({{"f", straight({call("paint", {{parameter, member}}), publish(member)})},
                   {"paint", straight({event(Kind::reset, data_of(parameter)),
                                       event(Kind::write, data_of(parameter), 12)})}}),
            0u);
}

TEST(CopiedElements, a_helper_publishes_what_it_is_given) {
  const std::string parameter = parameter_root("send", 0);
  EXPECT_EQ(
      costs({{"f", straight({call("send", {{parameter, local}}), event(Kind::write, data_of(local), 9)})},
             {"send", straight({publish(parameter)})}}),
      9u);
}

TEST(CopiedElements, a_helper_that_is_called_by_the_middleware_too) {
  const std::map<std::string, ContentFlow> contents = {
      {"f", straight({event(Kind::reset, data_of(member)), call("paint"), publish(member)})},
      {"paint", straight({event(Kind::write, data_of(member), 12)})}};
  EXPECT_EQ(costs(contents), 0u);
  EXPECT_EQ(costs(contents, 100, {"paint"}), 12u);
}

TEST(CopiedElements, a_call_of_what_does_not_touch_it_changes_nothing) {
  const std::string other = "c:@S@Node@FI@other_";
  const std::map<std::string, ContentFlow> contents = {
      {"f", straight({publish(member), call("g"), event(Kind::write, data_of(member), 7)})},
      {"g", straight({event(Kind::reset, other), publish(other, 200)})}};
  EXPECT_EQ(costs(contents), 7u);
  EXPECT_EQ(costs(contents, 200), 0u);
}

TEST(CopiedElements, what_a_helper_of_a_helper_does_to_a_member) {
  const auto through_helper = [](const ContentEvent& last) {
    return std::map<std::string, ContentFlow>{
        {"f", straight({call("g"), publish(member)})}, {"g", straight({call("h")})}, {"h", straight({last})}};
  };
  EXPECT_EQ(costs(through_helper(event(Kind::write, data_of(member), 14))), 14u);
  EXPECT_EQ(costs(through_helper(event(Kind::take, data_of(member), 15))), 15u);
  EXPECT_EQ(costs(through_helper(event(Kind::reset, data_of(member)))), 0u);
}

TEST(CopiedElements, functions_that_call_each_other_end) {
  EXPECT_EQ(costs({{"f", straight({call("g"), publish(member)})},
                   {"g", straight({call("h"), event(Kind::write, data_of(member), 4)})},
                   {"h", straight({call("g")})}}),
            0u)
      << "neither returns";
  EXPECT_EQ(costs({{"f", straight({event(Kind::write, data_of(member), 4), call("f"), publish(member)})}}),
            4u);
}

TEST(CopiedElements, a_constructor_begins_with_new_members) {
  ContentFlow made = straight({event(Kind::write, data_of(member), 2)});
  made.makes_object = true;
  EXPECT_EQ(costs({{"Node", made}, {"f", straight({publish(member)})}}), 0u);
}

TEST(CopiedElements, the_elements_of_a_vector) {
  EXPECT_EQ(costs({{"f", straight({event(Kind::take, data_of(local), 5), publish(local)})}}), 5u);
  EXPECT_EQ(costs({{"f", straight({event(Kind::take, data_of(local), 5), event(Kind::reset, data_of(local)),
                                   publish(local)})}}),
            0u);
  EXPECT_EQ(
      costs({{"f", straight({event(Kind::take, data_of(local), 5), publish(local), publish(local, 200)})}},
            200),
      0u)
      << "they lie in shared memory since the first publish";
}

/// A message that is filled, and what happens to it and to a copy of it that line 30 makes.
std::vector<ContentEvent> with_copy(std::vector<ContentEvent> before, std::vector<ContentEvent> behind) {
  ContentEvent copied = event(Kind::copy, "local 9copy", 30);
  copied.other = local;
  std::vector<ContentEvent> events{event(Kind::write, data_of(local), 3)};
  events.insert(events.end(), before.begin(), before.end());
  events.push_back(copied);
  events.insert(events.end(), behind.begin(), behind.end());
  events.push_back(publish("local 9copy", 300));
  return events;
}

TEST(CopiedElements, a_copy_shares_what_was_published_and_has_other_elements_otherwise) {
  EXPECT_EQ(costs({{"f", straight(with_copy({publish(local)}, {}))}}, 300), 0u);
  EXPECT_EQ(costs({{"f", straight(with_copy({}, {publish(local)}))}}, 300), 30u);
  EXPECT_EQ(costs({{"f", straight(with_copy({publish(local), event(Kind::fill, data_of(local))}, {}))}}, 300),
            30u);
  ContentEvent unknown = event(Kind::copy, local, 31);
  EXPECT_EQ(costs({{"f", straight({unknown, publish(local)})}}), 31u) << "nothing shows of what";
}

TEST(CopiedElements, a_copy_that_is_written_to_has_other_elements) {
  const auto flow = straight(with_copy({publish(local)}, {event(Kind::write, data_of("local 9copy"), 33)}));
  EXPECT_EQ(costs({{"f", flow}}, 300), 30u);
  EXPECT_EQ(costs({{"f", flow}}), 33u) << "which the write copies from those that were published";
}

TEST(CopiedElements, a_copy_on_one_of_two_ways_that_publish) {
  ContentFlow flow;
  flow.blocks = {
      {{event(Kind::write, data_of(local), 3)}, {1, 2}}, {{publish(local)}, {2}}, {{}, {3}}, {{}, {}}};
  const std::vector<ContentEvent> copied = with_copy({}, {});
  flow.blocks[2].events.assign(copied.begin() + 1, copied.end());
  flow.exit = 3;
  EXPECT_EQ(costs({{"f", flow}}, 300), 30u);
}

TEST(CopiedElements, what_a_helper_copies_of_what_it_is_given) {
  const std::string parameter = parameter_root("copy", 0), result = result_root("copy");
  ContentEvent copied = event(Kind::copy, result, 40);
  copied.other = parameter;
  ContentEvent called = call("copy", {{parameter, local}});
  called.part = result;
  const auto program = [&](std::vector<ContentEvent> before) {
    before.insert(before.begin(), event(Kind::write, data_of(local), 3));
    before.push_back(called);
    before.push_back(publish(result, 300));
    return std::map<std::string, ContentFlow>{{"f", straight(before)}, {"copy", straight({copied})}};
  };
  EXPECT_EQ(costs(program({}), 300), 40u);
  EXPECT_EQ(costs(program({publish(local)}), 300), 0u);
}

TEST(CopiedElements, a_helper_gives_the_elements_of_a_vector) {
  const std::string parameter = parameter_root("fill", 0);
  EXPECT_EQ(costs({{"f", straight({call("fill", {{parameter, local}}), publish(local)})},
                   {"fill", straight({event(Kind::take, data_of(parameter), 21)})}}),
            21u);
}

}  // namespace
}  // namespace tzc::rewriter::test
