// SPDX-License-Identifier: BSD-3-Clause
#include "solve/site_of_fact.h"

namespace tzc::rewriter {
namespace {

const char* const kinds[] = {"advertise", "publish", "subscribe"};

Site site_of(const SiteFact& fact, SiteKind kind, const FolderSet& packages) {
  Site site;
  site.kind = kind;
  site.where = location_of(fact.where);
  site.message_type = fact.type;
  site.in_macros = fact.in_macros;
  site.id = std::string(kinds[static_cast<int>(kind)]) + ":" + packages.relative(fact.where.file) + ":" +
            fact.function;
  return site;
}

}  // namespace

Site site_of(const Advertise& fact, const FolderSet& packages) {
  Site site = site_of(fact, SiteKind::advertise, packages);
  site.topic = fact.topic;
  return site;
}

Site site_of(const Publish& fact, const FolderSet& packages) {
  return site_of(fact, SiteKind::publish, packages);
}

Site site_of(const Subscribe& fact, const FolderSet& packages) {
  Site site = site_of(fact, SiteKind::subscribe, packages);
  site.topic = fact.topic;
  return site;
}

std::optional<std::string> topic_of(const Facts& facts, const FlowGraph& graph, const EntityId& publisher) {
  const std::set<EntityId> connected = graph.reachable(publisher);
  std::optional<std::string> topic;
  for (const auto& item : facts.advertises) {
    if (connected.count(item.second.publisher) == 0) continue;
    if (topic || !item.second.topic) return {};
    topic = item.second.topic;
  }
  return topic;
}

}  // namespace tzc::rewriter
