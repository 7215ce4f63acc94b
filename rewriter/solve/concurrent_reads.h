// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/facts.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// Whether one thread may go through the elements of a message while another one publishes it, without a lock because neither writes.
/// That is right for a std::vector. A tzc::Array that was published moves its elements at the next access that is not const, reading or
/// not, so that thread could find the begin of the one memory and the end of the other. One element that is read at once is safe from that,
/// but not from a second thread that moves the elements twice meanwhile: the first memory is given back then.
class ConcurrentReads {
 public:
  ConcurrentReads(const Facts& facts, const Components& components);

  /// Such a use of a message of the component, in code that writes none of its elements: what writes has the message for itself. Null: none.
  const ElementUse* of(const Component& component);

 private:
  using Functions = std::set<std::string>;
  struct Publishers {
    Functions roots;
    bool exclude = true;  ///< each of them takes a lock
  };
  struct Reader {
    const ElementUse* use;
    Functions roots;
  };

  bool is_in(const EntityId& message, const Component& component) const;
  Publishers publishers_of(const Component& component);
  bool is_captured(const Component& component) const;
  bool is_run_by_one(const std::string& root) const;
  bool may_meet(const Functions& roots, const Functions& others) const;
  std::vector<Reader> readers_of(const Component& component, const Publishers& publishers) const;
  Functions callers_of(const std::string& function) const;
  Functions roots_among(const Functions& functions) const;
  bool excludes_others(const Functions& functions) const;

  const Facts& facts_;
  const Components& components_;
  std::map<std::string, Functions> callers_;
};

}  // namespace tzc::rewriter
