// SPDX-License-Identifier: BSD-3-Clause
#include "port/undo.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "edits/files.h"
#include "port/shell_word.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_kept = 100;  // patches of earlier runs

std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local)};
}

/// Names begin with the time, so the oldest come first.
void remove_oldest(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".patch") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (std::size_t i = 0; i + most_kept < files.size(); ++i) fs::remove(files[i], ignored);
}

Expected<std::string> new_file() {
  const std::string state = user_folder("XDG_STATE_HOME", ".local/state");
  if (state.empty())
    return Error{"has no place: neither XDG_STATE_HOME nor HOME is set", "the undo patch", ""};
  const std::string folder = state + "/tzc/undo";
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Error{"cannot be made: " + failed.message(), folder, "name a file with --undo"};
  remove_oldest(folder);
  return folder + "/" + time_stamp() + "-" + std::to_string(::getpid()) + ".patch";
}

/// A device is no place for a patch that is renamed into place.
bool is_in_the_way(const std::string& file) {
  std::error_code ignored;
  return fs::exists(file, ignored) && !fs::is_regular_file(file, ignored);
}

}  // namespace

std::string undo_command(const std::string& folder, const std::string& patch) {
  return "patch -p1 -d " + shell_word(folder) + " <" + shell_word(patch);
}

Expected<UndoPatch> UndoPatch::open(const std::string& file, const std::vector<std::string>& packages) {
  UndoPatch patch;
  patch.folder_ = common_folder(packages);
  if (file.empty()) return patch;
  patch.file_ = fs::absolute(file).lexically_normal();
  if (is_in_the_way(patch.file_)) return Error{"is no regular file", file, "name another file with --undo"};
  const std::string staged = patch.file_ + ".part";
  if (Expected<void> done = write_file(staged, ""); !done)
    return Error{done.error().what, file, "name another file with --undo"};
  std::error_code ignored;
  fs::remove(staged, ignored);
  return patch;
}

Expected<void> UndoPatch::save() const {
  const std::string staged = file_ + ".part";
  std::string text;
  for (const std::string& part : parts_) text += part;
  if (Expected<void> done = write_file(staged, text); !done) return done;
  std::error_code failed;
  fs::rename(staged, file_, failed);
  if (failed) return Error{"cannot be written: " + failed.message(), file_, "name another file with --undo"};
  return {};
}

std::string UndoPatch::part_for(const PackagePort& port) const {
  std::string part;
  for (const FileChange& change : port.result.changes) {
    const std::string path = port.package_dir + "/" + change.path;
    part += unified_diff(path.substr(folder_.size() + (folder_ == "/" ? 0 : 1)), change.after, change.before,
                         false)
                .text;
  }
  return part;
}

Expected<void> UndoPatch::add(const WriteUnit& unit) {
  std::string part;
  for (const PackagePort* port : unit) part += part_for(*port);
  if (part.empty()) return {};
  if (file_.empty()) {
    Expected<std::string> file = new_file();
    if (!file) return file.error();
    file_ = *file;
  }
  parts_.push_back(part);
  Expected<void> done = save();
  if (!done) parts_.pop_back();
  return done;
}

void UndoPatch::drop_last() {
  if (parts_.empty()) return;
  parts_.pop_back();
  std::error_code ignored;
  if (parts_.empty())
    fs::remove(file_, ignored);
  else
    (void)save();
}

std::string UndoPatch::command() const {
  return parts_.empty() ? "" : undo_command(folder_, file_);
}

}  // namespace tzc::rewriter
