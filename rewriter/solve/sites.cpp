// SPDX-License-Identifier: BSD-3-Clause
#include "solve/sites.h"

#include <algorithm>
#include <cctype>

#include "report/codes.h"

namespace tzc::rewriter {
namespace {

const char* const kinds[] = {"advertise", "publish", "subscribe"};

std::string relative(const std::string& file, const std::string& dir) {
  return file.rfind(dir + "/", 0) == 0 ? file.substr(dir.size() + 1) : file;
}

template <class Fact>
Site describe(const Fact& fact, SiteKind kind, const std::string& package_dir) {
  Site site;
  site.kind = kind;
  site.where = location_of(fact.where);
  site.message_type = fact.type;
  site.id = std::string(kinds[static_cast<int>(kind)]) + ":" + relative(fact.where.file, package_dir) + ":" +
            fact.function;
  return site;
}

void refuse(Site& site, const Obstacle& obstacle, Level level) {
  site.level = level;
  site.code = obstacle.code;
  site.reason = obstacle.reason;
  if (obstacle.where.line != 0) site.chain.push_back({obstacle.where, obstacle.reason});
}

class Decider {
 public:
  Decider(const Facts& facts, const Components& components, const EngineOptions& options,
          const Demotions& demotions, Solution& solution)
      : facts_(facts),
        components_(components),
        options_(options),
        demotions_(demotions),
        solution_(solution) {}

  std::vector<Site> run() {
    neighbours_ = flow_neighbours(facts_);
    for (const auto& item : facts_.publishes) sites_.push_back(decide(item.second));
    for (const auto& item : facts_.advertises) sites_.push_back(decide(item.second));
    for (const auto& item : facts_.subscribes) sites_.push_back(decide(item.first, item.second));
    order();
    return std::move(sites_);
  }

 private:
  Site decide(const Publish& fact);
  Site decide(const Advertise& fact);
  Site decide(const std::string& id, const Subscribe& fact);
  void decide_message(const Publish& fact, Site& site);
  bool refuse_subscribe(const std::string& id, const Subscribe& fact, Site& site);
  bool advertised_as_cloud(const Key& publisher) const;
  const Solution::Publisher* publisher_of(const Key& key) const;
  void order();

