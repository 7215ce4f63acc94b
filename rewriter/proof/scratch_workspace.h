// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "proof/paths.h"

//  the user's                      the scratch folder
//    ws/src/CMakeLists.txt    <──    src/CMakeLists.txt     links, but for the packages that are tried,
//    ws/src/notes             <──    src/notes              and those that CMake configures with them:
//    ws/src/other                    src/other              copied
//    ws/src/demo                     src/demo               copied, with the text that would be written

namespace tzc::rewriter {

/// A workspace's sources with other text in some of its packages, in a folder of its own. Nothing of the
/// user's is written: what is not copied is a symbolic link, files of more than a megabyte among them.
class ScratchWorkspace {
 public:
  /// `root`: the folder that holds the packages, or a package itself. `packages`: canonical folders.
  /// `omitted`: folders and files that are not part of the sources (build trees).
  ScratchWorkspace(const std::string& root, const std::vector<std::string>& packages, std::string folder,
                   const std::vector<std::string>& omitted);

  /// Makes the copies and links. To be called once, before write().
  Expected<void> make();

  /// Gives the files (canonical paths) this text, and the files of earlier calls their own again.
  Expected<void> write(const FileContents& contents);

  /// What stands for the root.
  const std::string& folder() const { return folder_; }

  /// A package (canonical) as the build names it, and what stands for it.
  const std::string& named(const std::string& package) const { return places_.at(package).named; }
  const std::string& scratch(const std::string& package) const { return places_.at(package).scratch; }

  /// The user's paths to the scratch folder's, and back (canonical).
  const PathMap& to_scratch() const { return to_scratch_; }
  const PathMap& to_user() const { return to_user_; }

 private:
  struct Place {
    std::string named;    ///< as found below the root
    std::string scratch;  ///< what stands for it
  };
  void find_places(const std::string& folder, unsigned depth);
  bool is_link_to_package(const std::string& link) const;
  bool leads_to_package(const std::string& folder) const;
  Expected<void> mirror(const std::string& from, const std::string& to);
  Expected<void> copy(const std::string& from, const std::string& to);
  Expected<void> copy_entry(const std::string& from, const std::string& to);
  void link(const std::string& target, const std::string& at) const;
  Expected<void> put(const std::string& file, const std::string& content) const;

  std::string root_, folder_;
  std::map<std::string, Place> places_;  ///< by canonical folder of the package
  std::set<std::string> omitted_, written_;
  PathMap to_scratch_, to_user_;
};

}  // namespace tzc::rewriter
