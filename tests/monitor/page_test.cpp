// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page_in_memory.h"
#include "processes.h"
#include "statistics/page_writer.h"

namespace tzc::monitor {
namespace {

namespace layout = statistics;

// Older and newer builds read a page: when one of these fails, raise page_version and write the new numbers here.
TEST(PageLayout, stays_as_it_is_for_this_version) {
  EXPECT_EQ(layout::page_version, 2u);
  EXPECT_EQ(sizeof(layout::PageHeader), 288u);
  EXPECT_EQ(offsetof(layout::PageHeader, node), 32u);
  EXPECT_EQ(sizeof(layout::TableHeader), 24u);
  EXPECT_EQ(sizeof(layout::TopicRow), 496u);
  EXPECT_EQ(offsetof(layout::TopicRow, memory), 72u);
  EXPECT_EQ(offsetof(layout::TopicRow, topic), 112u);
  EXPECT_EQ(sizeof(layout::ConnectionRow), 608u);
  EXPECT_EQ(offsetof(layout::ConnectionRow, pid), 88u);
  EXPECT_EQ(offsetof(layout::ConnectionRow, subscriber), 96u);
  EXPECT_EQ(sizeof(layout::SubscriptionRow), 768u);
  EXPECT_EQ(offsetof(layout::SubscriptionRow, latencies), 56u);
  EXPECT_EQ(offsetof(layout::SubscriptionRow, topic), 256u);
  EXPECT_EQ(layout::row_bytes, 768u);
  EXPECT_EQ(layout::table_offset(1), 65536u + 851968u);
  EXPECT_EQ(layout::page_bytes, 65536u + 2 * 851968u);
}

TEST(Page, has_topics_and_their_connections) {
  PageInMemory page;
  page.add_topic(2, 0, "/image").counters.messages = 7;
  page.add_connection(2, 1, "/viewer").held = 3;
  page.add_connection(2, 2, "/recorder");
  page.add_topic(2, 3, "/depth");
  page.publish(2, 4);
  Node node;
  std::string trouble;
  ASSERT_TRUE(read_page(page.reader(), node, trouble)) << trouble;
  EXPECT_EQ(node.name, "/camera");
  EXPECT_EQ(node.pid, 42u);
  EXPECT_EQ(node.updated_ns, 1000u);
  ASSERT_EQ(node.topics.size(), 2u);
  EXPECT_EQ(node.topics[0].name, "/image");
  EXPECT_EQ(node.topics[0].type, "sensor_msgs/Image");
  EXPECT_EQ(node.topics[0].counters.messages, 7u);
  ASSERT_EQ(node.topics[0].connections.size(), 2u);
  EXPECT_EQ(node.topics[0].connections[0].subscriber, "/viewer");
  EXPECT_EQ(node.topics[0].connections[0].transport, Transport::shared);
  EXPECT_EQ(node.topics[0].connections[0].held, 3u);
  EXPECT_TRUE(node.topics[1].connections.empty());
}

TEST(Page, has_subscriptions_in_any_place) {
  PageInMemory page;
  page.add_subscription(2, 0, "/image", "/camera").latencies[5] = 9;
  page.add_topic(2, 1, "/result");
  page.add_subscription(2, 2, "/depth", "/\x1b[31m").held_messages = 4;
  page.publish(2, 3);
  Node node;
  std::string trouble;
  ASSERT_TRUE(read_page(page.reader(), node, trouble)) << trouble;
  ASSERT_EQ(node.subscriptions.size(), 2u);
  EXPECT_EQ(node.subscriptions[0].topic, "/image");
  EXPECT_EQ(node.subscriptions[0].publisher, "/camera");
  EXPECT_EQ(node.subscriptions[0].latencies[5], 9u);
  EXPECT_EQ(node.subscriptions[1].publisher, "/?[31m");
  EXPECT_EQ(node.subscriptions[1].held_messages, 4u);
  ASSERT_EQ(node.topics.size(), 1u);
  EXPECT_TRUE(node.topics[0].connections.empty());
}

TEST(Page, without_a_table_has_no_topics_yet) {
  PageInMemory page;
  Node node;
  std::string trouble;
  EXPECT_TRUE(read_page(page.reader(), node, trouble));
  EXPECT_TRUE(node.topics.empty());
}

/// Its writer publishes once more while the table is copied.
TEST(Page, is_read_again_when_it_was_published_meanwhile) {
  PageInMemory page;
  page.add_topic(2, 0, "/old");
  page.publish(2, 1);
  const auto changing = [&](void* to, std::size_t bytes, std::uint64_t offset) {
    const std::size_t size = page.read(to, bytes, offset);
    if (bytes == layout::row_bytes && page.header().published == 2) {
      page.add_topic(3, 0, "/new");
      page.publish(3, 1);
    }
    return size;
  };
  Node node;
  std::string trouble;
  ASSERT_TRUE(read_page(changing, node, trouble)) << trouble;
  ASSERT_EQ(node.topics.size(), 1u);
  EXPECT_EQ(node.topics[0].name, "/new");
}

/// What the transport writes, read as the tool reads it.
class WrittenPage : public testing::Test {
 protected:
  WrittenPage() : page_(*layout::PageWriter::create("/the_writer")) {}

