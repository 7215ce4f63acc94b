// SPDX-License-Identifier: BSD-3-Clause
// What one unit does with code that another one shows (model/hidden_code.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "facts/facts_of.h"

namespace tzc::rewriter::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string uses = R"(
#include <memory>
#include <ostream>
extern sensor_msgs::Image last;
extern ros::Publisher pub;
void lets_go(std::shared_ptr<int>& guard) {
  unsigned char* at = &last.data[0];
  guard.reset();
  at[0] = 1;
}
void prints(std::ostream& out) {
  unsigned char* at = &last.data[1];
  out << 1;
  at[0] = 1;
}
void sends(std::shared_ptr<sensor_msgs::Image> given) {
  sensor_msgs::Image image;
  keep(&image.data[0]);
  pub.publish(image);
  given.reset();
}
)";
const std::string keeps = "void keep(unsigned char* pointer);\n";
const std::string deleter = R"(
#include <memory>
void send();
void arm(std::shared_ptr<int>& guard) { guard = std::shared_ptr<int>(new int(0), [](int*) { send(); }); }
)";
const std::string stream = R"(
#include <streambuf>
void send();
struct Buffer : std::streambuf { int overflow(int) override { send(); return 0; } };
)";

/// The lines of the pointers that live across code that is not known.
std::vector<unsigned> holds(const Facts& facts) {
  std::vector<unsigned> lines;
  for (const DataHold& hold : facts.holds)
    if (hold.event.kind == PublishEvent::Kind::unknown) lines.push_back(hold.obstacle.where.line);
  return lines;
}

/// Those of `uses` that may call what others gave away.
std::set<std::string> call_unknown(const Facts& facts) {
  std::set<std::string> functions;
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events)
        for (const std::string name : {"lets_go", "prints", "sends"})
          if (event.callee.empty() && event.kind == ContentEvent::Kind::call &&
              usr.find("@F@" + name + "#") != std::string::npos)
            functions.insert(name);
  return functions;
}

TEST(HiddenCode, none_that_is_shown_does_nothing) {
  const Facts facts = facts_of_all({keeps + uses});
  EXPECT_THAT(holds(facts), IsEmpty());
  EXPECT_THAT(call_unknown(facts), IsEmpty());
  EXPECT_THAT(facts.loud_tails, IsEmpty());
}

TEST(HiddenCode, each_counts_where_it_may_run_whichever_unit_comes_first) {
  for (const auto& sources : {std::vector<std::string>{deleter, keeps + uses}, {keeps + uses, deleter}}) {
    const Facts facts = facts_of_all(sources);
    EXPECT_THAT(holds(facts), ElementsAre(12u));
    EXPECT_THAT(call_unknown(facts), ElementsAre("lets_go", "sends"));
    EXPECT_EQ(facts.loud_tails.size(), 1u);
  }
  for (const auto& sources : {std::vector<std::string>{stream, keeps + uses}, {keeps + uses, stream}}) {
    const Facts facts = facts_of_all(sources);
    EXPECT_THAT(holds(facts), ElementsAre(17u));
    EXPECT_THAT(call_unknown(facts), ElementsAre("prints"));
    EXPECT_THAT(facts.loud_tails, IsEmpty());
  }
  const Facts both = facts_of_all({deleter, keeps + uses, stream});
  EXPECT_THAT(holds(both), ElementsAre(12u, 17u));
  EXPECT_THAT(call_unknown(both), ElementsAre("lets_go", "prints", "sends"));
}

TEST(HiddenCode, what_happens_in_one_of_two_cases_happens_in_both) {
  const IfShown always, a(IfShown::Names{"a"}), b(IfShown::Names{"b"});
  const std::optional<IfShown> never;
  EXPECT_EQ(either(never, never), std::nullopt);
  EXPECT_EQ(either(never, a), std::optional(a));
  EXPECT_EQ(either(a, never), std::optional(a));
  EXPECT_EQ(either(a, always), std::optional(always));
  EXPECT_EQ(either(always, a), std::optional(always));
  const IfShown any = *either(a, b);
  EXPECT_TRUE(any.is_met_by({"a"}) && any.is_met_by({"b", "c"}));
  EXPECT_FALSE(any.is_met_by({}) || any.is_met_by({"c"}));
  EXPECT_TRUE(any.covers(a) && always.covers(any) && a.covers(a));
  EXPECT_FALSE(a.covers(any) || a.covers(always) || a.covers(b));
}

TEST(HiddenCode, what_leads_through_it_alone_is_left_out) {
  ContentEvent inside, behind;
  inside.part = "inside";
  behind.part = "behind";
  ContentFlow flow;  // 0 -> 1 (hidden) -> 2 -> 3, and 0 -> 3
  flow.blocks = {{{}, {1, 3}}, {{}, {2}, IfShown({"code"})}, {{inside}, {3}}, {{behind}, {}}};
  flow.exit = 3;
  ContentFlow shown = flow;
  shown.leave_out_all_but({"code", "more"});
  EXPECT_EQ(shown.blocks, flow.blocks);
  flow.leave_out_all_but({"more"});
  EXPECT_TRUE(flow.blocks[2].events.empty());
  EXPECT_THAT(flow.blocks[0].next, ElementsAre(3u));
  EXPECT_THAT(flow.blocks[3].events, ElementsAre(behind));
}

}  // namespace
}  // namespace tzc::rewriter::test
