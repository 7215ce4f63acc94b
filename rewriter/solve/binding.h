// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solve/solution.h"

namespace tzc::rewriter {

/// Finds, for each birth of a message component, a publisher that can be named there.
class Binder {
 public:
  /// publishers: components that publish the message and are ported.
  Binder(const Facts& facts, const Components& components, const Component& component,
         std::set<int> publishers)
      : facts_(facts), components_(components), component_(component), publishers_(std::move(publishers)) {}

  /// False: one of them has none, and `message` says which.
  bool bind(const std::vector<const Birth*>& births, Solution::Message& message);

  const std::vector<Solution::Bound>& births() const { return births_; }
  /// Functions that are given the publisher, because the message is born in them.
  const std::vector<Solution::GivenPublisher>& helpers() const { return helpers_; }

 private:
  bool bind(const Birth& birth, Solution::Message& message);
  bool give_publishers(Solution::Message& message);
  bool is_helper(const Birth& birth) const;
  int closeness(const PublisherName& name, const Birth& birth) const;
  std::optional<Solution::Bound> named_at(const Birth& birth) const;
  bool visible(const Birth& birth, const Entity& publisher) const;
  bool inherits(const std::string& record, const std::string& base) const;

  const Facts& facts_;
  const Components& components_;
  const Component& component_;
  std::set<int> publishers_;
  std::set<std::string> given_;
  std::vector<Solution::Bound> births_;
  std::vector<Solution::GivenPublisher> helpers_;
};

}  // namespace tzc::rewriter
