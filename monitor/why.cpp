// SPDX-License-Identifier: BSD-3-Clause
#include "why.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "filter.h"
#include "words.h"

namespace tzc::monitor {
namespace {

std::string transport_text(const Connection& connection) {
  if (connection.transport == Transport::shared) return "through shared memory.";
  std::string text = fmt::format("{}: {}",
                                 connection.transport == Transport::intraprocess
                                     ? "without any transport"
                                     : fmt::format("over {}", name(connection.transport)),
                                 named_reason(connection));
  const std::string remedy = advice(connection.reason);
  return remedy.empty() ? text : text + " " + remedy;
}

std::string age_text(const Node& node) {
  if (node.state == State::running) return "";
  return fmt::format(" ({} is {}: this is as of {:.0f} s ago.)", node.name, name(node.state), node.age_s);
}

std::string state_text(const Node& node, const Connection& connection) {
  std::string text = age_text(node);
  if (connection.is_stopped) text += fmt::format(" ({} is stopped.)", connection.subscriber);
  return text;
}

std::string sentence(const Node& node, const Topic& topic, const Connection& connection) {
  return fmt::format("{} sends {} to {} {}{}", node.name, topic.name, connection.subscriber,
                     transport_text(connection), state_text(node, connection));
}

void explain_topic(const Node& node, const Topic& topic, const std::string& wanted,
                   Explanation& explanation) {
  for (const Connection& connection : topic.connections)
    if (node.name == wanted || connection.subscriber == wanted)
      explanation.sentences.push_back(sentence(node, topic, connection));
  if (node.name == wanted && topic.connections.empty())
    explanation.sentences.push_back(
        fmt::format("{} publishes {} and has no subscriber.", node.name, topic.name));
}

/// Processes whose statistics page had no room for all their rows: what it does not say of them, nobody knows.
std::vector<std::string> crowded(const std::vector<Node>& nodes) {
  std::vector<std::string> names;
  for (const Node& node : nodes)
    if (node.left_out > 0) names.push_back(node.name);
  return names;
}

/// Why a publisher whose page, if it has one, does not have the topic sends it over TCPROS.
std::string why_one_sided(const Subscription& subscription, const std::vector<Node>& nodes) {
  const std::string& publisher = subscription.publisher;
  const auto without_room = crowded(nodes);
  if (std::count(without_room.begin(), without_room.end(), publisher) > 0)
    return fmt::format(". Why, the statistics page of {} does not say: it had no room for all its rows.",
                       publisher);
  const auto page =
      std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.name == publisher; });
  if (page == nodes.end())
    return fmt::format(
        ": there is no statistics page of {} here. It may not use TZC, or have it switched off, be another "
        "user's, run on another machine, or be gone.",
        publisher);
  return fmt::format(
      ": {} uses TZC and has not attached {}. It advertises it by nh.advertise: port that place "
      "(tzc-rewrite's report names it), or give what it returns to tzc::attached there.{}",
      publisher, subscription.topic, age_text(*page));
}

/// Subscriptions of `wanted` to publishers that do not say themselves what they send there.
void explain_subscriptions(const std::vector<Node>& nodes, const std::string& wanted,
                           const std::string& topic, Explanation& explanation) {
  for (const OneSided& one : one_sided(nodes))
    if (one.node->name == wanted && one.subscription->topic == topic)
      explanation.sentences.push_back(sentence_of(one, nodes));
}

std::string nobody_publishes(const std::vector<Node>& nodes, const std::string& topic) {
  std::string text = fmt::format(
      "No process of this user publishes {} with TZC and a statistics page. Its publisher may "
      "not use TZC, may have switched it off for this topic or node (rosparam get NODE/tzc, "
      "TZC_DISABLE), may have had no subscriber yet, may be another user's, or may run on another "
      "machine; then its connections are on TCPROS.",
      topic);
  if (const auto names = crowded(nodes); !names.empty())
    text += fmt::format(" Or it is {}, whose statistics page had no room for all its rows.",
                        fmt::join(names, " or "));
  return text;
}

}  // namespace

std::vector<OneSided> one_sided(const std::vector<Node>& nodes) {
  std::set<std::pair<std::string, std::string>> told;  // topic and publisher
  for (const Node& node : nodes)
    for (const Topic& topic : node.topics) told.emplace(topic.name, node.name);
  std::vector<OneSided> found;
  for (const Node& node : nodes)
    for (const Subscription& one : node.subscriptions)
      if (told.count({one.topic, one.publisher}) == 0) found.push_back({&node, &one});
  return found;
}

std::string sentence_of(const OneSided& one, const std::vector<Node>& nodes) {
  const Subscription& subscription = *one.subscription;
  const std::string text =
      fmt::format("{} gets {} from {} ", one.node->name, subscription.topic, subscription.publisher);
  if (subscription.transport == Transport::shared) return text + "through shared memory.";
  return text + fmt::format("over {}{}", name(subscription.transport), why_one_sided(subscription, nodes));
}

Explanation explain(const std::vector<Node>& nodes, const std::string& node, const std::string& topic) {
  const std::string wanted = global_name(node), name = global_name(topic);
  Explanation explanation;
  std::set<std::string> publishers;
  for (const Node& one : nodes) {
    for (const Topic& published : one.topics) {
      if (published.name != name) continue;
      publishers.insert(one.name);
      explain_topic(one, published, wanted, explanation);
    }
  }
  explain_subscriptions(nodes, wanted, name, explanation);
  if (!explanation.sentences.empty()) return explanation;
  explanation.nothing = publishers.empty()
                            ? nobody_publishes(nodes, name)
                            : fmt::format("{} is published by {}, which has no connection to {}.", name,
                                          fmt::join(publishers, ", "), wanted);
  return explanation;
}

}  // namespace tzc::monitor
