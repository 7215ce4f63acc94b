// SPDX-License-Identifier: BSD-3-Clause
#include "solve/describe_sites.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "model/codes.h"
#include "solve/attached_topics.h"
#include "solve/copied_elements.h"
#include "solve/flow_graph.h"
#include "solve/memory_size.h"
#include "solve/received_writes.h"
#include "solve/site_of_fact.h"
#include "solve/unbound_messages.h"

namespace tzc::rewriter {
namespace {

void refuse(Site& site, const Obstacle& obstacle, Level level) {
  site.level = level;
  site.code = obstacle.code;
  site.reason = obstacle.reason;
  site.in_exported_header = obstacle.in_exported_header;
  if (obstacle.where.line != 0) site.flow_path.push_back({obstacle.where, obstacle.reason});
}

/// A message without large arrays, or none that shared memory can hold: then it says so, since the message may be large.
Site left_alone(Site site, const SiteFact& fact) {
  site.level = Level::not_needed;
  if (fact.has_data_part) return site;
  if (fact.most_bytes && *fact.most_bytes > 0)
    site.reason = "its arrays are light by their type";
  else if (fact.has_varied_elements)
    site.reason = "the elements of its arrays have strings or arrays of their own, and stay in the message";
  return site;
}

void copied(Site& site, const char* code, const std::string& reason) {
  site.level = Level::copied;
  site.code = code;
  site.reason = reason;
}

bool is(const Decision* decision, Outcome outcome) {
  return decision && decision->outcome == outcome;
}

/// Null: none. That nothing in the package advertises says nothing about the message.
const Obstacle* obstacle_of_message(const Publish& fact) {
  const auto found = std::find_if(fact.obstacles.begin(), fact.obstacles.end(),
                                  [](const Obstacle& one) { return one.code != codes::TZC1017; });
  return found == fact.obstacles.end() ? nullptr : &*found;
}

bool is_filter_of_messages(const Subscribe& fact) {
  return fact.rule == "filter-subscriber";
}

bool is_through_filter(const Subscribe& fact) {
  return is_filter_of_messages(fact) || fact.rule == "subscriber-filter";
}

/// A pcl::PointCloud or a cv_bridge::CvImage that is published as such.
void describe_object_of_library(const Publish& fact, Site& site) {
  site.rule = "library-object";
  site.reason = fact.by_serializer ? "roscpp serializes it, and its elements are copied once more from "
                                     "there; publish what toImageMsg() returns"
                                   : "its elements lie in memory of its library, and publishing copies them";
}

class SiteDescriber {
 public:
  SiteDescriber(const Facts& facts, const Components& components, const SolveOptions& options,
                const Solution& solution)
      : facts_(facts),
        components_(components),
        options_(options),
        solution_(solution),
        flow_graph_(facts.flows),
        attached_(facts, components, solution),
        received_(facts),
        copied_(facts,
                [&components, &solution](const EntityId& message) {
                  const Component* component = components.of(message);
                  return !component || solution.ports(component->id);
                }),
        unbound_(facts) {}

  std::vector<Site> run() {
    for (const auto& item : facts_.publishes) {
      sites_.push_back(describe(item.second));
      if (sites_.back().level == Level::zero_copy) published_without_copy_.push_back(&item.second);
    }
    for (const auto& item : facts_.advertises) sites_.push_back(describe(item.second));
    for (const auto& item : facts_.subscribes) sites_.push_back(describe(item.first, item.second));
    return std::move(sites_);
  }

 private:
  Site describe(const Publish& fact) const;
  Site describe(const Advertise& fact) const;
  Site describe(const SiteId& id, const Subscribe& fact) const;
  void describe_message(const Publish& fact, Site& site) const;
  void describe_origins(const Publish& fact, Site& site) const;
  void describe_kept_publisher(const Publish& fact, const Decision* publisher, Site& site) const;
  void describe_kept_publisher(const Advertise& fact, const Decision& publisher, Site& site) const;
  bool publishes_without_copy(const Advertise& fact) const;
  void describe_port(const Subscribe& fact, Site& site) const;
  bool has_own_class(const SiteId& id, const Subscribe& fact) const;
  bool shares_with_own_class(const Subscribe& fact) const;
  Obstacle why_kept(const Subscribe& fact) const;
  std::optional<std::string> why_copied(const Subscribe& fact) const;
  std::string trust_of(const Publish& fact) const;
  template <class Id>
  const Decision* decision_of(const Id& of) const;