  const Facts& facts_;
  const Components& components_;
  const EngineOptions& options_;
  const Demotions& demotions_;
  Solution& solution_;
  std::vector<Site> sites_;
  Neighbours neighbours_;
};

const Solution::Publisher* Decider::publisher_of(const Key& key) const {
  const Component* component = components_.of(key);
  if (!component) return nullptr;
  const auto found = solution_.publishers.find(component->id);
  return found == solution_.publishers.end() ? nullptr : &found->second;
}

void Decider::decide_message(const Publish& fact, Site& site) {
  site.level = Level::one_copy;
  if (fact.pcl) {
    // Where roscpp writes the points into its buffer, the adapter writes them into shared memory.
    site.rule = "pcl-cloud";
    if (advertised_as_cloud(fact.publisher)) site.level = Level::zero_copy;
    return;
  }
  site.rule = "stock-message";
  if (fact.twin) {
    site.level = Level::zero_copy;
    site.rule = "shared-message";
    return;
  }
  if (!fact.obstacles.empty()) return refuse(site, fact.obstacles.front(), Level::one_copy);
  bool all_zero = !fact.messages.empty();
  for (const Key& key : fact.messages) {
    const Component* component = components_.of(key);
    const auto found = component ? solution_.messages.find(component->id) : solution_.messages.end();
    if (found != solution_.messages.end() && found->second.empty) {
      site.level = Level::not_needed;
      site.rule.clear();
      return;
    }
    if (found != solution_.messages.end() && found->second.ported) continue;
    all_zero = false;
    if (found == solution_.messages.end()) continue;
    site.chain = chain_between(facts_, key, found->second.at);
    refuse(site, found->second.why_not, Level::one_copy);
  }
  if (all_zero) {
    site.level = Level::zero_copy;
    site.rule = "shared-message";
    site.component = components_.of(fact.messages[0])->id;
  } else if (site.code.empty()) {
    refuse(site, {codes::TZC1001, "where the message comes from is not understood", site.where},
           Level::one_copy);
  }
}

bool Decider::advertised_as_cloud(const Key& publisher) const {
  const Component* component = components_.of(publisher);
  return component && std::any_of(facts_.advertises.begin(), facts_.advertises.end(), [&](const auto& item) {
           return item.second.pcl && components_.of(item.second.publisher) == component;
         });
}

Site Decider::decide(const Publish& fact) {
  Site site = described(fact, SiteKind::publish, options_.package_dir);
  site.topic = topic_of(facts_, neighbours_, fact.publisher);
  if (!fact.heavy && !fact.pcl) {
    site.level = Level::not_needed;
    return site;
  }
  const Solution::Publisher* publisher = publisher_of(fact.publisher);
  if (publisher && publisher->ported) {
    if (const Component* component = components_.of(fact.publisher)) site.component = component->id;
    decide_message(fact, site);
    return site;
  }
  decide_message(fact, site);
  if (site.level == Level::not_needed) return site;
  site.rule.clear();
  site.chain.clear();
  if (!publisher && !fact.obstacles.empty()) {
    refuse(site, fact.obstacles.front(), Level::plain);
  } else if (publisher && !publisher->why_not.code.empty()) {
    site.chain = chain_between(facts_, fact.publisher, publisher->at);
    refuse(site, publisher->why_not, Level::plain);
  } else {
    refuse(site, {codes::TZC1017, "the publisher is not one of the package", site.where}, Level::plain);
  }
  return site;
}

Site Decider::decide(const Advertise& fact) {
  Site site = described(fact, SiteKind::advertise, options_.package_dir);
  const Component* component = components_.of(fact.publisher);
  const Solution::Publisher* publisher = publisher_of(fact.publisher);
  if (!fact.heavy ||
      (publisher && !publisher->ported && publisher->why_not.code.empty() && fact.obstacles.empty())) {
    site.level = Level::not_needed;
    return site;
  }
  if (!publisher || !publisher->ported) {
    if (publisher) site.chain = chain_between(facts_, fact.publisher, publisher->at);
    const Obstacle not_kept{codes::TZC1010, "the publisher is not kept", site.where};
    refuse(site,
           publisher                ? publisher->why_not
           : fact.obstacles.empty() ? not_kept
                                    : fact.obstacles.front(),
           Level::plain);
    return site;
  }
  site.rule = fact.rule;
  site.component = component->id;
  site.memory_note = memory_size(fact, options_).note;
  site.level = Level::one_copy;
  for (const Site& other : sites_)
    if (other.kind == SiteKind::publish && other.level == Level::zero_copy && other.message_type == fact.type)
      for (const auto& item : facts_.publishes)
        if (location_of(item.second.where).line == other.where.line &&
            item.second.where.file == other.where.file && components_.of(item.second.publisher) == component)
          site.level = Level::zero_copy;
  return site;
}

bool Decider::refuse_subscribe(const std::string& id, const Subscribe& fact, Site& site) {
  const auto demoted = demotions_.find("subscribe " + id);
  if (!fact.obstacles.empty()) {
    refuse(site, fact.obstacles.front(), Level::plain);
  } else if (demoted != demotions_.end()) {
    refuse(site, demoted->second, Level::plain);
  } else if (!fact.ported &&
             (options_.max_level == Level::plain || (options_.wanted && !options_.wanted(site)))) {
    refuse(site, {codes::TZC2007, "left out by --only, --except or --level", site.where}, Level::plain);
  } else if (!fact.filter.empty() && !solution_.filters.at(components_.of(fact.filter)->id).ported) {
    refuse(site, solution_.filters.at(components_.of(fact.filter)->id).why_not, Level::plain);
  }
  for (const Key& key : fact.callbacks) {
    const Component* component = components_.of(key);
    if (!component || !site.code.empty()) continue;
    for (const Entity* entity : component->entities)
      for (const Obstacle& obstacle : entity->obstacles)
        if (obstacle.code == codes::TZC2002 && site.code.empty()) refuse(site, obstacle, Level::plain);
  }
  return !site.code.empty();
}

Site Decider::decide(const std::string& id, const Subscribe& fact) {
  Site site = described(fact, SiteKind::subscribe, options_.package_dir);
  site.topic = fact.topic;
  if (!fact.heavy) {
    site.level = Level::not_needed;
    return site;
  }
  if (refuse_subscribe(id, fact, site)) return site;
  const bool writes = fact.writes || (!fact.filter.empty() &&
                                      facts_.writing_filter_scopes.count(fact.scope + " " + fact.type) != 0);
  site.level = writes ? Level::copied : Level::shared;
  solution_.subscribes.insert(id);
  site.rule = fact.rule;
  if (writes) {
    site.code = codes::TZC2001;
    site.reason = "the callback may write to the message, so it gets a copy of its own";
  }
  return site;
}

/// By place; sites of one function count up, so that an id does not depend on lines.
void Decider::order() {
  std::sort(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) {
    return std::tie(a.where.file, a.where.line, a.where.column, a.kind, a.message_type) <
           std::tie(b.where.file, b.where.line, b.where.column, b.kind, b.message_type);
  });
  std::map<std::string, int> count;
  std::map<std::string, std::set<std::pair<unsigned, unsigned>>> places;
  for (Site& site : sites_) {
    const std::string base = site.id;
    const bool another_type = !places[base].insert({site.where.line, site.where.column}).second;
    if (!another_type) ++count[base];
    site.id = base + "#" + std::to_string(count[base]) + (another_type ? "<" + site.message_type + ">" : "");
  }
}

std::optional<std::uint64_t> number_in(const std::optional<std::string>& text) {
  if (!text || text->empty() ||
      !std::all_of(text->begin(), text->end(), [](char c) { return std::isdigit(c) != 0; }))
    return {};
  return text->size() > 9 ? std::nullopt : std::optional<std::uint64_t>(std::stoull(*text));
}

}  // namespace

