// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <vector>

#include "statistics/page_layout.h"

namespace tzc::monitor {
namespace {

namespace layout = statistics;

/// At one table a second an honest writer publishes at most one during a copy.
constexpr int tries = 8;

template <std::size_t size>
std::string text_of(const char (&field)[size]) {
  std::string text(field, strnlen(field, size));
  for (char& c : text)
    if (c < 0x20 || c > 0x7e) c = '?';
  return text;
}

/// The header's bytes: an atomic cannot be copied.
struct RawHeader {
  std::uint64_t magic;
  std::uint32_t version, pid;
  std::uint64_t started_ns, published;
  char node[layout::name_bytes];
};
static_assert(sizeof(RawHeader) == sizeof(layout::PageHeader), "it is the header");

template <class Value>
bool read_value(const ReadAt& read_at, std::uint64_t offset, Value& value) {
  return read_at(&value, sizeof value, offset) == sizeof value;
}

Transport transport_of(layout::Transport transport) {
  switch (transport) {
    case layout::Transport::shared:
      return Transport::shared;
    case layout::Transport::tcpros:
      return Transport::tcpros;
    case layout::Transport::udpros:
      return Transport::udpros;
    case layout::Transport::intraprocess:
      return Transport::intraprocess;
  }
  return Transport::unknown;
}

Topic topic_of(const layout::TopicRow& row) {
  Topic topic;
  topic.name = text_of(row.topic);
  topic.type = text_of(row.type);
  topic.counters = row.counters;
  topic.memory = row.memory;
  return topic;
}

Connection connection_of(const layout::ConnectionRow& row) {
  Connection connection;
  connection.subscriber = text_of(row.subscriber);
  connection.transport = transport_of(row.transport);
  connection.reason = text_of(row.reason);
  connection.messages = row.messages;
  connection.bytes = row.bytes;
  connection.in_flight = row.in_flight;
  connection.held = row.held;
  connection.revoked = row.revoked;
  connection.shared_bytes = row.shared_bytes;
  connection.revoked_for_queue = row.revoked_for_queue;
  connection.revoked_for_memory = row.revoked_for_memory;
  connection.revoked_at_end = row.revoked_at_end;
  connection.oldest_held_s = static_cast<double>(row.oldest_held_ms) / 1000;
  connection.pid = row.pid;
  return connection;
}

Subscription subscription_of(const layout::SubscriptionRow& row) {
  Subscription subscription;
  subscription.topic = text_of(row.topic);
  subscription.publisher = text_of(row.publisher);
  subscription.transport = transport_of(row.transport);
  subscription.messages = row.messages;
  subscription.lost = row.lost;
  subscription.bytes = row.bytes;
  subscription.shared_bytes = row.shared_bytes;
  subscription.held_messages = row.held_messages;
  subscription.held_bytes = row.held_bytes;
  std::copy(std::begin(row.latencies), std::end(row.latencies), subscription.latencies.begin());
  subscription.pid = row.pid;
  return subscription;
}

template <class Row>
Row row_at(const std::vector<char>& rows, std::size_t i) {
  Row row;
  std::memcpy(&row, rows.data() + i * layout::row_bytes, sizeof row);
  return row;
}

/// A connection without a topic above it, and a row of an unknown kind, are left out.
void parse_rows(const std::vector<char>& rows, Node& node) {
  std::vector<Topic>& topics = node.topics;
  for (std::size_t i = 0; i < rows.size() / layout::row_bytes; ++i) {
    std::uint32_t kind = 0;
    std::memcpy(&kind, rows.data() + i * layout::row_bytes, sizeof kind);
    if (kind == static_cast<std::uint32_t>(layout::RowKind::topic))
      topics.push_back(topic_of(row_at<layout::TopicRow>(rows, i)));
    else if (kind == static_cast<std::uint32_t>(layout::RowKind::connection) && !topics.empty())
      topics.back().connections.push_back(connection_of(row_at<layout::ConnectionRow>(rows, i)));
    else if (kind == static_cast<std::uint32_t>(layout::RowKind::subscription))
      node.subscriptions.push_back(subscription_of(row_at<layout::SubscriptionRow>(rows, i)));
  }
}

/// False: the table is not that number's, or its count of rows is out of range.
bool read_table(const ReadAt& read_at, std::uint64_t number, layout::TableHeader& table,
                std::vector<char>& rows) {
  const std::uint64_t offset = layout::table_offset(number);
  if (!read_value(read_at, offset, table) || table.number != number || table.rows > layout::most_rows)
    return false;
  rows.resize(table.rows * layout::row_bytes);
  return read_at(rows.data(), rows.size(), offset + sizeof table) == rows.size();
}

/// The number of the newest table; the fences keep the copies on their side of it.
bool read_published(const ReadAt& read_at, std::uint64_t& number) {
  std::atomic_thread_fence(std::memory_order_seq_cst);
  const bool was_read = read_value(read_at, offsetof(RawHeader, published), number);
  std::atomic_thread_fence(std::memory_order_seq_cst);
  return was_read;
}

bool refuse(std::string& trouble, const char* why) {
  trouble = why;
  return false;
}

}  // namespace

bool read_page(const ReadAt& read_at, Node& node, std::string& trouble) {
  RawHeader header;
  if (!read_value(read_at, 0, header) || header.magic != layout::page_magic)
    return refuse(trouble, "it is not a statistics page");
  if (header.version != layout::page_version) return refuse(trouble, "it is of another version of TZC");
  node.name = text_of(header.node);
  node.pid = header.pid;
  node.started_ns = header.started_ns;
  for (int i = 0; i < tries; ++i) {
    std::uint64_t before = 0, after = 0;
    if (!read_published(read_at, before)) break;
    if (before == 0) return true;  // it has no table yet
    layout::TableHeader table;
    std::vector<char> rows;
    const bool is_table = read_table(read_at, before, table, rows);
    if (!read_published(read_at, after)) break;
    if (!is_table || after != before) continue;
    node.updated_ns = table.updated_ns;
    node.left_out = table.left_out;
    parse_rows(rows, node);
    return true;
  }
  return refuse(trouble, "it changes while it is read, or is damaged");
}

}  // namespace tzc::monitor
