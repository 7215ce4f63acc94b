// SPDX-License-Identifier: BSD-3-Clause
#include "solve/solve.h"

#include <algorithm>
#include <tuple>

#include "model/codes.h"
#include "solve/binding.h"
#include "solve/flow_graph.h"
#include "solve/kept_publishers.h"
#include "solve/light_messages.h"
#include "solve/received_writes.h"
#include "solve/shared_texts.h"
#include "solve/site_index.h"
#include "solve/site_of_fact.h"
#include "solve/soundness.h"
#include "solve/started_messages.h"
#include "solve/stored_messages.h"

namespace tzc::rewriter {
namespace {

class Solver {
 public:
  Solver(const Facts& facts, const Components& components, const SolveOptions& options,
         const Demotions& demotions)
      : facts_(facts),
        components_(components),
        options_(options),
        demotions_(demotions),
        sites_(facts, components),
        flow_graph_(facts.flows),
        received_(facts),
        light_(facts, components),
        soundness_(facts, components),
        started_(facts),
        kept_(facts, components, options, solution_) {}

  Solution run() {
    decide_all(ComponentKind::publisher, &Solver::decide_publisher);
    decide_all(ComponentKind::filter, &Solver::decide_filter);
    for (const Component& component : components_.all())
      if (component.kind == ComponentKind::message && !sites_.publishes_of(component).empty())
        solution_.decisions[component.id] = decide_message(component);
    leave_idle_publishers();
    decide_all(ComponentKind::subscription, &Solver::decide_subscription);
    refuse_together(components_, solution_);
    decide_all(ComponentKind::publish_call, &Solver::decide_publish_call);
    decide_all(ComponentKind::advertise_call, &Solver::decide_advertise_call);
    return std::move(solution_);
  }

 private:
  void decide_all(ComponentKind kind, Decision (Solver::*decide)(const Component&) const);
  Decision decide_publisher(const Component& component) const;
  Decision decide_filter(const Component& component) const;
  Decision decide_message(const Component& component);
  Decision decide_subscription(const Component& component) const;
  Decision decide_publish_call(const Component& component) const;
  Decision decide_advertise_call(const Component& component) const;
  std::optional<Decision> demoted(const Component* component) const;
  void leave_idle_publishers();
  std::optional<Decision> blocked(const Component& component) const;
  std::optional<Decision> unwanted(const Component& component) const;
  std::optional<Decision> contradicted(const Component& component) const;
  static std::optional<Decision> of_several_types(const Component& component);
  std::optional<Decision> wrong_shape(const Component& component) const;
  Decision bind_allocations(const Component& component);
  bool has_data_part(const Component& publisher) const;
  bool all_publishers_known() const;
  bool all_local(const Component& component) const;
  std::optional<std::uint64_t> known_bytes(const Component& component) const;