  static layout::TopicRow topic(const std::string& name) {
    layout::TopicRow row{};
    row.kind = layout::RowKind::topic;
    layout::copy_text(row.topic, name);
    return row;
  }
  /// This process, as a sample of /proc shows it.
  static std::optional<Node> self() {
    for (const Node& node : take_sample().nodes)
      if (node.pid == static_cast<std::uint32_t>(::getpid())) return node;
    return std::nullopt;
  }
  std::shared_ptr<layout::PageWriter> page_;
};

TEST_F(WrittenPage, is_found_in_proc) {
  page_->begin();
  page_->add(topic("/image"));
  page_->publish();
  const std::optional<Node> node = self();
  ASSERT_TRUE(node);
  EXPECT_EQ(node->name, "/the_writer");
  EXPECT_EQ(node->state, State::running);
  EXPECT_LT(node->age_s, 5);
  ASSERT_EQ(node->topics.size(), 1u);
  EXPECT_EQ(node->topics[0].name, "/image");
}

TEST_F(WrittenPage, shows_the_last_table_while_the_next_one_is_written) {
  for (const char* name : {"/first", "/second", "/third"}) {
    page_->begin();
    page_->add(topic(name));
    page_->publish();
  }
  page_->begin();
  page_->add(topic("/unfinished"));
  const std::optional<Node> node = self();
  ASSERT_TRUE(node);
  ASSERT_EQ(node->topics.size(), 1u);
  EXPECT_EQ(node->topics[0].name, "/third");
}

TEST_F(WrittenPage, counts_what_has_no_room) {
  page_->begin();
  for (std::uint32_t i = 0; i < layout::most_rows + 5; ++i)
    page_->add(topic("/t" + std::to_string(1000 + i)));
  page_->publish();
  const std::optional<Node> node = self();
  ASSERT_TRUE(node);
  EXPECT_EQ(node->topics.size(), layout::most_rows);
  EXPECT_EQ(node->topics.back().name, "/t" + std::to_string(1000 + layout::most_rows - 1));
  EXPECT_EQ(node->left_out, 5u);
}

TEST_F(WrittenPage, repeats_what_could_not_be_looked_at) {
  layout::ConnectionRow connection{};
  connection.kind = layout::RowKind::connection;
  layout::SubscriptionRow subscription{};
  subscription.kind = layout::RowKind::subscription;
  page_->begin();
  for (const char* name : {"/image", "/imagery", "/depth"}) {
    page_->add(topic(name));
    layout::copy_text(connection.subscriber, name + std::string("_viewer"));
    page_->add(connection);
  }
  layout::copy_text(subscription.topic, "/heard");
  page_->add(subscription);
  page_->publish();
  for (int round = 0; round < 2; ++round) {
    page_->begin();
    page_->add(topic("/depth"));
    page_->repeat_connections("/depth");
    page_->add(topic("/image"));
    page_->repeat_connections("/image");
    page_->add(topic("/new"));
    page_->repeat_connections("/new");
    page_->repeat_subscriptions();
    page_->publish();
  }
  const std::optional<Node> node = self();
  ASSERT_TRUE(node);
  ASSERT_EQ(node->topics.size(), 3u);
  ASSERT_EQ(node->topics[0].connections.size(), 1u);
  EXPECT_EQ(node->topics[0].connections[0].subscriber, "/depth_viewer");
  ASSERT_EQ(node->topics[1].connections.size(), 1u);
  EXPECT_EQ(node->topics[1].connections[0].subscriber, "/image_viewer");
  EXPECT_TRUE(node->topics[2].connections.empty());
  ASSERT_EQ(node->subscriptions.size(), 1u);
}

// A reader has the published one meanwhile.
TEST_F(WrittenPage, writes_a_table_that_was_not_published_anew) {
  layout::ConnectionRow connection{};
  connection.kind = layout::RowKind::connection;
  page_->begin();
  page_->add(topic("/image"));
  page_->add(connection);
  page_->publish();
  for (int i = 0; i < 2; ++i) {
    page_->begin();
    page_->add(topic("/other"));
    ASSERT_EQ(self()->topics.at(0).name, "/image");
  }
  page_->begin();
  page_->add(topic("/image"));
  page_->repeat_connections("/image");
  page_->publish();
  const std::optional<Node> node = self();
  ASSERT_TRUE(node);
  ASSERT_EQ(node->topics.size(), 1u);
  EXPECT_EQ(node->topics[0].connections.size(), 1u);
}

TEST_F(WrittenPage, cuts_long_names) {
  page_->begin();
  page_->add(topic("/" + std::string(400, 'x')));
  page_->publish();
  EXPECT_EQ(self()->topics.at(0).name, "/" + std::string(layout::name_bytes - 2, 'x'));
}

}  // namespace
}  // namespace tzc::monitor
