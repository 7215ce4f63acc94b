// SPDX-License-Identifier: BSD-3-Clause
#include "engine/other_code.h"

#include <algorithm>

#include "model/codes.h"
#include "model/folder_set.h"

namespace tzc::rewriter {

void add_casts_elsewhere(Facts& facts, const OtherCode& others) {
  if (!others.cast_elsewhere) return;
  std::set<std::string> types;
  for (const auto& item : facts.subscribes)
    if (item.second.has_data_part) types.insert(item.second.type);
  for (const std::string& type : types)
    if (const std::optional<Location> where = others.cast_elsewhere(type))
      facts.const_casts.push_back(
          {type,
           {},
           {codes::TZC2002,
            "code of another package, which may be given this message, may cast its const away: " +
                where->file + ":" + std::to_string(where->line),
            *where}});
}

std::map<ComponentId, Obstacle> OtherCodeLimits::broken_by(const PortEdits& plan) const {
  std::map<ComponentId, Obstacle> found = unseen_.users_of(plan.edits);
  add_copied(plan, found);
  add_texts(plan, found);
  add_unshared(plan, found);
  return found;
}

/// A program that links both packages takes one of the two definitions for both, so they have to stay the same.
void OtherCodeLimits::add_copied(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const {
  for (const Edit& edit : plan.edits)
    for (const CopiedDefinition& copied : others_.copied)
      if (edit.component && edit.file == copied.file && edit.offset >= copied.begin &&
          edit.offset < copied.end)
        found.emplace(
            *edit.component,
            Obstacle{codes::TZC1005,
                     "another package has the same definition, and one program may have both: " + copied.copy,
                     Location{copied.file, 1, 1}});
}

/// FIELD(type, name) may write the type, and tell its name.
void OtherCodeLimits::add_texts(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const {
  for (const Edit& edit : plan.edits)
    for (const Place& text : texts_)
      if (edit.component && edit.file == text.file && edit.offset >= text.begin && edit.offset <= text.end)
        found.emplace(*edit.component,
                      Obstacle{codes::TZC1006, "a macro makes a text of the code that would be changed",
                               location_of(text)});
}

/// Who includes an exported header has to find what the port makes it include.
void OtherCodeLimits::add_unshared(const PortEdits& plan, std::map<ComponentId, Obstacle>& found) const {
  for (const auto& [file, headers] : plan.headers) {
    const std::string header = unshared_in(headers);
    if (header.empty() || !is_exported(file)) continue;
    for (const Edit& edit : plan.edits)
      if (edit.component && edit.file == file)
        found.emplace(*edit.component,
                      Obstacle{codes::TZC1005,
                               "other packages may include this header, and <" + header +
                                   "> would be generated in this package's build folder only",
                               Location{file, 1, 1}});
  }
}

/// "tzc/my_msgs/Scan.h"; empty: all are there for everybody.
std::string OtherCodeLimits::unshared_in(const std::set<std::string>& headers) const {
  for (const std::string& header : headers) {
    const std::size_t begin = header.find('/'), end = header.find('/', begin + 1);
    if (end != std::string::npos &&
        others_.unshared_twins.count(header.substr(begin + 1, end - begin - 1)) != 0)
      return header;
  }
  return {};
}

bool OtherCodeLimits::is_exported(const std::string& file) const {
  return std::any_of(exported_.begin(), exported_.end(),
                     [&](const std::string& path) { return file == path || is_below(file, path); });
}

}  // namespace tzc::rewriter
