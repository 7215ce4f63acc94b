// SPDX-License-Identifier: BSD-3-Clause
#include "tool/undo_without_apply.h"

#include <filesystem>

#include "buildfiles/find_packages.h"
#include "port/shell_word.h"
#include "port/undo.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Asks the program that the user is going to type.
bool fits(const std::string& file, const std::string& folder) {
  return run_process({"patch", "--dry-run", "--force", "-p1", "-d", folder, "-i", file}).status == 0;
}

/// The command that takes back the port which the patch was saved of, as far as it fits the packages, or a folder above
/// them, as they are now; empty: it does not.
std::string undoing_command(const std::string& file, const std::vector<std::string>& packages) {
  std::error_code failed;
  const std::string patch = fs::canonical(file, failed);
  if (failed || fs::is_empty(patch, failed) || failed) return "";
  for (const std::string& argument : packages) {
    const Expected<std::vector<std::string>> found = find_packages_at(argument);
    for (const std::string& package : found ? *found : std::vector<std::string>())
      for (fs::path folder = package; folder.has_relative_path(); folder = folder.parent_path())
        if (fits(patch, folder)) return undo_command(folder, patch);
  }
  return "";
}

}  // namespace

Answer undo_without_apply(const std::string& file, const std::vector<std::string>& packages) {
  const std::string what = "tzc-rewrite: --undo names the file where --apply saves its undo patch\n";
  const std::string undoing = undoing_command(file, packages);
  if (!undoing.empty()) return {what + "  nothing was undone; type: " + undoing + "\n", 2};
  std::error_code ignored;
  if (fs::exists(file, ignored))
    return {what + "  " + file + " does not fit the packages as they are\n" +
                "  nothing was undone; type the line that --apply ended with when it saved the patch\n",
            2};
  std::string port = "tzc-rewrite --apply --undo " + shell_word(file);
  for (const std::string& package : packages) port += " " + shell_word(package);
  return {what + "  nothing was undone; to port and save the patch, type: " + port + "\n", 2};
}

}  // namespace tzc::rewriter
