// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/statistics_updater.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/this_node.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "roscpp/configuration.h"
#include "roscpp/descriptor_budget.h"
#include "roscpp/publish/memory_of_no_topic.h"
#include "roscpp/publish/publication_endpoint.h"

namespace tzc {
namespace detail {
namespace {

using statistics::copy_text;

constexpr std::chrono::seconds kPeriod(1);
/// After a round that found some links in use.
constexpr std::chrono::milliseconds kAgain(100);

statistics::TopicRow row_of(const EndpointStatistics& seen) {
  statistics::TopicRow row{};
  row.kind = statistics::RowKind::topic;
  const PublisherStatistics& counted = seen.counters;
  row.counters = {counted.messages,      counted.shared,    counted.serialized, counted.copied_bytes,
                  counted.control_bytes, counted.exhausted, counted.dropped,    counted.revoked};
  const MemoryStats& memory = seen.memory;
  row.memory = {memory.segments, memory.size_bytes, memory.reserved_bytes, memory.used_bytes,
                memory.used_blocks};
  copy_text(row.topic, seen.topic);
  copy_text(row.type, seen.type);
  return row;
}

/// What the node allocated: its memory alone, since messages count where they are published.
statistics::TopicRow row_of_no_topic(const MemoryStats& memory) {
  EndpointStatistics seen;
  seen.topic = no_topic;
  seen.memory = memory;
  return row_of(seen);
}

statistics::ConnectionRow row_of(const LinkStatistics& seen) {
  statistics::ConnectionRow row{};
  row.kind = statistics::RowKind::connection;
  row.transport = seen.transport;
  row.messages = seen.messages;
  row.bytes = seen.bytes;
  row.in_flight = seen.in_flight;
  row.held = seen.inspection.held.size();
  row.shared_bytes = seen.inspection.shared_bytes;
  row.revoked_for_queue = seen.inspection.dropped_for_queue;
  row.revoked_for_memory = seen.inspection.dropped_for_memory;
  row.revoked_at_end = seen.inspection.dropped_at_end;
  row.revoked = seen.revoked;
  row.pid = seen.pid;
  copy_text(row.subscriber, seen.subscriber);
  copy_text(row.reason, seen.reason);
  return row;
}

static_assert(channel::latency_buckets == statistics::latency_buckets, "a row has one place for each bucket");

statistics::SubscriptionRow row_of(const SubscriptionStatistics& seen) {
  statistics::SubscriptionRow row{};
  row.kind = statistics::RowKind::subscription;
  row.transport = seen.transport;
  row.messages = seen.messages;
  row.lost = seen.lost;
  row.bytes = seen.bytes;
  row.shared_bytes = seen.inspection.shared_bytes;
  row.held_messages = seen.held_messages;
  row.held_bytes = seen.held_bytes;
  std::copy(seen.inspection.latencies.begin(), seen.inspection.latencies.end(), row.latencies);
  row.pid = seen.pid;
  copy_text(row.topic, seen.topic);
  copy_text(row.publisher, seen.publisher);
  return row;
}

std::uint64_t now_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::milliseconds(std::chrono::duration_cast<std::chrono::milliseconds>(now)).count());
}

}  // namespace

void StatisticsUpdater::begin() {
  if (page_) return go_on();
  if (!has_statistics_page() || !has_spare_descriptors()) return;
  Expected<std::shared_ptr<statistics::PageWriter>> page =
      statistics::PageWriter::create(ros::this_node::getName());
  if (!page) {
    ROS_DEBUG_STREAM("TZC: tzc-monitor does not see this node: " << page.error().text());
    return;
  }
  page_ = std::move(*page);
  go_on();
}

void StatisticsUpdater::go_on() {
  if (!std::exchange(is_running_, true)) update();
}

