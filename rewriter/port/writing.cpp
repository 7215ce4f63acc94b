// SPDX-License-Identifier: BSD-3-Clause
#include "port/writing.h"

#include <filesystem>
#include <optional>
#include <set>

#include "buildfiles/build_trees.h"
#include "edits/diff.h"
#include "interruption/interruption.h"
#include "transaction/swap.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// The folder to which the paths of a package's diff are relative.
struct DiffBase {
  std::string folder;
  bool git = false;
};

DiffBase diff_base(const std::string& package_dir) {
  std::error_code failed;
  const std::string here = fs::current_path(failed);
  const std::optional<Repository> repository = repository_of(package_dir);
  // Where git refuses a repository, `git apply` does as if there were none.
  const std::string top = repository && !repository->failure ? repository->top : "";
  if (!top.empty() && (here == top || is_below(here, top))) return {top, true};
  if (here == package_dir || is_below(package_dir, here)) return {here, false};
  return top.empty() ? DiffBase{package_dir, false} : DiffBase{top, true};
}

Error not_written(const std::string& path, const std::error_code& failed) {
  return {"cannot be written: " + failed.message(), path, "name a folder that can be written with --out-dir"};
}

/// CMake refuses a folder whose cache was made elsewhere, so of an in-source build only the sources are copied.
std::set<std::string> uncopied(const PackagePort& port) {
  if (port.build_dir.empty() || !builds_in_source(port.build_dir, port.package_dir)) return {};
  const std::vector<std::string> paths = build_paths(port.build_dir, {port.package_dir});
  return {paths.begin(), paths.end()};
}

Error not_copied(const std::string& path, const std::error_code& failed) {
  return {"cannot be copied: " + failed.message(), path,
          failed == std::errc::permission_denied ? "make it readable, or move it out of the package"
                                                 : "make room there, or name another folder with --out-dir"};
}

/// The user may write to a copy, also to that of a file which he may not write to.
Expected<void> copy_entry(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(from, failed);
  if (fs::is_directory(status)) {
    fs::create_directory(to, failed);
    if (failed) return not_written(to, failed);
    for (const auto& entry : fs::directory_iterator(from, failed))
      if (Expected<void> done = copy_entry(entry.path(), to / entry.path().filename()); !done) return done;
    if (failed) return not_copied(from, failed);
    fs::permissions(to, status.permissions() | fs::perms::owner_all, failed);
    return {};
  }
  fs::copy(from, to, fs::copy_options::copy_symlinks, failed);
  if (failed) return not_copied(from, failed);
  if (fs::is_regular_file(status)) fs::permissions(to, status.permissions() | fs::perms::owner_write, failed);
  return {};
}

Expected<void> copy_package(const PackagePort& port, const fs::path& to, const std::string& out_dir) {
  const std::string& from = port.package_dir;
  const std::set<std::string> without = uncopied(port);
  std::error_code failed;
  fs::create_directories(to, failed);
  for (const auto& entry : fs::directory_iterator(from, failed)) {
    const std::string name = entry.path().filename();
    if (name == ".git" || name == ".tzc-rewrite" || entry.path() == out_dir || without.count(entry.path()))
      continue;
    if (Expected<void> done = copy_entry(entry.path(), to / name); !done) return done;
  }
  if (failed) return not_written(to, failed);
  return {};
}

/// Moves what is in `from` over what is in `to`; files of `to` that `from` does not have stay.
Expected<void> move_into(const fs::path& from, const fs::path& to) {
  std::error_code failed, ignored;
  const bool is_folder = fs::is_directory(fs::symlink_status(from, ignored));
  if (is_folder && fs::is_directory(to, ignored)) {
    for (const auto& entry : fs::directory_iterator(from, failed))
      if (Expected<void> done = move_into(entry.path(), to / entry.path().filename()); !done) return done;
  } else {
    if (fs::is_directory(fs::symlink_status(to, ignored))) fs::remove_all(to, failed);
    fs::rename(from, to, failed);
  }
  if (failed) return not_written(to, failed);
  return {};
}

/// No link, which a patch does not bring back.
bool is_plain_text(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path, ignored)) && is_text_file(path);
}

/// Links that lead to the same place, or files with the same content.
bool is_same(const fs::path& one, const fs::path& other) {
  std::error_code failed, ignored;
  const fs::file_status status = fs::symlink_status(one, ignored);
  if (status.type() != fs::symlink_status(other, ignored).type()) return false;
  if (fs::is_symlink(status))
    return fs::read_symlink(one, failed) == fs::read_symlink(other, failed) && !failed;
  if (!fs::is_regular_file(status) || fs::file_size(one, failed) != fs::file_size(other, failed) || failed)
    return false;
  const Expected<std::string> left = read_file(one), right = read_file(other);
  return left && right && *left == *right;
}

/// The path of a package below what the user named, so that the copies of a repository's packages lie as in it.
std::string place_of(const std::string& package, const std::vector<std::string>& named) {
  for (const std::string& name : named) {
    std::error_code failed;
    const std::string folder = fs::canonical(name, failed);
    if (!failed && is_below(package, folder)) return package.substr(folder.size() + 1);
  }
  return fs::path(package).filename();
}

/// A part of the path below `folder` that is there and is no folder; empty: none is.
std::string file_in_the_way(const std::string& folder, fs::path to) {
  std::error_code ignored;
  for (; is_below(to, folder); to = to.parent_path())
    if (fs::exists(to, ignored) && !fs::is_directory(to, ignored)) return to;
  return "";
}

