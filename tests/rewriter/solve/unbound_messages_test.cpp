// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unbound_messages.h"

#include <gtest/gtest.h>

namespace tzc::rewriter::test {
namespace {

const char* const filled = "c:@S@Node@FI@image_";
const char* const row_of_messages = "c:@S@Node@FI@queue_";

/// A member is filled and stored in a queue, which is published from at the place 100.
Facts member_in_queue() {
  Facts facts;
  facts.given.messages.push_back({filled, row_of_messages, "stored by 'push_back'", {"/p/node.cpp", 8, 1}});
  facts.given.published_from[{"/p/node.cpp", 100}] = {row_of_messages};
  return facts;
}

void add_event(Facts& facts, const std::string& function, ContentEvent one) {
  ContentFlow flow;
  flow.blocks = {{{std::move(one)}, {}}};
  facts.contents.emplace(function, std::move(flow));
}

ContentEvent happening(ContentEvent::Kind kind, const MessagePart& part) {
  ContentEvent one;
  one.kind = kind;
  one.part = part;
  return one;
}

/// The line that gives the message away which costs the publish a copy; 0: none does.
unsigned given_line(const Facts& facts, unsigned offset = 100) {
  const std::optional<Obstacle> why = UnboundMessages(facts).why_copied({"/p/node.cpp", offset, ""});
  return why ? why->where.line : 0;
}

TEST(UnboundMessages, cost_the_publish_of_what_holds_their_content) {
  EXPECT_EQ(given_line(member_in_queue()), 8u);
  EXPECT_EQ(given_line(member_in_queue(), 200), 0u) << "another publish";
}

TEST(UnboundMessages, are_none_that_are_published_themselves) {
  Facts facts = member_in_queue();
  add_event(facts, "send", happening(ContentEvent::Kind::publish, filled));
  EXPECT_EQ(given_line(facts), 0u);
}

TEST(UnboundMessages, are_none_that_a_function_publishes_for_them) {
  Facts facts = member_in_queue();
  const std::string parameter = parameter_root("send", 0);
  add_event(facts, "send", happening(ContentEvent::Kind::publish, parameter));
  ContentEvent call = happening(ContentEvent::Kind::call, "");
  call.callee = "send";
  call.passed = {{parameter, filled}};
  add_event(facts, "step", call);
  EXPECT_EQ(given_line(facts), 0u);
}

TEST(UnboundMessages, are_none_that_get_another_message_as_a_whole) {
  Facts facts = member_in_queue();
  add_event(facts, "step", happening(ContentEvent::Kind::reset, filled));
  EXPECT_EQ(given_line(facts), 0u) << "which may lie in shared memory";
  facts = member_in_queue();
  add_event(facts, "step", happening(ContentEvent::Kind::reset, std::string(filled) + "/data"));
  EXPECT_EQ(given_line(facts), 8u) << "an array of it has content of its own, or none";
}

TEST(UnboundMessages, cost_a_function_that_publishes_what_it_is_passed) {
  Facts facts = member_in_queue();
  const std::string parameter = parameter_root("send", 0);
  facts.given.published_from = {{{"/p/node.cpp", 300}, {parameter}}};
  ContentEvent call = happening(ContentEvent::Kind::call, "");
  call.callee = "send";
  call.passed = {{parameter, std::string(row_of_messages) + "[front]"}};
  add_event(facts, "step", call);
  EXPECT_EQ(given_line(facts, 300), 8u);
}

}  // namespace
}  // namespace tzc::rewriter::test
