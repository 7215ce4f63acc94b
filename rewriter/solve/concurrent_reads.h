// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/facts.h"
#include "solve/components.h"
#include "solve/running_code.h"

namespace tzc::rewriter {

/// Whether one thread may go through the elements of a message while another one publishes it, or reads them, too, without a lock because
/// neither writes. That is right for a std::vector. A tzc::Array that was published moves its elements at the next access that is not
/// const, reading or not, so that thread could find the begin of the one memory and the end of the other. One element that is read at
/// once is safe from that, but not from a second thread that moves the elements once more, after the next publish: the first memory is given
/// back then.
class ConcurrentReads {
 public:
  ConcurrentReads(const Facts& facts, const Components& components);

  /// Such a use of a message of the component. Null: none.
  const ElementUse* of(const Component& component) const;

 private:
  using Spot = RunningCode::Spot;
  struct Access {
    const ElementUse* use;
    Spot spot;
  };
  struct Accesses {
    std::vector<Spot> publishes;
    std::vector<Access> reads, writes;
  };

  bool is_in(const EntityId& message, const Component& component) const;
  bool is_within_reach(const Component& component) const;
  bool is_captured(const Component& component) const;
  bool guards(const std::string& lock, const Component& component) const;
  bool is_part_of(const std::string& field, const std::string& record) const;
  Spot spot(const std::string& code, const std::set<std::string>& locks, const Component& component) const;
  Accesses accesses_of(const Component& component) const;
  bool is_kept_from(const Accesses& all, const Spot& one, const Spot& other, bool whole) const;
  bool meets_publish(const Accesses& all, const Spot& read) const;
  bool meets_read(const Accesses& all, const Spot& one, const Spot& other) const;
  bool meets_write(const Spot& read, const Access& write) const;
  bool is_moved(const Accesses& all, const Access& read) const;
  bool is_endangered(const Accesses& all, const Access& read) const;

  const Facts& facts_;
  const Components& components_;
  RunningCode running_;
};

}  // namespace tzc::rewriter
