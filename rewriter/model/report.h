// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/site.h"

namespace tzc::rewriter {

/// A remark that belongs to no site: a file not parsed in this configuration, an #if branch not seen, ...
struct Note {
  std::string code;  ///< TZC3nnn, TZC4nnn
  std::optional<Location> where;
  std::string text;
};

struct Report {
  std::string package;      ///< its name
  std::string package_dir;  ///< absolute, canonical; files are shown relative to it
  std::vector<Site> sites;
  std::vector<Note> notes;
};

}  // namespace tzc::rewriter
