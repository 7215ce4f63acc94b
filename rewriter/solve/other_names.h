// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/facts.h"

namespace tzc::rewriter {

/// "frames_[0]" of "frames_"
bool is_element_of(const MessagePart& part, const MessagePart& container);

/// Names that may denote one message: elements of a container by different indices, what pointers are given, a parameter and what its
/// function names itself. Of the whole run, in no order: a name that once led to a message may lead to it again.
class OtherNames {
 public:
  explicit OtherNames(const Facts& facts);

  /// What else the part may be called.
  std::vector<MessagePart> of(const MessagePart& part) const;
  /// Elements of the same container by other indices.
  std::vector<MessagePart> in_same_container(const MessagePart& part) const;
  /// Elements that may be others when the index ("@120@"), iterator or container changes.
  const std::set<MessagePart>& moved_with(const MessagePart& changed) const;

 private:
  using NamedStems = std::map<std::string, std::set<std::string>>;  ///< by function
  /// What is given to functions: a stem -> a function and its parameter.
  using GivenAs = std::multimap<std::string, std::pair<std::string, std::string>>;

  const std::string& family_of(const std::string& stem) const;
  void unite_results(const Facts& facts, const std::string& callee);
  void unite_kept_parameters(const Facts& facts);
  void unite_named_arguments(const Facts& facts);
  void unite_with_parameters(const std::string& stem, const GivenAs& given, const NamedStems& named);
  void unite(const std::string& one, const std::string& other);
  void add_name(const MessagePart& part);
  void add_elements(const std::set<MessagePart>& changed);

  std::map<std::string, std::string> families_;           ///< of stems: one of them stands for all
  std::map<std::string, std::set<MessagePart>> by_stem_;  ///< names of whole messages
  std::map<std::string, std::set<MessagePart>> by_family_;
  std::map<MessagePart, std::set<MessagePart>> moved_;
};

}  // namespace tzc::rewriter
