// SPDX-License-Identifier: BSD-3-Clause
#include "why.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

std::string state_text(const Node& node, const Connection& connection) {
  std::string text;
  if (node.state != State::running)
    text += fmt::format(" ({} is {}: this is as of {:.0f} s ago.)", node.name, name(node.state), node.age_s);
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

/// What the subscriber's own page says of a publisher whose page, if it has one, does not name this connection.
std::string sentence(const Node& node, const Subscription& subscription, const std::vector<Node>& nodes) {
  std::string text =
      fmt::format("{} gets {} from {} ", node.name, subscription.topic, subscription.publisher);
  if (subscription.transport == Transport::shared) return text + "through shared memory.";
  const auto without_room = crowded(nodes);
  if (std::count(without_room.begin(), without_room.end(), subscription.publisher) > 0)
    return text +
           fmt::format(
               "over {}. Why, the statistics page of {} does not say: it had no room for all its rows.",
               name(subscription.transport), subscription.publisher);
  return text +
         fmt::format(
             "over {}: there is no statistics page of {} here. It may not use TZC, or have it switched off, "
             "be another user's, run on another machine, or be gone.",
             name(subscription.transport), subscription.publisher);
}

/// Subscriptions of `wanted` to publishers that do not say themselves what they send there.
void explain_subscriptions(const std::vector<Node>& nodes, const std::string& wanted,
                           const std::string& topic, Explanation& explanation,
                           const std::set<std::string>& publishers) {
  for (const Node& node : nodes)
    for (const Subscription& subscription : node.subscriptions)
      if (node.name == wanted && subscription.topic == topic && publishers.count(subscription.publisher) == 0)
        explanation.sentences.push_back(sentence(node, subscription, nodes));
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
  explain_subscriptions(nodes, wanted, name, explanation, publishers);
  if (!explanation.sentences.empty()) return explanation;
  explanation.nothing = publishers.empty()
                            ? nobody_publishes(nodes, name)
                            : fmt::format("{} is published by {}, which has no connection to {}.", name,
                                          fmt::join(publishers, ", "), wanted);
  return explanation;
}

}  // namespace tzc::monitor
