// SPDX-License-Identifier: BSD-3-Clause
#include "parse/candidates.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "parse/source.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

// The file that `name` comes from if it ends with the suffix, in the folder itself or in the one beside it.
void add_origin(const fs::path& folder, const std::string& name, std::string_view suffix, const char* kind,
                std::vector<std::string>& candidates) {
  if (name.size() <= suffix.size()) return;
  const std::size_t stem = name.size() - suffix.size();
  if (name.compare(stem, suffix.size(), suffix) != 0) return;
  const std::string file = name.substr(0, stem) + "." + kind;
  candidates.push_back((folder / file).string());
  candidates.push_back((folder.parent_path() / kind / file).string());
}

}  // namespace

std::vector<std::string> message_candidates(const std::string& folder, const std::string& name) {
  std::vector<std::string> candidates = {(fs::path(folder) / (name + ".msg")).string()};
  for (const char* suffix :
       {"ActionGoal", "ActionResult", "ActionFeedback", "Action", "Goal", "Result", "Feedback"}) {
    add_origin(folder, name, suffix, "action", candidates);
  }
  return candidates;
}

std::vector<std::string> service_candidates(const std::string& folder, const std::string& name) {
  std::vector<std::string> candidates;
  for (const char* suffix : {"Request", "Response"}) add_origin(folder, name, suffix, "srv", candidates);
  return candidates;
}

bool comes_from_service(const std::vector<std::string>& folders, const std::string& name) {
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    const auto files = service_candidates(folder, name);
    return std::any_of(files.begin(), files.end(), is_file);
  });
}

}  // namespace tzc::msggen
