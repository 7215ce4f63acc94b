// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tzc::rewriter {

/// A C++ file that is not analysed: no target of this configuration compiles it, the build generates it, or it is another
/// package's.
struct UnseenFile {
  enum class Place {
    package,
    other_package,
    elsewhere
  };  ///< elsewhere: where the build generates it, or a link leads
  std::string file;
  std::set<std::string> headers;  ///< of the packages that it includes, through others, too
  Place place = Place::package;
};

/// Finds them once it is known which files were analysed, and by which units.
using FindUnseenFiles =
    std::function<std::vector<UnseenFile>(const std::map<std::string, std::set<std::string>>& units_of_file)>;

}  // namespace tzc::rewriter
