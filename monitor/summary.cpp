// SPDX-License-Identifier: BSD-3-Clause
#include "summary.h"

#include <fmt/format.h>

#include <map>

#include "why.h"
#include "words.h"

namespace tzc::monitor {
namespace {

std::string counted(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

/// "2 shared, 1 TCPROS"
template <class Kind>
std::string listed(const std::map<Kind, std::size_t>& counts) {
  std::string text;
  for (const auto& [kind, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(kind));
  return text;
}

}  // namespace

std::string summary(const std::vector<Node>& nodes, const std::vector<Problem>& found) {
  std::map<Transport, std::size_t> transports;
  std::size_t connections = 0;
  for (const Node& node : nodes)
    for (const Topic& topic : node.topics)
      for (const Connection& connection : topic.connections)
        ++transports[connection.transport], ++connections;
  for (const OneSided& one : one_sided(nodes)) ++transports[one.subscription->transport], ++connections;
  std::map<ProblemKind, std::size_t> kinds;
  for (const Problem& problem : found) ++kinds[problem.kind];
  return fmt::format(
      "{}, {}{}. {}.", counted(nodes.size(), "node"), counted(connections, "connection"),
      connections > 0 ? fmt::format(" ({})", listed(transports)) : "",
      found.empty() ? "No problem" : fmt::format("{}: {}", counted(found.size(), "problem"), listed(kinds)));
}

}  // namespace tzc::monitor
