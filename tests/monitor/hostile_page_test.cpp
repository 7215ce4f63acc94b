// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "json_report.h"
#include "page_in_memory.h"
#include "rates.h"
#include "table.h"
#include "why.h"

namespace tzc::monitor {
namespace {

using testing::HasSubstr;

std::string trouble_of(const ReadAt& reader) {
  Node node;
  std::string trouble;
  EXPECT_FALSE(read_page(reader, node, trouble));
  return trouble;
}

TEST(HostilePage, of_another_kind_or_version_is_refused) {
  PageInMemory page;
  page.header().magic ^= 1;
  EXPECT_THAT(trouble_of(page.reader()), HasSubstr("not a statistics page"));
  page.header().magic ^= 1;
  page.header().version = statistics::page_version + 1;
  EXPECT_THAT(trouble_of(page.reader()), HasSubstr("another version"));
}

TEST(HostilePage, with_a_count_out_of_range_is_refused) {
  PageInMemory page;
  for (const std::uint32_t rows : {statistics::most_rows + 1, 0x7fffffffu, 0xffffffffu}) {
    page.publish(1, rows);
    EXPECT_THAT(trouble_of(page.reader()), HasSubstr("damaged"));
  }
}

TEST(HostilePage, whose_table_has_another_number_is_refused) {
  PageInMemory page;
  page.publish(1, 0);
  page.header().published = 3;
  EXPECT_THAT(trouble_of(page.reader()), HasSubstr("damaged"));
}

TEST(HostilePage, that_is_cut_short_is_refused_wherever_it_ends) {
  PageInMemory page;
  page.add_topic(1, 0, "/image");
  page.publish(1, 1);
  const std::size_t end =
      statistics::table_offset(1) + sizeof(statistics::TableHeader) + statistics::row_bytes;
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, std::size_t{287}, std::size_t{288},
                                 statistics::table_offset(1) + 1, end - 1}) {
    page.bytes().resize(size);
    EXPECT_NE(trouble_of(page.reader()), "") << size;
    page.bytes().resize(statistics::page_bytes);
    page = PageInMemory();
    page.add_topic(1, 0, "/image");
    page.publish(1, 1);
  }
}

TEST(HostilePage, that_never_holds_still_is_given_up) {
  PageInMemory page;
  std::uint64_t number = 1;
  page.publish(number, 0);
  int reads = 0;
  const auto changing = [&](void* to, std::size_t bytes, std::uint64_t offset) {
    ++reads;
    const std::size_t size = page.read(to, bytes, offset);
    if (offset >= statistics::page_granule) page.publish(++number, 0);
    return size;
  };
  EXPECT_THAT(trouble_of(changing), HasSubstr("changes while it is read"));
  EXPECT_LT(reads, 100);
}

TEST(HostilePage, with_texts_that_do_not_end_or_that_command_the_terminal) {
  PageInMemory page;
  auto& topic = page.add_topic(1, 0, "");
  std::memset(topic.topic, 'x', sizeof topic.topic);
  std::memset(topic.type, 0xff, sizeof topic.type);
  std::memset(page.header().node, '\n', sizeof page.header().node);
  auto& connection = page.add_connection(1, 1, "/\x1b[2J\x07viewer");
  connection.transport = static_cast<statistics::Transport>(77);
  std::memset(connection.reason, '"', sizeof connection.reason);
  page.publish(1, 2);
  Node node;
  std::string trouble;
  ASSERT_TRUE(read_page(page.reader(), node, trouble)) << trouble;
  EXPECT_EQ(node.name, std::string(statistics::name_bytes, '?'));
  EXPECT_EQ(node.topics.at(0).name, std::string(statistics::name_bytes, 'x'));
  EXPECT_EQ(node.topics.at(0).type, std::string(statistics::name_bytes / 2, '?'));
  EXPECT_EQ(node.topics.at(0).connections.at(0).subscriber, "/?[2J?viewer");
  EXPECT_EQ(node.topics.at(0).connections.at(0).transport, Transport::unknown);
}

TEST(HostilePage, with_connections_of_no_topic_and_rows_of_no_kind) {
  PageInMemory page;
  page.add_connection(1, 0, "/orphan");
  page.add_topic(1, 1, "/image").kind = static_cast<statistics::RowKind>(9);
  page.add_topic(1, 2, "/depth");
  page.publish(1, 3);
  Node node;
  std::string trouble;
  ASSERT_TRUE(read_page(page.reader(), node, trouble)) << trouble;
  ASSERT_EQ(node.topics.size(), 1u);
  EXPECT_EQ(node.topics[0].name, "/depth");
  EXPECT_TRUE(node.topics[0].connections.empty());
}

/// Random bytes in the places that steer the reader, and anywhere else: whatever it accepts can be printed in every
/// format, within the limits of a page and without a byte that a terminal would take for a command.
TEST(HostilePage, of_random_bytes_is_refused_or_printed) {
  std::mt19937_64 random(20);
  int accepted = 0;
  std::vector<Node> before;
  for (int round = 0; round < 400; ++round) {
    PageInMemory page;
    const auto rows = static_cast<std::uint32_t>(random() % 8);
    const std::size_t offset = statistics::table_offset(1);
    for (std::size_t i = 0; i < rows * statistics::row_bytes; ++i)
      page.bytes()[offset + sizeof(statistics::TableHeader) + i] = static_cast<char>(random());
    for (std::uint32_t i = 0; i < rows; ++i)
      page.row<statistics::TopicRow>(1, i).kind = static_cast<statistics::RowKind>(random() % 4);
    page.publish(1, rows, random());
    for (int i = 0; i < 2; ++i) page.bytes()[random() % 64] ^= static_cast<char>(1 << random() % 8);
    Node node;
    std::string trouble;
    if (!read_page(page.reader(), node, trouble)) {
      EXPECT_NE(trouble, "");
      continue;
    }
    ++accepted;
    std::vector<Node> nodes{node};
    add_rates(before, nodes);
    ASSERT_LE(node.topics.size(), 8u);
    const std::string text = tzc::monitor::table(nodes, false);
    for (const char c : text) ASSERT_TRUE(c == '\n' || (c >= 0x20 && c <= 0x7e)) << static_cast<int>(c);
    EXPECT_EQ(json_report(nodes).front(), '{');
    (void)explain(nodes, node.name, node.topics.empty() ? "" : node.topics[0].name);
    before = nodes;
  }
  EXPECT_GT(accepted, 50);  // or else the test tests nothing
}

}  // namespace
}  // namespace tzc::monitor