  const Facts& facts_;
  const Components& components_;
  const SolveOptions& options_;
  const Demotions& demotions_;
  SiteIndex sites_;
  FlowGraph flow_graph_;
  ReceivedWrites received_;
  LightMessages light_;
  Soundness soundness_;
  const StartedMessages started_;
  Solution solution_;
  KeptPublishers kept_;
};

void Solver::decide_all(ComponentKind kind, Decision (Solver::*decide)(const Component&) const) {
  for (const Component& component : components_.all())
    if (component.kind == kind) solution_.decisions[component.id] = (this->*decide)(component);
}

std::optional<Decision> Solver::blocked(const Component& component) const {
  for (const Entity* entity : component.entities)
    if (!entity->obstacles.empty() && !entity->ported) return refused(entity->obstacles.front(), entity->id);
  auto decision = demoted(&component);
  if (decision) decision->at = component.entities.front()->id;
  return decision;
}

std::optional<Decision> Solver::demoted(const Component* component) const {
  if (!component) return {};
  const auto found = demotions_.find(component->id);
  return found == demotions_.end() ? std::nullopt : std::optional(refused(found->second));
}

std::optional<Decision> Solver::unwanted(const Component& component) const {
  if (!options_.wanted) return {};
  const auto left_out = [](const Site& site) {
    return refused({codes::TZC1016, "left out by --only or --except", site.where});
  };
  for (const Publish* fact : sites_.published_by(component)) {
    Site site = site_of(*fact, options_.packages);
    site.topic = topic_of(facts_, flow_graph_, fact->publisher);
    if (!options_.wanted(site)) return left_out(site);
  }
  for (const Advertise* fact : sites_.advertised(component)) {
    const Site site = site_of(*fact, options_.packages);
    if (!options_.wanted(site)) return left_out(site);
  }
  return {};
}

/// By an earlier run, or by hand.
bool is_ported_already(const Component& component) {
  return std::all_of(component.entities.begin(), component.entities.end(),
                     [](const Entity* entity) { return entity->ported; });
}

bool Solver::has_data_part(const Component& publisher) const {
  const auto& published = sites_.published_by(publisher);
  const auto& advertised = sites_.advertised(publisher);
  return std::any_of(published.begin(), published.end(),
                     [](const Publish* p) { return p->has_data_part || p->pcl; }) ||
         std::any_of(advertised.begin(), advertised.end(),
                     [](const Advertise* a) { return a->has_data_part; });
}

/// Otherwise any of them may be what is published with.
bool Solver::all_publishers_known() const {
  return std::all_of(facts_.publishes.begin(), facts_.publishes.end(),
                     [&](const auto& item) { return components_.of(item.second.publisher) != nullptr; });
}

Obstacle not_advertised(const Entity& publisher) {
  const std::string why =
      publisher.storage == Storage::parameter
          ? "nothing that the package advertises is given to the parameter '" + publisher.name + "'"
          : "no advertise call for '" + publisher.name + "' was found in the package";
  return {codes::TZC1017, why, publisher.where};
}

Decision Solver::decide_publisher(const Component& component) const {
  if (!has_data_part(component)) return {};
  if (is_ported_already(component)) return {Outcome::ported, {}, {}};
  const Entity& first = *component.entities.front();
  if (options_.max_level == Level::plain)
    return refused({codes::TZC1015, "this run leaves everything on TCPROS", first.where});
  if (auto refusal = unwanted(component)) return *refusal;
  if (auto refusal = blocked(component)) return *refusal;
  if (auto refusal = of_several_types(component)) return *refusal;
  if (sites_.advertised(component).empty()) return refused(not_advertised(first));
  if (sites_.published_by(component).empty() && all_publishers_known())
    return not_needed("nothing in the package publishes with it");
  return contradicted(component).value_or(Decision{Outcome::ported, {}, {}});
}

/// One advertise call that would need to be changed in several ways: in a template each instance has a type of its own, and
/// so may have each target that a file is compiled for.
std::optional<Decision> Solver::contradicted(const Component& component) const {
  std::map<std::tuple<std::string, unsigned, unsigned>, std::string> texts;
  for (const Advertise* site : sites_.advertised(component))
    for (const Change& change : site->changes) {
      const std::string text = change.text + site->written.stock + site->written.twin;
      const auto [known, is_new] =
          texts.emplace(std::make_tuple(change.where.file, change.where.begin, change.where.end), text);
      if (is_new || known->second == text) continue;
      return refused({codes::TZC1007,
                      site->around == Advertise::Around::template_instance
                          ? "the instances of a template advertise different types here"
                          : "the file is compiled in several ways, which advertise different types here",
                      location_of(site->where)});
    }
  return {};
}

Decision Solver::decide_filter(const Component& component) const {
  if (auto refusal = blocked(component)) return *refusal;
  return of_several_types(component).value_or(Decision{Outcome::ported, {}, {}});
}

/// Nobody knows the arrays of such a message, so that no publisher could share them.
bool is_of_unknown_type(const Publish& site) {
  return std::any_of(site.obstacles.begin(), site.obstacles.end(),
                     [](const Obstacle& why) { return why.code == codes::TZC1012; });
}

/// A publisher stays as it is where no message that it publishes gains by another one, unless others may publish with it.
void Solver::leave_idle_publishers() {
  for (const Component& publisher : components_.all()) {
    const auto& sites = sites_.published_by(publisher);
    const bool idle = !sites.empty() && std::all_of(sites.begin(), sites.end(), [&](const Publish* site) {
      return is_of_unknown_type(*site) || publishes_light_message(*site, components_, solution_);
    });
    const Decision* decision = solution_.of(publisher.id);
    const bool is_unknown = std::any_of(sites.begin(), sites.end(),
                                        [](const Publish* site) { return is_of_unknown_type(*site); });
    if (idle && decision && !is_left_out(*decision) && !is_given_away(publisher))
      solution_.decisions[publisher.id] =
          not_needed(is_unknown ? "nobody knows the arrays of what is published with it"
                                : "what is published with it needs no shared memory");
  }
}

/// One declaration that would have to be written in several ways.
std::optional<Decision> Solver::of_several_types(const Component& component) {
  std::map<std::pair<std::string, unsigned>, std::string> texts;
  for (const Entity* entity : component.entities)
    for (const Change& change : entity->changes) {
      const auto [known, is_new] =
          texts.emplace(std::make_pair(change.where.file, change.where.begin), change.text);
      if (is_new || known->second == change.text) continue;
      return refused(
          {codes::TZC1007,
           "its type differs between the instances of a template, or the ways in which the file is compiled",
           entity->where},
          entity->id);
    }
  return {};
}

std::optional<Decision> Solver::wrong_shape(const Component& component) const {
  const auto& sites = sites_.publishes_of(component);
  // Alone it would gain nothing by a type of its own. Beside a message whose arrays shared memory can hold, which has the type
  // of its elements and may come from the same function, it is ported with that one.
  if (std::all_of(sites.begin(), sites.end(), [](const Publish* site) { return site->nested_only; }))
    return refused(
        {codes::TZC1018, "its arrays lie inside an array of messages", location_of(sites.front()->where)});
  if (options_.max_level != Level::zero_copy)
    return refused(
        {codes::TZC1015, "this run goes no further than one_copy", location_of(sites.front()->where)});
  return {};
}

Decision Solver::decide_message(const Component& component) {
  const auto& sites = sites_.publishes_of(component);
  if (std::none_of(sites.begin(), sites.end(), [](const Publish* site) { return site->has_data_part; }))
    return {};
  if (auto refusal = blocked(component)) return *refusal;
  if (auto refusal = of_several_types(component)) return *refusal;
  const std::optional<std::uint64_t> bytes = known_bytes(component);
  const bool mentioned = light_.mentions_arrays(component);
  if (bytes && !mentioned && all_local(component))
    return not_needed("no array of it that shared memory can hold is filled");
  if (bytes && mentioned && *bytes < options_.small)
    return not_needed("its arrays hold at most " + std::to_string(*bytes) + " bytes");
  if (auto refusal = wrong_shape(component)) return *refusal;
  if (const auto danger = soundness_.danger(component)) return refused(danger->why, danger->at);
  for (const Publish* site : sites)
    if (const auto why = started_.given_away(*site)) return refused(*why);
  return bind_allocations(component);
}

bool Solver::all_local(const Component& component) const {
  return std::all_of(component.entities.begin(), component.entities.end(), [](const Entity* entity) {
    return entity->storage == Storage::local || entity->storage == Storage::static_local ||
           entity->storage == Storage::temporary;
  });
}

/// Made here and nowhere else: what is not seen to be filled is empty.
std::optional<std::uint64_t> Solver::known_bytes(const Component& component) const {
  const auto& sites = sites_.allocations(component);
  const bool filled = std::any_of(sites.begin(), sites.end(), [](const AllocationSite* site) {
    const auto* inserted = std::get_if<InsertedAllocation>(&site->how);
    return !inserted || inserted->filled;
  });
  const bool is_made_here = !sites.empty() || component.has_lasting_message();
  return is_made_here && !filled ? light_.most_bytes(component) : std::nullopt;
}

Decision Solver::bind_allocations(const Component& component) {
  Senders senders;
  for (const Publish* site : sites_.publishes_of(component)) {
    const Component* publisher = components_.of(site->publisher);
    if (publisher && solution_.ports(publisher->id))
      senders.ported.insert(publisher->id);
    else if (kept_.take_ported_message(*site) && !demoted(components_.of(site->id())))
      senders.has_kept = true;
  }
  if (senders.ported.empty() && !senders.has_kept)
    return refused({codes::TZC1009, "its publisher stays on TCPROS", component.entities.front()->where});
  Binder binder(facts_, components_, component, std::move(senders));
  if (auto refusal = binder.bind(without_stored(facts_, sites_, component))) return *refusal;
  solution_.allocations.insert(solution_.allocations.end(), binder.allocations().begin(),
                               binder.allocations().end());
  solution_.factories.insert(solution_.factories.end(), binder.factories().begin(), binder.factories().end());
  return {Outcome::ported, {}, {}};
}

Decision Solver::decide_subscription(const Component& component) const {
  const Subscribe& site = *component.subscription;
  if (!site.has_data_part) return {};
  if (!site.asked_transport.empty()) return not_needed("it asks for " + site.asked_transport);
  if (!site.obstacles.empty()) return refused(site.obstacles.front());
  if (const auto decision = demoted(&component)) return *decision;
  const bool left_out = options_.max_level == Level::plain ||
                        (options_.wanted && !options_.wanted(site_of(site, options_.packages)));
  if (!site.ported && left_out)
    return refused({codes::TZC2007, "left out by --only, --except or --level", location_of(site.where)});
  // A filter that keeps its class needs a call that attaches shared memory, or has one by an earlier run.
  if (!site.filter.empty() && !site.ported && site.changes_if_kept.empty()) {
    const Decision& filter = solution_.decisions.at(components_.of(site.filter)->id);
    if (filter.outcome == Outcome::refused) return refused(filter.why_not);
  }
  // A message that may be resized has to be the callback's own.
  if (const auto write = received_.to_message(site)) return refused(*write);
  if (const auto write = received_.to_message_of_another(site)) return refused(*write);
  return {Outcome::ported, {}, {}};
}

Decision Solver::decide_publish_call(const Component& component) const {
  const Decision decision = kept_.decide_publish_call(component);
  return decision.outcome == Outcome::ported ? demoted(&component).value_or(decision) : decision;
}

Decision Solver::decide_advertise_call(const Component& component) const {
  const Decision decision = kept_.decide_advertise_call(component);
  return decision.outcome == Outcome::ported ? demoted(&component).value_or(decision) : decision;
}

}  // namespace

Solution solve(const Facts& facts, const Components& components, const SolveOptions& options,
               const Demotions& demotions) {
  return Solver(facts, components, options, demotions).run();
}

}  // namespace tzc::rewriter
