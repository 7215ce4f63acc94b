// SPDX-License-Identifier: BSD-3-Clause
#include "tool/writing.h"

#include <filesystem>
#include <set>

#include "edits/diff.h"
#include "edits/swap.h"
#include "tool/git.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// What the paths of a package's diff are relative to.
struct DiffBase {
  std::string folder;
  bool git = false;
};

DiffBase diff_base(const std::string& package_dir) {
  std::error_code failed;
  const std::string here = fs::current_path(failed);
  const std::string top = git_top(package_dir);
  if (!top.empty() && (here == top || is_below(here, top))) return {top, true};
  if (here == package_dir || is_below(package_dir, here)) return {here, false};
  return top.empty() ? DiffBase{package_dir, false} : DiffBase{top, true};
}

Expected<void> copy_package(const std::string& from, const fs::path& to) {
  std::error_code failed;
  fs::create_directories(to, failed);
  const auto options = fs::copy_options::overwrite_existing | fs::copy_options::copy_symlinks;
  for (const auto& entry : fs::directory_iterator(from, failed)) {
    const std::string name = entry.path().filename();
    if (name == ".git" || name == ".tzc-rewrite" || entry.path() == to) continue;
    fs::copy(entry.path(), to / name, options | fs::copy_options::recursive, failed);
    if (failed) return Error{"can not be copied: " + failed.message(), entry.path(), ""};
  }
  if (failed) return Error{"can not be written: " + failed.message(), to, ""};
  return {};
}

Expected<void> write_copy(const PackagePort& port, const fs::path& out_dir) {
  const fs::path to = fs::weakly_canonical(out_dir) / fs::path(port.package_dir).filename();
  if (to == port.package_dir || is_below(to, port.package_dir))
    return Error{"--out-dir lies in the package itself", to, "name another folder, or use --apply"};
  if (Expected<void> copied = copy_package(port.package_dir, to); !copied) return copied;
  for (const auto& [file, content] : port.contents)
    if (Expected<void> done = write_file(to / file.substr(port.package_dir.size() + 1), content); !done)
      return done;
  return {};
}

}  // namespace

std::string diff_of(const std::vector<PackagePort>& ports) {
  std::string text;
  for (const PackagePort& port : ports) {
    const DiffBase base = diff_base(port.package_dir);
    for (const FileChange& change : port.result.changes) {
      const std::string file = port.package_dir + "/" + change.path;
      text += unified_diff(file.substr(base.folder.size() + 1), change.before, change.after, base.git).text;
    }
  }
  return text;
}

Expected<void> check_committed(const std::vector<PackagePort>& ports) {
  for (const PackagePort& port : ports) {
    const std::string top = port.contents.empty() ? "" : git_top(port.package_dir);
    if (top.empty()) continue;
    std::vector<std::string> files;
    for (const auto& [file, content] : port.contents) files.push_back(file);
    const std::vector<std::string> dirty = uncommitted(top, files);
    if (!dirty.empty())
      return Error{"has changes that git does not have; nothing was written", top + "/" + dirty.front(),
                   "commit or stash them first, or write over them with --force"};
  }
  return {};
}

Expected<void> write_in_place(const std::vector<PackagePort>& ports) {
  for (const PackagePort& port : ports)
    if (Expected<void> done = swap_in(port.package_dir, port.contents, port.before); !done) return done;
  return {};
}

Expected<void> write_copies(const std::vector<PackagePort>& ports, const std::string& out_dir) {
  std::set<std::string> names;
  for (const PackagePort& port : ports)
    if (!names.insert(fs::path(port.package_dir).filename()).second)
      return Error{"two packages lie in folders of this name; nothing was written", port.package_dir,
                   "port them one after the other into different folders"};
  for (const PackagePort& port : ports)
    if (Expected<void> done = write_copy(port, out_dir); !done) return done;
  return {};
}

}  // namespace tzc::rewriter
