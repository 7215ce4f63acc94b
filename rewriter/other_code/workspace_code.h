// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/edit.h"
#include "model/file_accesses.h"
#include "model/folder_set.h"
#include "model/location.h"
#include "other_code/casts_elsewhere.h"
#include "other_code/unseen_files.h"

namespace tzc::rewriter {

struct SourcePackage {
  std::string dir, name;
  std::string build_dir;
  bool has_units = true;  ///< `build_dir` holds their compile_commands.json; false: it compiles nothing
};

/// What seems to compile or include changed files, as text.
struct HeaderChangeUsers {
  std::set<std::string> sources;         ///< that the packages' build trees compile, also other packages'
  std::vector<CompileCommand> commands;  ///< of other packages that have build trees of their own
};

/// The source spaces that packages lie in.
std::set<std::string> source_spaces(const std::vector<SourcePackage>& packages);

/// The code of the workspace around packages that are ported, and what is compiled of it.
class WorkspaceCode {
 public:
  using IsLeftOut = std::function<bool(const std::string& file)>;

  /// `is_dead`: nothing compiles the file any more. `accesses`: told what is read; may be null.
  WorkspaceCode(const std::vector<SourcePackage>& packages, IsLeftOut is_dead, IncludeGraphs& graphs,
                FileAccesses* accesses);

  const IncludeGraph& includes() const { return includes_; }
  HeaderChangeUsers users_of(const FileContents& changed) const;
  /// Where another package that may be given messages of the type, "sensor_msgs/Image", may cast the const of one away; none: nowhere.
  std::optional<Location> cast_elsewhere(const std::string& type) const;

 private:
  CastsElsewhere casts_elsewhere() const;

  const IsLeftOut is_dead_;
  const FolderSet own_;  ///< the packages that are ported
  const std::set<std::string> compiled_;
  IncludeGraph includes_;
  const std::vector<CompileCommand> commands_of_others_;
  mutable std::optional<CastsElsewhere> casts_;  ///< read when they are asked for
};

}  // namespace tzc::rewriter
