// SPDX-License-Identifier: BSD-3-Clause
#include "port/port_writer.h"

#include <algorithm>
#include <iterator>

#include "transaction/swap.h"

namespace tzc::rewriter {

Expected<PortWriter> PortWriter::open(const PortOptions& options, const std::vector<std::string>& packages) {
  PortWriter writer(options);
  if (options.action == Action::out_dir) {
    Expected<OutDir> out_dir = OutDir::open(options.out_dir, packages, options.packages);
    if (!out_dir) return out_dir.error();
    writer.out_dir_.emplace(std::move(*out_dir));
  }
  if (options.action == Action::apply || writer.out_dir_) {
    const std::vector<std::string> written =
        writer.out_dir_ ? std::vector<std::string>{writer.out_dir_->folder()} : packages;
    Expected<UndoPatch> undo = UndoPatch::open(options.undo, written);
    if (!undo) return undo.error();
    writer.undo_.emplace(std::move(*undo));
  }
  return writer;
}

Expected<void> PortWriter::write(std::vector<PackagePort>& ports) {
  if (!undo_) return {};
  Expected<void> ready = out_dir_ ? stage(ports) : look_at_git(ports);
  if (!ready) return ports.clear(), ready;
  std::set<std::string> written;
  for (const WriteUnit& unit : write_units(ports)) {
    ready = write_unit(unit);
    if (!ready) break;
    for (const PackagePort* port : unit) written.insert(port->package_dir);
  }
  const auto is_left = [&](const PackagePort& port) { return written.count(port.package_dir) == 0; };
  ports.erase(std::remove_if(ports.begin(), ports.end(), is_left), ports.end());
  return ready;
}

namespace {

/// Why files may not be written over: there is work in them that git could not bring back, or that nobody can see.
std::optional<Error> refusal(const Expected<OutsideGit>& outside) {
  if (!outside) return outside.error();
  if (!outside->uncommitted.empty())
    return Error{"has changes that git does not have; nothing was written", *outside->uncommitted.begin(),
                 "commit or stash them first, or write over them with --force"};
  if (outside->unwatched.empty()) return {};
  return Error{
      "git was told not to look for changes of this file, so they cannot be seen; nothing was written",
      *outside->unwatched.begin(),
      "type git update-index --no-assume-unchanged FILE, and --no-skip-worktree likewise, or write over it "
      "with --force"};
}

bool may_be_lost(const Expected<OutsideGit>& outside, const std::string& file) {
  return !outside || outside->uncommitted.count(file) || outside->unheld.count(file) ||
         outside->unwatched.count(file);
}

}  // namespace

/// Work that git could not bring back is written over only when the user says so. What lies in no repository is
/// not work in progress to git: it is written, and the undo patch brings it back.
Expected<void> PortWriter::look_at_git(const std::vector<PackagePort>& ports) {
  const Expected<OutsideGit> outside = outside_git(ports);
  if (std::optional<Error> why = refusal(outside); why && !options_.force) return *why;
  for (const PackagePort& port : ports)
    for (const auto& [file, content] : port.contents)
      if (may_be_lost(outside, file)) outside_git_.insert(file);
  return {};
}

/// The folder may be another workspace, in which somebody works.
Expected<void> PortWriter::stage(const std::vector<PackagePort>& ports) {
  std::vector<Overwritten> files;
  for (const PackagePort& port : ports) {
    if (Expected<void> staged = out_dir_->stage(port); !staged) return staged;
    const std::vector<Overwritten> of_port = out_dir_->overwritten_by(port);
    files.insert(files.end(), of_port.begin(), of_port.end());
  }
  return files.empty() ? Expected<void>() : keep_overwritten(files);
}

/// By the same rules as in place: what git has comes back from there, and what no repository holds from the undo patch.
Expected<void> PortWriter::keep_overwritten(const std::vector<Overwritten>& files) {
  std::vector<std::string> paths;
  for (const Overwritten& file : files) paths.push_back(file.path);
  const Expected<OutsideGit> outside = outside_git(paths);
  if (std::optional<Error> why = refusal(outside); why && !options_.force) return *why;
  PackagePort kept;
  kept.package_dir = out_dir_->folder();
  for (const Overwritten& file : files) {
    if (!may_be_lost(outside, file.path)) continue;
    if (!file.is_text && !options_.force)
      return Error{
          "is there, is no text that an undo patch could bring back, and git does not have it; nothing was "
          "written",
          file.path, "move it away, name another folder, or write over it with --force"};
    if (!file.is_text) continue;
    kept.result.changes.push_back(file.change);
    overwritten_.push_back(file.path);
  }
  const Expected<void> saved = undo_->add({&kept});
  if (saved) return {};
  if (!options_.force)
    return Error{"is in no git repository, and no undo patch could be saved: " + saved.error().what + " (" +
                     saved.error().where + "); nothing was written",
                 overwritten_.front(), "name a file for the patch with --undo, or do without with --force"};
  unsaved_ = "no undo patch could be saved: " + to_string(saved.error());
  return {};
}

Expected<void> PortWriter::write_unit(const WriteUnit& unit) {
  if (out_dir_) {
    has_written_ = true;
    for (const PackagePort* port : unit)
      if (Expected<void> done = out_dir_->move_in(*port); !done) return done;
    return {};
  }
  WriteUnit changed;
  std::copy_if(unit.begin(), unit.end(), std::back_inserter(changed),
               [](const PackagePort* port) { return !port->contents.empty(); });
  if (changed.empty()) return {};
  const Expected<void> saved = save_undo(changed);
  if (!saved) return saved;
  Expected<void> done = write_in_place(changed);
  if (done || is_swap_unfinished(changed))
    for (const PackagePort* port : changed) note_written(*port);
  else
    undo_->drop_last();
  return done;
}

/// Without a place that the user named, a port is worth more than its undo patch where git has the originals, too.
Expected<void> PortWriter::save_undo(const WriteUnit& unit) {
  Expected<void> saved = undo_->add(unit);
  if (saved || !options_.undo.empty()) return saved;
  const bool in_git = std::none_of(unit.begin(), unit.end(), [&](const PackagePort* port) {
    return std::any_of(port->contents.begin(), port->contents.end(),
                       [&](auto& entry) { return outside_git_.count(entry.first); });
  });
  if (!in_git && !options_.force)
    return Error{"is not in git, and no undo patch could be saved: " + saved.error().what + " (" +
                     saved.error().where + "); nothing of the package was written",
                 unit.front()->package_dir,
                 "name a file for the patch with --undo, or do without with --force"};
  unsaved_ = "no undo patch could be saved: " + to_string(saved.error());
  return {};
}

void PortWriter::note_written(const PackagePort& port) {
  has_written_ = true;
  for (const auto& [file, content] : port.contents)
    if (outside_git_.count(file)) overwritten_.push_back(file);
}

std::vector<std::string> PortWriter::warnings() const {
  std::vector<std::string> all;
  if (!unsaved_.empty()) all.push_back(unsaved_);
  if (overwritten_.empty()) return all;
  const std::size_t others = overwritten_.size() - 1;
  const std::string more = others == 0 ? "" : " and in " + std::to_string(others) + " more";
  const std::string undo = undo_->command();
  all.push_back("git does not have what was in " + overwritten_.front() + more +
                (undo.empty() ? "" : "; this alone brings it back: " + undo));
  return all;
}

}  // namespace tzc::rewriter
