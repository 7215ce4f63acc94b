// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "engine/latency.h"
#include "engine/verdict.h"
#include "messages.h"

namespace tzc::compare {
namespace {

using ::testing::HasSubstr;
using testing::picture;
using testing::stamped;
using testing::stream;
using testing::unstamped;

StreamVerdict verdict(const std::vector<std::vector<Bytes>>& original, const std::vector<Bytes>& port,
                      const Rules& rules = {{}, true, true, 0, false}, const LeftOut& left_out = {}) {
  std::vector<Comparison> own;
  for (std::size_t i = 1; i < original.size(); ++i)
    own.push_back(compare_recordings({stream("/a", original[0])}, {stream("/a", original[i])}, left_out));
  return judge(own, compare_recordings({stream("/a", original[0])}, {stream("/a", port)}, left_out), rules)
      .at(0);
}

TEST(verdict, equal) {
  EXPECT_EQ(verdict({stamped({1, 2, 3}), stamped({1, 2, 3})}, stamped({1, 2, 3})).outcome, Outcome::equal);
}

TEST(verdict, sequence_numbers_do_not_count) {
  const auto port = std::vector<Bytes>{picture(70, 1, {1}), picture(80, 2, {2}), picture(81, 3, {3})};
  EXPECT_EQ(verdict({stamped({1, 2, 3}), stamped({1, 2, 3})}, port).outcome, Outcome::equal);
}

TEST(verdict, content_names_field_and_byte) {
  auto port = stamped({1, 2, 3});
  port[1].back() ^= 1U;
  const StreamVerdict judged = verdict({stamped({1, 2, 3}), stamped({1, 2, 3})}, port);
  EXPECT_EQ(judged.outcome, Outcome::different);
  ASSERT_EQ(judged.findings.size(), 1U);
  EXPECT_EQ(judged.findings[0].cause, Cause::content);
  EXPECT_EQ(judged.findings[0].field, "data[]");
  EXPECT_EQ(judged.findings[0].detail,
            "first in message 1: data[0] at byte 35: 2 in the original, 3 in the port");
}

TEST(verdict, loss_is_not_content) {
  const StreamVerdict judged = verdict({stamped({1, 2, 3, 4}), stamped({1, 2, 3, 4})}, stamped({1, 3, 4}));
  EXPECT_EQ(judged.outcome, Outcome::different);
  ASSERT_EQ(judged.findings.size(), 1U);
  EXPECT_EQ(judged.findings[0].cause, Cause::loss);
  EXPECT_EQ(judged.findings[0].count, 1U);
  EXPECT_EQ(judged.comparison.equal, 3U);
}

TEST(verdict, all_messages_lost) {
  const StreamVerdict judged = verdict({stamped({1, 2}), stamped({1, 2})}, {}, {{}, false, false, 0, false});
  EXPECT_EQ(judged.outcome, Outcome::different);
  EXPECT_EQ(judged.findings.at(0).cause, Cause::loss);
}

TEST(verdict, the_ends_count_only_when_they_can_be_known) {
  const std::vector<std::vector<Bytes>> original{stamped({1, 2, 3, 4}), stamped({1, 2, 3, 4})};
  EXPECT_EQ(verdict(original, stamped({2, 3}), {{}, false, false, 0, false}).outcome, Outcome::equal);
  EXPECT_EQ(verdict(original, stamped({2, 3, 4}), {{}, true, false, 0, false}).outcome, Outcome::different);
  EXPECT_EQ(verdict(original, stamped({1, 2, 3}), {{}, false, true, 0, false}).outcome, Outcome::different);
}

TEST(verdict, fields_that_no_message_has_are_told) {
  const Recording recording{stream("/a", stamped({1}))};
  EXPECT_THAT(unknown_fields(recording, {false, {"data", "header.stamp", "data[]", "pose"}}),
              ::testing::ElementsAre("data", "pose"));
}

TEST(verdict, a_port_that_falls_silent_is_not_equal) {
  const auto arriving = [](const std::vector<int>& numbers, int end) {
    Stream arrived = stream("/a", stamped(numbers));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      arrived.messages[i].received_ns = 1'000'000'000LL * numbers[i];
    arrived.recorded_until_ns = 1'000'000'000LL * end;
    return Recording{arrived};
  };
  const Recording original = arriving({1, 2, 3, 4, 5, 6, 7, 8, 9}, 10);
  const auto judged = [&](const Recording& port) {
    return judge({compare_recordings(original, original, {})}, compare_recordings(original, port, {}), {})
        .at(0);
  };
  EXPECT_EQ(judged(arriving({1, 2, 3, 4}, 8)).outcome, Outcome::equal)
      << "4 s: twice 1 s, and 2 s, are chance";
  const StreamVerdict silent = judged(arriving({1, 2, 3, 4}, 9));
  EXPECT_EQ(silent.outcome, Outcome::different);
  EXPECT_EQ(silent.findings.at(0).cause, Cause::loss);
  EXPECT_EQ(silent.findings.at(0).detail, "the port has published nothing in its last 5.0 s");
  EXPECT_EQ(judged(arriving({1, 2, 3, 4}, 5)).outcome, Outcome::equal) << "its recording was shorter";
}

TEST(verdict, the_beginning_of_a_late_topic_does_not_count) {
  const std::vector<std::vector<Bytes>> original{stamped({1, 2, 3, 4}), stamped({1, 2, 3, 4})};
  EXPECT_EQ(verdict(original, stamped({2, 3, 4}), {{"/a"}, true, true, 0, false}).outcome, Outcome::equal);
  EXPECT_EQ(verdict(original, stamped({2, 4}), {{"/a"}, true, true, 0, false}).outcome, Outcome::different);
}

TEST(verdict, extra_and_reordered_messages) {
  const std::vector<std::vector<Bytes>> original{stamped({1, 2, 3}), stamped({1, 2, 3})};
  const StreamVerdict doubled = verdict(original, stamped({1, 2, 2, 3}));
  EXPECT_EQ(doubled.findings.at(0).cause, Cause::extra);
  EXPECT_THAT(doubled.findings.at(0).detail, HasSubstr("1 of them repeat"));
  const StreamVerdict moved = verdict(original, stamped({2, 1, 3}));
  EXPECT_EQ(moved.findings.at(0).cause, Cause::order);
  EXPECT_EQ(moved.outcome, Outcome::different);
}

TEST(verdict, what_the_original_does_not_repeat_is_no_difference) {
  const StreamVerdict judged =
      verdict({unstamped({1, 2, 3}, 1), unstamped({1, 2, 3}, 2)}, unstamped({1, 2, 3}, 3));
  EXPECT_EQ(judged.outcome, Outcome::own_differences);
  EXPECT_EQ(judged.findings.at(0).field, "header.stamp");
  EXPECT_FALSE(judged.findings.at(0).is_different);
}

TEST(verdict, a_field_beside_the_nondeterministic_one_counts) {
  auto port = unstamped({1, 2, 3}, 3);
  port[2].back() ^= 1U;
  const StreamVerdict judged = verdict({unstamped({1, 2, 3}, 1), unstamped({1, 2, 3}, 2)}, port);
  EXPECT_EQ(judged.outcome, Outcome::different);
  EXPECT_EQ(judged.findings.at(0).field, "data[]");
}

TEST(verdict, what_the_original_does_rarely_the_port_may_not_do_often) {
  std::vector<int> numbers(100);
  for (int i = 0; i < 100; ++i) numbers[static_cast<std::size_t>(i)] = i + 1;
  auto second = stamped(numbers), few = stamped(numbers), many = stamped(numbers);
  second[50].back() ^= 1U;  // 1 %
  for (std::size_t i = 0; i < 5; ++i) few[i].back() ^= 1U;
  for (std::size_t i = 0; i < 20; ++i) many[i].back() ^= 1U;
  EXPECT_EQ(verdict({stamped(numbers), second}, few).outcome, Outcome::own_differences);
  EXPECT_EQ(verdict({stamped(numbers), second}, many).outcome, Outcome::different);
}

TEST(verdict, strict_does_not_excuse_content) {
  auto second = stamped({1, 2, 3}), port = stamped({1, 2, 3});
  second[0].back() ^= 1U;
  port[0].back() ^= 2U;
  EXPECT_EQ(verdict({stamped({1, 2, 3}), second}, port).outcome, Outcome::own_differences);
  EXPECT_EQ(verdict({stamped({1, 2, 3}), second}, port, {{}, true, true, 0, true}).outcome,
            Outcome::different);
  EXPECT_EQ(
      verdict({unstamped({1, 2}, 1), unstamped({1, 2}, 2)}, unstamped({1, 2}, 3), {{}, true, true, 0, true})
          .outcome,
      Outcome::own_differences)
      << "stamps are excused always";
}

TEST(verdict, losses_of_the_original_in_either_direction_excuse_the_port) {
  EXPECT_EQ(verdict({stamped({1, 2, 4, 5}), stamped({1, 2, 3, 4, 5})}, stamped({1, 2, 5})).outcome,
            Outcome::own_differences);
}

TEST(verdict, an_allowed_share_of_losses) {
  const std::vector<std::vector<Bytes>> original{stamped({1, 2, 3, 4}), stamped({1, 2, 3, 4})};
  EXPECT_EQ(verdict(original, stamped({1, 2, 4}), {{}, true, true, 0.25, false}).outcome,
            Outcome::own_differences);
  EXPECT_EQ(verdict(original, stamped({1, 4}), {{}, true, true, 0.25, false}).outcome, Outcome::different);
}

TEST(verdict, stamps_on_request) {
  auto port = stamped({1, 2, 3});
  port[1][8] ^= 1U;  // nanoseconds
  const std::vector<std::vector<Bytes>> original{stamped({1, 2, 3}), stamped({1, 2, 3})};
  EXPECT_EQ(verdict(original, port).outcome, Outcome::different);
  EXPECT_EQ(
      verdict({unstamped({1, 2}, 1)}, unstamped({1, 2}, 2), {{}, true, true, 0, false}, {true, {}}).outcome,
      Outcome::equal);
}

TEST(verdict, topics_that_come_and_go) {
  const Recording both{stream("/a", stamped({1})), stream("/b", stamped({1}))},
      one{stream("/a", stamped({1}))};
  const auto missing = judge({compare_recordings(both, both, {})}, compare_recordings(both, one, {}), {});
  EXPECT_EQ(missing.at(1).outcome, Outcome::different);
  EXPECT_EQ(missing.at(1).findings.at(0).cause, Cause::not_published);
  const auto extra = judge({compare_recordings(one, one, {})}, compare_recordings(one, both, {}), {});
  EXPECT_EQ(extra.at(1).findings.at(0).cause, Cause::new_topic);
  const auto varies = judge({compare_recordings(both, one, {})}, compare_recordings(both, one, {}), {});
  EXPECT_FALSE(is_different(varies)) << "the original does not always advertise it either";
}

TEST(verdict, another_type) {
  Stream port = stream("/a", stamped({1}));
  port.md5sum = "other";
  const auto judged = judge({}, compare_recordings({stream("/a", stamped({1}))}, {port}, {}), {});
  EXPECT_EQ(judged.at(0).findings.at(0).cause, Cause::type);
  EXPECT_TRUE(is_different(judged));
}

TEST(verdict, a_silent_topic) {
  EXPECT_EQ(verdict({{}, {}}, {}).outcome, Outcome::silent);
}

TEST(recording, anonymous_nodes_keep_their_name) {
  EXPECT_EQ(without_anonymous_part("/viewer_1700000000000000000"), "/viewer_*");
  EXPECT_EQ(without_anonymous_part("/ns/rostopic_4242_1700000000000"), "/ns/rostopic_*");
  EXPECT_EQ(without_anonymous_part("/camera_2"), "/camera_2");
  EXPECT_EQ(without_anonymous_part("/camera"), "/camera");
}

TEST(latency, from_the_input_with_the_same_stamp) {
  Stream output = stream("/a", stamped({1, 2, 3}));
  for (MessageFacts& message : output.messages) message.received_ns = message.header->nanoseconds + 5'000'000;
  const InputTimes inputs{{1'000'000'000, 1'003'000'000}, {3'000'000'000, 3'004'000'000}};
  const auto latency = latency_of(output, inputs);
  ASSERT_TRUE(latency);
  EXPECT_EQ(latency->messages, 2U);
  EXPECT_EQ(latency->median_us, 2000);
  EXPECT_EQ(latency_of(output, {})->median_us, 5000) << "without input from the stamp";
}

TEST(latency, unknown_for_stamps_of_another_day) {
  Stream output = stream("/a", stamped({1}));
  output.messages[0].received_ns = 1'700'000'000'000'000'000;
  EXPECT_FALSE(latency_of(output, {}));
}

}  // namespace
}  // namespace tzc::compare
