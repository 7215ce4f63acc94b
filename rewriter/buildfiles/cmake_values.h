// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/cmake_file.h"

namespace tzc::rewriter {

/// The values that variables may have, without running CMake: every one that a set(), list(APPEND), foreach()
/// or project() of the file gives them; control flow is ignored. References to unknown variables stay as
/// written: "${catkin_LIBRARIES}".
class CmakeValues {
 public:
  void learn(const CmakeCommand& command);

  /// Every text that an argument may expand to (lists split at ';'), some thousands and some megabytes of it at most.
  std::set<std::string> expand(const std::string& text) const;
  std::set<std::string> expand(const CmakeCommand& command, std::size_t first = 0) const;

  bool may_be(const std::string& text, const std::string& value) const {
    return expand(text).count(value) != 0;
  }

 private:
  void add(const std::string& variable, const std::string& text);
  void add(const std::string& variable, const CmakeCommand& command, std::size_t first);
  void add_loop(const CmakeCommand& loop);

  std::map<std::string, std::set<std::string>> values_;
};

}  // namespace tzc::rewriter