Site described(const Advertise& fact, SiteKind kind, const std::string& package_dir) {
  Site site = describe(fact, kind, package_dir);
  site.topic = fact.topic;
  return site;
}

Site described(const Publish& fact, SiteKind kind, const std::string& package_dir) {
  return describe(fact, kind, package_dir);
}

Site described(const Subscribe& fact, SiteKind kind, const std::string& package_dir) {
  Site site = describe(fact, kind, package_dir);
  site.topic = fact.topic;
  return site;
}

std::optional<std::string> topic_of(const Facts& facts, const Neighbours& neighbours, const Key& publisher) {
  const std::set<Key> connected = reachable(neighbours, publisher);
  std::optional<std::string> topic;
  for (const auto& item : facts.advertises) {
    if (connected.count(item.second.publisher) == 0) continue;
    if (topic || !item.second.topic) return {};
    topic = item.second.topic;
  }
  return topic;
}

MemorySize memory_size(const Advertise& fact, const EngineOptions& options) {
  if (fact.memory && *fact.memory != "0") return {*fact.memory, "set to " + *fact.memory + " in the source"};
  if (fact.memory) return {"0", "sized at run time by the first message and the queue"};
  if (options.mem_size)
    return {std::to_string(*options.mem_size),
            "set to " + std::to_string(*options.mem_size) + " bytes by --mem-size"};
  const auto measured = fact.topic ? options.measured_sizes.find(*fact.topic) : options.measured_sizes.end();
  if (measured == options.measured_sizes.end())
    return {"0", "sized at run time by the first message and the queue"};
  const std::uint64_t messages = std::max<std::uint64_t>(4, number_in(fact.queue).value_or(10) + 2);
  const std::uint64_t bytes = measured->second * messages;
  return {std::to_string(bytes), std::to_string(messages) + " messages of " +
                                     std::to_string(measured->second) +
                                     " bytes, the largest in the recording"};
}

std::vector<Site> decided_sites(const Facts& facts, const Components& components,
                                const EngineOptions& options, const Demotions& demotions,
                                Solution& solution) {
  return Decider(facts, components, options, demotions, solution).run();
}

}  // namespace tzc::rewriter