Expected<void> check_places(const std::string& folder, const std::map<std::string, std::string>& places) {
  std::set<std::string> taken;
  for (const auto& [package, place] : places) {
    const std::string to = fs::path(folder) / place;
    if (to == package || is_below(to, package))
      return Error{"--out-dir lies in the package itself", to, "name another folder, or use --apply"};
    if (const std::string file = file_in_the_way(folder, to); !file.empty())
      return Error{"is no folder, and --out-dir needs one here", file,
                   "move it away, or name another folder"};
    if (!taken.insert(place).second)
      return Error{
          "two packages lie in folders of this name; nothing was written", package,
          "name the folder that holds both, or port them one after the other into different folders"};
  }
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

Expected<OutsideGit> outside_git(const std::vector<PackagePort>& ports) {
  std::vector<std::string> files;
  for (const PackagePort& port : ports)
    for (const auto& [file, content] : port.contents) files.push_back(file);
  return outside_git(files);
}

std::vector<WriteUnit> write_units(const std::vector<PackagePort>& ports) {
  std::vector<WriteUnit> units;
  std::map<std::string, std::size_t> unit_of;  // of those to which an earlier one is joined
  for (const PackagePort& port : ports) {
    const auto known = unit_of.emplace(port.package_dir, units.size());
    if (known.second) units.emplace_back();
    units[known.first->second].push_back(&port);
    for (const std::string& other : port.joined) unit_of.emplace(other, known.first->second);
  }
  return units;
}

Expected<void> write_in_place(const WriteUnit& unit) {
  std::vector<PackageSwap> swaps;
  for (const PackagePort* port : unit) swaps.push_back({port->package_dir, port->contents, port->before});
  return swap_in(swaps);
}

bool is_swap_unfinished(const WriteUnit& unit) {
  std::vector<std::string> folders;
  for (const PackagePort* port : unit) folders.push_back(port->package_dir);
  return is_swap_unfinished(folders);
}

Expected<OutDir> OutDir::open(const std::string& folder, const std::vector<std::string>& packages,
                              const std::vector<std::string>& named) {
  const std::string place = fs::weakly_canonical(folder);
  OutDir out(place);
  for (const std::string& package : packages) out.places_[package] = place_of(package, named);
  if (Expected<void> fits = check_places(out.folder_, out.places_); !fits) return fits.error();
  std::error_code failed;
  const bool is_new = fs::create_directories(out.folder_, failed);
  if (failed) return not_written(out.folder_, failed);
  Expected<ScratchFolder> staging = ScratchFolder::make_in(out.folder_, ".tzc-rewrite-");
  if (!staging)
    return Error{staging.error().what, out.folder_, "name a folder that can be written with --out-dir"};
  out.staging_.emplace(std::move(*staging));
  out.is_new_ = is_new;
  return out;
}

OutDir::~OutDir() {
  std::error_code ignored;
  if (!staging_ || staging_->path().empty()) return;  // moved from
  staging_.reset();
  if (is_new_) fs::remove(folder_, ignored);  // fails where it holds something
}

Expected<void> OutDir::stage(const PackagePort& port) const {
  const fs::path staged = fs::path(staging_->path()) / places_.at(port.package_dir);
  if (Expected<void> copied = copy_package(port, staged, folder_); !copied) return copied;
  for (const auto& [file, content] : port.contents)
    if (Expected<void> done = write_file(staged / file.substr(port.package_dir.size() + 1), content); !done)
      return done;
  return {};
}

/// Each folder of the copy is merged into the one that is there, and everything else replaces what is there.
void OutDir::compare(const fs::path& staged, const fs::path& to, std::vector<Overwritten>& found) const {
  std::error_code failed, ignored;
  const bool is_folder = fs::is_directory(fs::symlink_status(staged, ignored));
  if (is_folder && fs::is_directory(to, ignored)) {
    for (const auto& entry : fs::directory_iterator(staged, failed))
      compare(entry.path(), to / entry.path().filename(), found);
    return;
  }
  if (!fs::exists(fs::symlink_status(to, ignored)) || is_same(staged, to)) return;
  Overwritten lost{canonical_path(to.parent_path()) + "/" + to.filename().string()};
  const Expected<std::string> before = is_plain_text(to) ? read_file(to) : Error();
  const Expected<std::string> after = is_plain_text(staged) ? read_file(staged) : Error();
  lost.is_text = before && after;
  if (lost.is_text)
    lost.change = {to.string().substr(folder_.size() + (folder_ == "/" ? 0 : 1)), *before, *after};
  found.push_back(std::move(lost));
}

std::vector<Overwritten> OutDir::overwritten_by(const PackagePort& port) const {
  std::vector<Overwritten> found;
  const std::string& place = places_.at(port.package_dir);
  compare(fs::path(staging_->path()) / place, fs::path(folder_) / place, found);
  return found;
}

Expected<void> OutDir::move_in(const PackagePort& port) const {
  const std::string& place = places_.at(port.package_dir);
  const fs::path to = fs::path(folder_) / place;
  std::error_code failed;
  fs::create_directories(to.parent_path(), failed);
  if (failed) return not_written(to, failed);
  const InterruptionDelay until_moved;  // over a copy that is there it goes file by file
  return move_into(fs::path(staging_->path()) / place, to);
}

}  // namespace tzc::rewriter
