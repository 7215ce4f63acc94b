// SPDX-License-Identifier: BSD-3-Clause
#include "weak/weakenings.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <tuple>

namespace tzc {
namespace model {
namespace weak {
namespace {

using Order = std::memory_order;

/// One memory order in the code: what a thread does to a location.
struct Site {
  std::size_t thread;
  std::size_t location;
  Operation::Kind kind;
  bool on_failure;  // of a compare_exchange
  Order order;

  bool operator<(const Site& other) const {
    return std::tie(thread, location, kind, on_failure, order) <
           std::tie(other.thread, other.location, other.kind, other.on_failure, other.order);
  }
};

const char* name_of(Order order) {
  switch (order) {
    case std::memory_order_seq_cst:
      return "seq_cst";
    case std::memory_order_acq_rel:
      return "acq_rel";
    case std::memory_order_acquire:
      return "acquire";
    case std::memory_order_release:
      return "release";
    default:
      return "relaxed";
  }
}

const char* name_of(Operation::Kind kind) {
  constexpr const char* names[] = {"load",     "await", "store", "compare_exchange", "fetch_add", "fetch_or",
                                   "exchange", "lock",  "fence"};
  return names[kind];
}

bool only_reads(const Site& site) {
  return site.kind == Operation::load || site.kind == Operation::await || site.on_failure;
}

/// The next weaker orders.
std::vector<Order> weaker(const Site& site) {
  const bool writes_only = site.kind == Operation::store;
  switch (site.order) {
    case std::memory_order_seq_cst:
      if (only_reads(site)) return {std::memory_order_acquire};
      return {writes_only ? std::memory_order_release : std::memory_order_acq_rel};
    case std::memory_order_acq_rel:
      return {std::memory_order_acquire, std::memory_order_release};
    case std::memory_order_acquire:
    case std::memory_order_release:
      return {std::memory_order_relaxed};
    default:
      return {};
  }
}

Order& order_at(const Site& site, Operation& operation) {
  return site.on_failure ? operation.failure_order : operation.order;
}

std::vector<Site> sites_of(std::size_t thread, const Operation& operation) {
  if (!operation.atomic || operation.kind == Operation::fence) return {};
  std::vector<Site> sites{{thread, operation.location, operation.kind, false, operation.order}};
  if (operation.kind == Operation::compare_exchange)
    sites.push_back({thread, operation.location, operation.kind, true, operation.failure_order});
  return sites;
}

class Weakenings {
 public:
  Weakenings(const std::vector<Scenario>& scenarios, const Names& names)
      : scenarios_(scenarios), names_(names) {}

  int hold() {
    int failures = 0;
    for (const Scenario& scenario : scenarios_) {
      Explorer explorer = scenario.explorer();
      explorer.on_operation = [this](std::size_t thread, const Operation& operation) {
        for (const Site& site : sites_of(thread, operation)) sites_.insert(site);
      };
      const bool held = explorer.explore();
      std::printf("%-32s %9zu states %9zu executions  %s\n", scenario.name.c_str(), explorer.states(),
                  explorer.executions(), held ? "holds" : explorer.violation().c_str());
      std::fflush(stdout);
      failures += held ? 0 : 1;
    }
    return failures;
  }

  int plant(const std::vector<Spare>& spares) const {
    int failures = 0;
    std::set<std::string> unused;
    for (const Spare& spare : spares) unused.insert(spare.weakening);
    for (const Site& site : sites_) {
      if (site.location >= names_.locations.size()) continue;  // of the system, not of the code under test
      for (const Order order : weaker(site)) failures += plant(site, order, unused) ? 0 : 1;
    }
    for (const std::string& weakening : unused)
      std::printf("listed as spare, but not there: %s\n", weakening.c_str());
    return failures + static_cast<int>(unused.size());
  }

 private:
  bool plant(const Site& site, Order order, std::set<std::string>& unused) const {
    const std::string name = describe(site, order), found = first_to_notice(site, order);
    const bool spare = unused.erase(name) != 0;
    const std::string verdict = found.empty() ? (spare ? "spare" : "NOT FOUND") : "found: " + found;
    std::printf("weakened: %s: %s%s\n", name.c_str(), verdict.c_str(),
                spare && !found.empty() ? ", ALTHOUGH LISTED AS SPARE" : "");
    std::fflush(stdout);
    return spare == found.empty();
  }

  std::string describe(const Site& site, Order order) const {
    return names_.threads[site.thread] + ", " + names_.locations[site.location] + ", " + name_of(site.kind) +
           (site.on_failure ? " that fails, " : ", ") + name_of(site.order) + " to " + name_of(order);
  }

  // What goes wrong is sought first; a program that is out of the explorer's scope is no proof that something does.
  std::string first_to_notice(const Site& site, Order order) const {
    const std::string wrong = first_to_notice(site, order, Scope::everything);
    return wrong.empty() ? first_to_notice(site, order, Scope::without_load_buffering) : wrong;
  }

  std::string first_to_notice(const Site& site, Order order, Scope scope) const {
    for (const Scenario& scenario : scenarios_) {
      Explorer explorer = scenario.explorer();
      explorer.scope = scope;
      explorer.on_operation = [&site, order](std::size_t thread, Operation& operation) {
        for (const Site& each : sites_of(thread, operation)) {
          if (!(each < site) && !(site < each)) order_at(site, operation) = order;
        }
      };
      if (!explorer.explore()) return explorer.violation() + " (" + scenario.name + ")";
    }
    return "";
  }

  const std::vector<Scenario>& scenarios_;
  const Names& names_;
  std::set<Site> sites_;
};

}  // namespace

int explore_with_weakenings(const std::vector<Scenario>& scenarios, const Names& names,
                            const std::vector<Spare>& spares) {
  Weakenings weakenings(scenarios, names);
  if (const int failures = weakenings.hold()) return failures;
  return weakenings.plant(spares);
}

}  // namespace weak
}  // namespace model
}  // namespace tzc
