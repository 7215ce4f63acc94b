// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/location.h"
#include "other_code/code_casts.h"
#include "other_code/unseen_files.h"

namespace tzc::rewriter {

/// Other packages of the workspace that may be given messages which these receive: what these include, through others, too; who
/// includes these, as what overrides or registers a function of theirs does; what those include; and plugins whose base is in any of
/// these. `is_left_out`: asked for each file's name. As folders.
std::set<std::string> packages_that_may_be_given(const FolderSet& packages, const IncludeGraph& graph,
                                                 const std::function<bool(const std::string&)>& is_left_out);

/// Casts in code of other packages that may take the const from a received message. It is searched as text: what another package
/// defines in a source of its own is in no unit of these. A type that is named by a parameter of a template, or through auto, may
/// be each one that its package names.
class CastsElsewhere {
 public:
  /// `files`: of these packages, that may hold such casts.
  CastsElsewhere(const FolderSet& packages, const std::set<std::string>& files);

  /// Of a message of the type: "sensor_msgs/Image". None: there is none.
  std::optional<Location> of(const std::string& type) const;

 private:
  struct Cast {
    CodeCast code;
    std::string package;
    Location where;
  };
  void read(const std::string& file, const std::string& package);

  std::vector<Cast> casts_;
  std::map<std::string, std::vector<CodeWords>> aliases_;
  std::set<std::string> parameters_;
  std::map<std::string, std::set<std::string>> names_;  ///< package -> words of its code
};

}  // namespace tzc::rewriter
