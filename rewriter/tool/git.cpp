// SPDX-License-Identifier: BSD-3-Clause
#include "tool/git.h"

#include <filesystem>

#include "proof/process.h"

namespace tzc::rewriter {

std::string git_top(const std::string& folder) {
  ProcessResult git = run_process({"git", "-C", folder, "rev-parse", "--show-toplevel"});
  if (git.status != 0) return "";
  while (!git.output.empty() && git.output.back() == '\n') git.output.pop_back();
  std::error_code failed;
  const auto top = std::filesystem::canonical(git.output, failed);
  return failed ? "" : top.string();
}

std::vector<std::string> uncommitted(const std::string& top, const std::vector<std::string>& files) {
  std::vector<std::string> command = {
      "git", "-C", top, "status", "--porcelain=v1", "-z", "--untracked-files=all", "--"};
  command.insert(command.end(), files.begin(), files.end());
  const ProcessResult git = run_process(command);
  std::vector<std::string> dirty;
  // Each entry is "XY path\0"; a rename is followed by its old path alone.
  for (std::size_t at = 0; at + 3 < git.output.size();) {
    const std::size_t end = git.output.find('\0', at);
    const bool renamed = git.output[at] == 'R' || git.output[at] == 'C';
    dirty.push_back(git.output.substr(at + 3, end - at - 3));
    at = end + 1;
    if (renamed) at = git.output.find('\0', at) + 1;
  }
  return dirty;
}

std::string commit_of(const std::string& folder) {
  ProcessResult git = run_process({"git", "-C", folder, "rev-parse", "--short=12", "HEAD"});
  if (git.status != 0) return "";
  while (!git.output.empty() && git.output.back() == '\n') git.output.pop_back();
  const ProcessResult state = run_process({"git", "-C", folder, "status", "--porcelain=v1", "--", "."});
  return git.output + (state.output.empty() ? "" : " with uncommitted changes");
}

}  // namespace tzc::rewriter
