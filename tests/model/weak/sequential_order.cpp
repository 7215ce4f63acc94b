// SPDX-License-Identifier: BSD-3-Clause
// The axiom SC of RC11, for the events and fences that are seq_cst:
//
//   scb      = sb | sb!=loc; hb; sb!=loc | hb|loc | mo | fr
//   psc_base = ([E_sc] | [F_sc]; hb?); scb; ([E_sc] | hb?; [F_sc])
//   psc_F    = [F_sc]; (hb | hb; eco; hb); [F_sc]
//   acyclic(psc_base | psc_F)
#include <algorithm>

#include "weak/execution.h"

namespace tzc {
namespace model {
namespace weak {
namespace {

using Events = std::vector<Event>;
using Writes = std::vector<std::vector<std::size_t>>;

/// row(a)[b]: a is related to b.
class Relation {
 public:
  explicit Relation(std::size_t size) : rows_(size) {}
  EventSet& row(std::size_t from) { return rows_[from]; }
  const EventSet& row(std::size_t from) const { return rows_[from]; }

  Relation& operator|=(const Relation& other) {
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] |= other.rows_[i];
    return *this;
  }
  /// First this, then the other.
  Relation then(const Relation& other) const {
    Relation result(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t k = rows_[i]._Find_first(); k < rows_.size(); k = rows_[i]._Find_next(k))
        result.rows_[i] |= other.rows_[k];
    }
    return result;
  }
  bool is_acyclic() const {
    Relation closure = *this;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      for (EventSet& row : closure.rows_) {
        if (row[k]) row |= closure.rows_[k];
      }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (closure.rows_[i][i]) return false;
    }
    return true;
  }

 private:
  std::vector<EventSet> rows_;
};

bool same_location(const Event& a, const Event& b) {
  return a.kind != Event::fence && b.kind != Event::fence && a.location == b.location;
}

template <class Holds>
Relation related(const Events& events, Holds holds) {
  Relation result(events.size());
  for (std::size_t b = 0; b < events.size(); ++b) {
    for (std::size_t a = 0; a < events.size(); ++a) {
      if (a != b && holds(a, b)) result.row(a).set(b);
    }
  }
  return result;
}

/// mo and fr: what comes later in a location's order than the event itself, or than what it reads.
Relation later_writes(const Events& events, const Writes& writes) {
  Relation result(events.size());
  for (const auto& order : writes) {
    EventSet later;
    for (std::size_t i = order.size(); i-- > 0;) {
      result.row(order[i]) |= later;
      for (std::size_t read = 0; read < events.size(); ++read) {
        if (events[read].reads() && events[read].source == order[i]) result.row(read) |= later;
      }
      later.set(order[i]);
    }
  }
  for (std::size_t i = 0; i < events.size(); ++i) result.row(i).reset(i);  // an update is not before itself
  return result;
}

Relation identity(const Events& events, bool fences_alone) {
  Relation result(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool fence = events[i].kind == Event::fence;
    if (is_sequential(events[i].order) && fence == fences_alone) result.row(i).set(i);
  }
  return result;
}

Relation reads_from(const Events& events) {
  return related(events,
                 [&](std::size_t a, std::size_t b) { return events[b].reads() && events[b].source == a; });
}

Relation sequential_before(const Events& events, const Relation& happens_before, const Relation& later) {
  const auto program_order = [&](std::size_t a, std::size_t b) {
    return events[a].thread == events[b].thread && events[a].index < events[b].index;
  };
  const Relation elsewhere = related(events, [&](std::size_t a, std::size_t b) {
    return program_order(a, b) && !same_location(events[a], events[b]);
  });
  Relation result = related(events, program_order);
  result |= elsewhere.then(happens_before).then(elsewhere);
  result |= related(events, [&](std::size_t a, std::size_t b) {
    return events[b].before[a] && same_location(events[a], events[b]);
  });
  result |= later;
  return result;
}

bool needs_no_order(const Events& events) {
  const auto sequential = [](const Event& event) { return is_sequential(event.order); };
  return std::count_if(events.begin(), events.end(), sequential) < 2;
}

}  // namespace

bool has_sequential_order(const Events& events, const Writes& writes) {
  if (needs_no_order(events)) return true;
  const Relation happens_before =
      related(events, [&](std::size_t a, std::size_t b) { return events[b].before[a]; });
  const Relation later = later_writes(events, writes), read = reads_from(events);
  const Relation accesses = identity(events, false), fences = identity(events, true);
  Relation from = accesses, to = accesses;
  from |= fences;
  from |= fences.then(happens_before);
  to |= fences;
  to |= happens_before.then(fences);
  Relation psc = from.then(sequential_before(events, happens_before, later)).then(to);
  Relation communication = later;
  communication |= read;
  communication |= later.then(read);
  Relation between_fences = happens_before;
  between_fences |= happens_before.then(communication).then(happens_before);
  psc |= fences.then(between_fences).then(fences);
  return psc.is_acyclic();
}

}  // namespace weak
}  // namespace model
}  // namespace tzc
