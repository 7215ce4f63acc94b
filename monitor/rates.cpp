// SPDX-License-Identifier: BSD-3-Clause
#include "rates.h"

#include <algorithm>

namespace tzc::monitor {
namespace {

template <class Value, class Same>
const Value* find_if(const std::vector<Value>& values, Same same) {
  const auto found = std::find_if(values.begin(), values.end(), same);
  return found == values.end() ? nullptr : &*found;
}

/// A topic that was advertised anew counts from 0 again.
double per_second(std::uint64_t before, std::uint64_t now, double seconds) {
  return now > before ? static_cast<double>(now - before) / seconds : 0;
}

Rates rates_of(const statistics::TopicCounters& before, const statistics::TopicCounters& now,
               double seconds) {
  return {per_second(before.messages, now.messages, seconds), per_second(before.shared, now.shared, seconds),
          per_second(before.serialized, now.serialized, seconds),
          per_second(before.copied_bytes, now.copied_bytes, seconds),
          per_second(before.exhausted, now.exhausted, seconds)};
}

std::optional<Rates> rates_between(const Node& before, const Node& now, const Topic& earlier,
                                   const Topic& topic) {
  if (now.updated_ns > before.updated_ns)
    return rates_of(earlier.counters, topic.counters,
                    static_cast<double>(now.updated_ns - before.updated_ns) * 1e-9);
  if (now.state != State::running) return Rates();
  const auto place = static_cast<std::size_t>(&earlier - before.topics.data());
  return place < before.rates.size() ? before.rates[place] : std::nullopt;
}

/// Of a count whose earlier rate is known.
std::optional<double> rate_between(const Node& before, const Node& now, std::uint64_t earlier,
                                   std::uint64_t count, std::optional<double> earlier_rate) {
  if (now.updated_ns > before.updated_ns)
    return per_second(earlier, count, static_cast<double>(now.updated_ns - before.updated_ns) * 1e-9);
  return now.state == State::running ? earlier_rate : 0;
}

std::uint64_t added(std::uint64_t before, std::uint64_t now) {
  return now > before ? now - before : 0;
}

Losses added(const Losses& before, const Losses& now) {
  return {added(before.for_queue, now.for_queue), added(before.for_memory, now.for_memory)};
}

/// A connection that moved to another transport counts from 0 again.
void add_connection_rates(const Node& before, const Node& now, const Topic& earlier, Topic& topic) {
  for (Connection& connection : topic.connections) {
    const Connection* const same = find_if(earlier.connections, [&](const Connection& other) {
      return other.subscriber == connection.subscriber && other.transport == connection.transport;
    });
    if (!same) continue;
    if (connection.transport != Transport::intraprocess)  // roscpp does not count what it hands over there
      connection.messages_per_s =
          rate_between(before, now, same->messages, connection.messages, same->messages_per_s);
    connection.shared_bytes_per_s =
        rate_between(before, now, same->shared_bytes, connection.shared_bytes, same->shared_bytes_per_s);
    connection.lost_since =
        now.updated_ns > before.updated_ns ? added(same->losses(), connection.losses()) : same->lost_since;
  }
}

Latencies added(const Latencies& before, const Latencies& now) {
  Latencies recent{};
  for (std::size_t i = 0; i < now.size(); ++i) recent[i] = added(before[i], now[i]);
  return recent;
}

void add_subscription_rates(const Node& before, Node& now) {
  for (Subscription& subscription : now.subscriptions) {
    const Subscription* const same = find_if(before.subscriptions, [&](const Subscription& other) {
      return other.topic == subscription.topic && other.publisher == subscription.publisher &&
             other.transport == subscription.transport;
    });
    if (!same) continue;
    subscription.messages_per_s =
        rate_between(before, now, same->messages, subscription.messages, same->messages_per_s);
    subscription.recent =
        now.updated_ns > before.updated_ns ? added(same->latencies, subscription.latencies) : same->recent;
  }
}

}  // namespace

void add_rates(const std::vector<Node>& before, std::vector<Node>& now) {
  for (Node& node : now) {
    node.rates.assign(node.topics.size(), std::nullopt);
    const Node* const earlier = find_if(before, [&](const Node& other) {
      return other.pid == node.pid && other.started_ns == node.started_ns;
    });
    if (earlier) add_subscription_rates(*earlier, node);
    for (std::size_t i = 0; earlier && i < node.topics.size(); ++i) {
      Topic& topic = node.topics[i];
      const Topic* const same =
          find_if(earlier->topics, [&](const Topic& other) { return other.name == topic.name; });
      if (!same) continue;
      node.rates[i] = rates_between(*earlier, node, *same, topic);
      add_connection_rates(*earlier, node, *same, topic);
    }
  }
}

}  // namespace tzc::monitor