  const Facts& facts_;
  const Components& components_;
  const SolveOptions& options_;
  const Solution& solution_;
  FlowGraph flow_graph_;
  AttachedTopics attached_;
  ReceivedWrites received_;
  CopiedElements copied_;
  UnboundMessages unbound_;
  std::vector<Site> sites_;
  std::vector<const Publish*> published_without_copy_;
};

template <class Id>
const Decision* SiteDescriber::decision_of(const Id& of) const {
  const Component* component = components_.of(of);
  return component ? solution_.of(component->id) : nullptr;
}

void SiteDescriber::describe_message(const Publish& fact, Site& site) const {
  site.level = Level::one_copy;
  if (fact.pcl) return describe_object_of_library(fact, site);
  site.rule = "stock-message";
  if (fact.twin) {
    site.level = Level::zero_copy;
    site.rule = "shared-message";
  } else if (fact.is_gathered) {
    refuse(site,
           {codes::TZC1018, "its elements have strings, and publish() gathers them in shared memory", {}},
           Level::one_copy);
  } else if (const Obstacle* why = obstacle_of_message(fact)) {
    // Nobody knows the arrays of a type that is not known.
    refuse(site, *why, why->code == codes::TZC1012 ? Level::plain : Level::one_copy);
  } else {
    describe_origins(fact, site);
  }
  if (site.level != Level::zero_copy) return;
  if (fact.nested_only)
    return refuse(site, {codes::TZC1018, "its arrays lie inside an array of messages", site.where},
                  Level::one_copy);
  std::optional<Obstacle> why = unbound_.why_copied(fact.id());
  if (!why) why = copied_.why_copied(fact.id());
  if (!why && !fact.part_of) why = copied_.why_new(fact.id());
  if (!why && fact.part_of && fact.part_of->is_given)
    why = Obstacle{
        codes::TZC1022,
        "'" + fact.part_of->name + "' may be another object each time, with content outside shared memory",
        site.where};
  if (why) refuse(site, *why, Level::one_copy);
}

/// What the level rests on besides the analysis.
std::string SiteDescriber::trust_of(const Publish& fact) const {
  for (const TrustedCall& call : facts_.trusted_calls)
    for (const EntityId& message : fact.messages)
      if (const Component* component = components_.of(message))
        if (component == components_.of(call.message))
          return "rests on .tzc-rewrite.yaml: '" + call.function + "' keeps nothing, " + call.reason;
  return "";
}

/// By the components that the published message may come from: all of them must be ported.
void SiteDescriber::describe_origins(const Publish& fact, Site& site) const {
  bool all_ported = !fact.messages.empty();
  for (const EntityId& message : fact.messages) {
    const Decision* decision = decision_of(message);
    if (is(decision, Outcome::not_needed)) {
      site.level = Level::not_needed;
      site.reason = decision->why_not.reason;
      site.rule.clear();
      return;
    }
    if (is(decision, Outcome::ported)) continue;
    all_ported = false;
    if (!decision) continue;
    site.flow_path = flow_graph_.path(message, decision->at);
    refuse(site, decision->why_not, Level::one_copy);
  }
  if (all_ported) {
    site.level = Level::zero_copy;
    site.rule = "shared-message";
    site.reason = trust_of(fact);
  } else if (site.code.empty()) {
    refuse(site, {codes::TZC1001, "where the message comes from is not understood", site.where},
           Level::one_copy);
  }
}

Site SiteDescriber::describe(const Publish& fact) const {
  Site site = site_of(fact, options_.packages);
  site.topic = topic_of(facts_, flow_graph_, fact.publisher);
  if (!fact.has_data_part && !fact.pcl) return left_alone(std::move(site), fact);
  const Decision* publisher = decision_of(fact.publisher);
  describe_message(fact, site);
  if (is(publisher, Outcome::ported) || site.level == Level::not_needed) return site;
  if (attached_.attaches(fact)) {
    site.rule = "attached-publish";
    return site;
  }
  describe_kept_publisher(fact, publisher, site);
  return site;
}

/// What a message goes out with that is no publisher of TZC's, nor becomes one.
void SiteDescriber::describe_kept_publisher(const Publish& fact, const Decision* publisher,
                                            Site& site) const {
  const bool attached = attached_.reach(fact.publisher) || attached_.reach_class(fact.library_class);
  // Otherwise the publisher is why the message stays what it is.
  if (attached && site.code != codes::TZC1009 && site.level == Level::one_copy &&
      is(publisher, Outcome::refused)) {
    site.rule = "attached-advertise";
    return;
  }
  site.rule = attached ? "attached-advertise" : "";
  site.flow_path.clear();
  const Level level = attached ? Level::one_copy : Level::plain;
  if ((!publisher || is(publisher, Outcome::not_needed)) && !fact.obstacles.empty()) {
    refuse(site, fact.obstacles.front(), level);
  } else if (is(publisher, Outcome::refused)) {
    site.flow_path = flow_graph_.path(fact.publisher, publisher->at);
    refuse(site, publisher->why_not, level);
  } else {
    refuse(site, {codes::TZC1017, "the publisher is not one of the package", site.where}, level);
  }
  if ((attached || site.code == codes::TZC1017) && !fact.attaching.why_not.empty())
    site.reason += ", and " + fact.attaching.why_not;
}

void SiteDescriber::describe_kept_publisher(const Advertise& fact, const Decision& publisher,
                                            Site& site) const {
  const bool by_call = attached_.is_attached(fact);
  const bool attached = by_call || attached_.is_attached_by_calls(fact.publisher);
  if (attached) site.rule = by_call ? "attached-advertise" : "attached-publish";
  site.level = !attached ? Level::plain : publishes_without_copy(fact) ? Level::zero_copy : Level::one_copy;
  if (site.level == Level::zero_copy) return;
  site.flow_path = flow_graph_.path(fact.publisher, publisher.at);
  refuse(site, publisher.why_not, site.level);
}

bool SiteDescriber::publishes_without_copy(const Advertise& fact) const {
  return std::any_of(published_without_copy_.begin(), published_without_copy_.end(), [&](const Publish* p) {
    return p->type == fact.type && components_.of(p->publisher) == components_.of(fact.publisher);
  });
}

Site SiteDescriber::describe(const Advertise& fact) const {
  Site site = site_of(fact, options_.packages);
  const Decision* publisher = decision_of(fact.publisher);
  if (!fact.has_data_part) return left_alone(std::move(site), fact);
  if (is(publisher, Outcome::not_needed)) {
    site.level = Level::not_needed;
    site.reason = publisher->why_not.reason;
  } else if (is(publisher, Outcome::ported)) {
    site.rule = fact.rule;
    site.memory_note = memory_size(fact, options_).note;
    site.level = publishes_without_copy(fact) ? Level::zero_copy : Level::one_copy;
  } else if (publisher && fact.around == Advertise::Around::function_for_callers) {
    site.level = Level::not_needed;
    site.reason = "who calls this function attaches shared memory to what it returns";
  } else if (publisher) {
    describe_kept_publisher(fact, *publisher, site);
  } else if (!fact.library_class.empty() && attached_.is_attached(fact)) {
    site.rule = "attached-advertise";
    refuse(site, fact.obstacles.front(), Level::one_copy);
  } else {
    const Obstacle not_kept{codes::TZC1010, "the publisher is not kept", site.where};
    refuse(site, fact.obstacles.empty() ? not_kept : fact.obstacles.front(), Level::plain);
  }
  return site;
}

/// Why a subscription's callbacks do not read the very bytes that were published; none: they do.
std::optional<std::string> SiteDescriber::why_copied(const Subscribe& fact) const {
  if (received_.takes_own(fact)) return "the callback may write to the message, so it gets a copy of its own";
  if (received_.shares_with_one_that_takes_own(fact))
    return "another callback of the topic takes the message as its own, so all of them get copies";
  if (shares_with_own_class(fact))
    return "an unported filter of the topic may pass the message to a writer, so all callbacks get copies";
  if (received_.is_unknown(fact))
    return "the callback is not known here, and pages that it writes to are copied";
  if (const auto write = received_.to_elements(fact))
    return write->reason + ": pages that it writes to are copied";
  return {};
}

Site SiteDescriber::describe(const SiteId& id, const Subscribe& fact) const {
  Site site = site_of(fact, options_.packages);
  const Decision& decision = *solution_.of(components_.of(id)->id);
  if (decision.outcome == Outcome::not_needed) {
    site = left_alone(std::move(site), fact);
    if (!decision.why_not.reason.empty()) site.reason = decision.why_not.reason;
  } else if (decision.outcome == Outcome::refused) {
    refuse(site, decision.why_not, Level::plain);
  } else {
    describe_port(fact, site);
  }
  return site;
}

void SiteDescriber::describe_port(const Subscribe& fact, Site& site) const {
  const bool is_kept = is_through_filter(fact) && !is(decision_of(fact.filter), Outcome::ported);
  site.rule = is_kept ? "kept-filter" : fact.rule;
  site.level = Level::shared;
  if (fact.is_gathered) {
    copied(site, codes::TZC2010, "its elements have strings, so the message is made from the shared bytes");
  } else if (fact.converts) {
    copied(site, codes::TZC2010, "the callback takes a cloud of PCL, which is made from the shared bytes");
  } else if (is_kept && is_filter_of_messages(fact)) {
    const Obstacle why = why_kept(fact);
    refuse(site, why, Level::copied);
    site.reason += ", and message_filters' own class gets a copy, since it may pass it on to a writer";
  } else if (const std::optional<std::string> why = why_copied(fact)) {
    copied(site, codes::TZC2001, *why);
  }
}

/// Why a filter does not get TZC's class.
Obstacle SiteDescriber::why_kept(const Subscribe& fact) const {
  const Decision* filter = decision_of(fact.filter);
  if (is(filter, Outcome::refused)) return filter->why_not;
  return {codes::TZC2009, "what holds the filter cannot be given another type", location_of(fact.where)};
}

/// Whether the filter is a message_filters::Subscriber after the port.
bool SiteDescriber::has_own_class(const SiteId& id, const Subscribe& fact) const {
  if (!is_filter_of_messages(fact)) return false;
  const Component* filter = components_.of(fact.filter);
  if (!filter || !solution_.ports(filter->id)) return true;
  const bool is_ported_already = filter->entities.front()->ported;
  return !is_ported_already && !is(decision_of(id), Outcome::ported);
}

/// All callbacks that a process has for a topic get one message.
bool SiteDescriber::shares_with_own_class(const Subscribe& fact) const {
  return std::any_of(facts_.subscribes.begin(), facts_.subscribes.end(), [&](const auto& item) {
    const Subscribe& other = item.second;
    return other.type == fact.type && fact.topic && other.topic == fact.topic &&
           facts_.share_a_process(fact.where.file, other.where.file) && has_own_class(item.first, other);
  });
}

void sort_by_place(std::vector<Site>& sites) {
  std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) {
    return std::tie(a.where.file, a.where.line, a.where.column, a.kind, a.message_type) <
           std::tie(b.where.file, b.where.line, b.where.column, b.kind, b.message_type);
  });
}

/// The sites of one function count up, so that an id does not depend on lines; those of another package do not count.
void number_sites(std::vector<Site>& sites) {
  struct Seen {
    int count = 0;
    std::map<std::pair<unsigned, unsigned>, std::set<std::string>> types;  ///< by line and column
  };
  std::map<std::pair<std::string, std::string>, Seen> known;
  for (Site& site : sites) {
    Seen& seen = known[{site.where.file, site.id}];
    std::set<std::string>& types = seen.types[{site.where.line, site.where.column}];
    // A macro may make several calls of one type there.
    const bool another_type = !types.empty() && types.count(site.message_type) == 0;
    types.insert(site.message_type);
    if (!another_type) ++seen.count;
    site.id += "#" + std::to_string(seen.count) + (another_type ? "<" + site.message_type + ">" : "");
  }
}

}  // namespace

std::vector<Site> describe_sites(const Facts& facts, const Components& components,
                                 const SolveOptions& options, const Solution& solution) {
  std::vector<Site> sites = SiteDescriber(facts, components, options, solution).run();
  sort_by_place(sites);
  number_sites(sites);
  return sites;
}

}  // namespace tzc::rewriter
