// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "page.h"
#include "statistics/page_layout.h"

namespace tzc::monitor {

/// A page as bytes, which a test can change at will.
class PageInMemory {
 public:
  PageInMemory() : bytes_(statistics::page_bytes, 0) {
    auto* const header = new (bytes_.data()) statistics::PageHeader{};
    header->magic = statistics::page_magic;
    header->version = statistics::page_version;
    header->pid = 42;
    header->started_ns = 1;
    std::strcpy(header->node, "/camera");
  }

  statistics::PageHeader& header() { return *reinterpret_cast<statistics::PageHeader*>(bytes_.data()); }
  statistics::TableHeader& table(std::uint64_t number) {
    return *reinterpret_cast<statistics::TableHeader*>(bytes_.data() + statistics::table_offset(number));
  }
  template <class Row>
  Row& row(std::uint64_t number, std::size_t i) {
    return *reinterpret_cast<Row*>(bytes_.data() + statistics::table_offset(number) +
                                   sizeof(statistics::TableHeader) + i * statistics::row_bytes);
  }

  void publish(std::uint64_t number, std::uint32_t rows, std::uint64_t updated_ns = 1000) {
    table(number) = statistics::TableHeader{number, updated_ns, rows, 0};
    header().published = number;
  }
  statistics::TopicRow& add_topic(std::uint64_t number, std::size_t i, const std::string& name) {
    auto& topic = row<statistics::TopicRow>(number, i);
    topic.kind = statistics::RowKind::topic;
    std::strcpy(topic.topic, name.c_str());
    std::strcpy(topic.type, "sensor_msgs/Image");
    return topic;
  }
  statistics::ConnectionRow& add_connection(std::uint64_t number, std::size_t i,
                                            const std::string& subscriber) {
    auto& connection = row<statistics::ConnectionRow>(number, i);
    connection.kind = statistics::RowKind::connection;
    connection.transport = statistics::Transport::shared;
    std::strcpy(connection.subscriber, subscriber.c_str());
    return connection;
  }
  statistics::SubscriptionRow& add_subscription(std::uint64_t number, std::size_t i, const std::string& topic,
                                                const std::string& publisher) {
    auto& subscription = row<statistics::SubscriptionRow>(number, i);
    subscription.kind = statistics::RowKind::subscription;
    subscription.transport = statistics::Transport::shared;
    std::strcpy(subscription.topic, topic.c_str());
    std::strcpy(subscription.publisher, publisher.c_str());
    return subscription;
  }

  std::size_t read(void* to, std::size_t bytes, std::uint64_t offset) const {
    if (bytes == 0 || offset >= bytes_.size()) return 0;
    const std::size_t size = std::min<std::size_t>(bytes, bytes_.size() - offset);
    std::memcpy(to, bytes_.data() + offset, size);
    return size;
  }
  ReadAt reader() const {
    return [this](void* to, std::size_t bytes, std::uint64_t offset) { return read(to, bytes, offset); };
  }
  std::vector<char>& bytes() { return bytes_; }

 private:
  std::vector<char> bytes_;
};

}  // namespace tzc::monitor