// Goes on after a round that failed for want of memory: the next one may succeed.
void StatisticsUpdater::update() {
  is_running_ = !ros::isShuttingDown();  // the node may be started again
  if (!is_running_) return;
  bool is_complete = true;
  try {
    is_complete = write();
  } catch (const std::exception& error) {
    ROS_DEBUG_STREAM("TZC: the statistics page stays as it is: " << error.what());
  }
  const std::chrono::microseconds pause = is_complete ? std::chrono::microseconds(kPeriod) : kAgain;
  is_running_ = false;  // without memory for the job, it ends, and the next connection begins it again
  clerk_.post([this] { update(); }, pause);
  is_running_ = true;
}

void StatisticsUpdater::add_plain(const ros::PublicationPtr& publication, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(plain_mutex_);
  // Not locked: the last reference to a publication must not go under this mutex.
  const auto is_same = [&](const PlainTopic& one) {
    return !one.publication.owner_before(publication) && !publication.owner_before(one.publication);
  };
  if (std::none_of(plain_.begin(), plain_.end(), is_same)) plain_.push_back({publication, reason});
}

std::vector<EndpointStatistics> StatisticsUpdater::look_at_plain() {
  std::vector<PlainTopic> topics;
  {
    const std::lock_guard<std::mutex> lock(plain_mutex_);
    const auto is_over = [](const PlainTopic& one) { return one.publication.expired(); };
    plain_.erase(std::remove_if(plain_.begin(), plain_.end(), is_over), plain_.end());
    topics = plain_;
  }
  std::vector<EndpointStatistics> all;
  for (const PlainTopic& topic : topics) {
    const ros::PublicationPtr publication = topic.publication.lock();
    if (!publication) continue;
    EndpointStatistics seen;
    seen.topic = publication->getName();
    seen.type = publication->getDataType();
    seen.has_links = read_links(*publication, [&](const auto&) { return topic.reason; }, seen.links);
    all.push_back(std::move(seen));
  }
  return all;
}

bool StatisticsUpdater::add(const EndpointStatistics& seen, Held& held) {
  page_->add(row_of(seen));
  std::vector<channel::HeldBlock> of_topic =
      seen.has_links ? add_links(seen.links) : repeat_links(seen.topic);
  if (!of_topic.empty()) held[seen.topic] = std::move(of_topic);
  return seen.has_links;
}

std::vector<channel::HeldBlock> StatisticsUpdater::add_links(const std::vector<LinkStatistics>& links) {
  std::vector<channel::HeldBlock> held;
  for (const LinkStatistics& link : links) {
    statistics::ConnectionRow row = row_of(link);
    row.oldest_held_ms = held_since_.oldest_ms(link.inspection.held);
    page_->add(row);
    held.insert(held.end(), link.inspection.held.begin(), link.inspection.held.end());
  }
  return held;
}

// What was held counts as held on: its age goes on with the next look.
std::vector<channel::HeldBlock> StatisticsUpdater::repeat_links(const std::string& topic) {
  page_->repeat_connections(topic);
  const auto found = last_held_.find(topic);
  if (found == last_held_.end()) return {};
  held_since_.oldest_ms(found->second);
  return found->second;
}

bool StatisticsUpdater::write() {
  bool is_complete = true;
  Held held;
  page_->begin();
  held_since_.begin(now_ms());
  for (const std::shared_ptr<PublicationEndpoint>& endpoint : all_endpoints())
    is_complete = add(endpoint->look(), held) && is_complete;
  for (const EndpointStatistics& plain : look_at_plain()) is_complete = add(plain, held) && is_complete;
  if (const std::optional<MemoryStats> memory = stats_of_no_topic()) page_->add(row_of_no_topic(*memory));
  std::vector<SubscriptionStatistics> subscriptions;
  if (look_at_subscriptions_(subscriptions)) {
    for (const SubscriptionStatistics& subscription : subscriptions) page_->add(row_of(subscription));
  } else {
    page_->repeat_subscriptions();
    is_complete = false;
  }
  page_->publish();
  last_held_ = std::move(held);
  return is_complete;
}

}  // namespace detail
}  // namespace tzc
