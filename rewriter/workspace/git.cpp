// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/git.h"

#include <filesystem>
#include <map>

#include "model/folder_set.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// File names stand for themselves, also those with a '*' or a ':'.
ProcessResult run_git(const std::string& folder, const std::vector<std::string>& words) {
  std::vector<std::string> command = {"git", "--literal-pathspecs", "-C", folder};
  command.insert(command.end(), words.begin(), words.end());
  return run_process(command);
}

std::string without_newline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// The nearest folder that holds .git: a folder, or the file of a submodule or a second work tree.
std::string holder_of_git(const std::string& folder) {
  std::error_code ignored;
  for (fs::path at = fs::weakly_canonical(folder, ignored); !at.empty(); at = at.parent_path()) {
    if (fs::exists(fs::symlink_status(at / ".git", ignored))) return at;
    if (!at.has_relative_path()) break;
  }
  return "";
}

/// Git prints the line that makes it trust a repository of another user; empty: it has another reason.
std::string trusting_line(const std::string& errors) {
  const std::size_t begin = errors.find("git config --global --add safe.directory");
  return begin == std::string::npos ? "" : errors.substr(begin, errors.find('\n', begin) - begin);
}

Error failure_of(const std::string& top, const ProcessResult& git) {
  const std::string unknown = "so uncommitted work cannot be seen; nothing was written";
  const std::string line = trusting_line(git.errors);
  if (!line.empty())
    return {"belongs to another user and git refuses to read it, " + unknown, top,
            "type\n    " + line + "\n  or write over whatever is there with --force"};
  if (git.status < 0)
    return {"is a git repository and git cannot be run, " + unknown, top,
            "install git, or write over whatever is there with --force"};
  return {"git cannot read this repository, " + unknown, top,
          "repair what git says (" + git.errors.substr(0, git.errors.find('\n')) +
              "), or write over whatever is there with --force"};
}

/// Takes the entries of `git status -z`: "XY path\0"; a rename is followed by its old path alone.
void add_states(const std::string& top, const std::string& states, OutsideGit& outside) {
  for (std::size_t at = 0; at + 3 < states.size();) {
    const std::size_t end = states.find('\0', at);
    const bool renamed = states[at] == 'R' || states[at] == 'C';
    (states[at] == '!' ? outside.unheld : outside.uncommitted)
        .insert(fs::path(top) / states.substr(at + 3, end - at - 3));
    at = end + 1;
    if (renamed) at = states.find('\0', at) + 1;
  }
}

/// Takes the entries of `git ls-files -v -z`: "T path\0" with a small letter or an S where git does not look at the file.
void add_unwatched(const std::string& top, const std::string& list, OutsideGit& outside) {
  for (std::size_t at = 0; at + 2 < list.size();) {
    const std::size_t end = list.find('\0', at);
    const char tag = list[at];
    if (tag == 'S' || (tag >= 'a' && tag <= 'z'))
      outside.unwatched.insert(fs::path(top) / list.substr(at + 2, end - at - 2));
    at = end + 1;
  }
}

Expected<void> ask_repository(const Repository& repository, const std::vector<std::string>& files,
                              OutsideGit& outside) {
  if (repository.failure) return *repository.failure;
  const auto ask = [&](std::vector<std::string> words) {
    words.push_back("--");
    words.insert(words.end(), files.begin(), files.end());
    return run_git(repository.top, words);
  };
  const ProcessResult states = ask({"status", "--porcelain=v1", "-z", "--untracked-files=all", "--ignored"});
  if (states.status != 0) return failure_of(repository.top, states);
  const ProcessResult tags = ask({"ls-files", "-v", "-z"});
  if (tags.status != 0) return failure_of(repository.top, tags);
  add_states(repository.top, states.output, outside);
  add_unwatched(repository.top, tags.output, outside);
  return {};
}

}  // namespace

std::optional<Repository> repository_of(const std::string& folder) {
  const ProcessResult git = run_git(folder, {"rev-parse", "--show-toplevel"});
  std::error_code failed;
  const fs::path top = fs::canonical(without_newline(git.output), failed);
  if (git.status == 0 && !failed) return Repository{top, std::nullopt};
  const std::string holder = holder_of_git(folder);
  if (holder.empty()) return std::nullopt;
  return Repository{holder, failure_of(holder, git)};
}

std::string git_top(const std::string& folder) {
  const std::optional<Repository> repository = repository_of(folder);
  return repository ? repository->top : "";
}

std::string source_root(const std::string& package_dir) {
  const std::string top = git_top(package_dir);
  if (!top.empty()) return top;
  std::error_code failed;
  const std::string here = std::filesystem::current_path(failed);
  return is_below(package_dir, here) ? here : package_dir;
}

Expected<OutsideGit> outside_git(const std::vector<std::string>& files) {
  // A package may hold another repository, such as a submodule.
  std::map<std::string, std::vector<std::string>> by_folder, by_top;
  for (const std::string& file : files) by_folder[fs::path(file).parent_path()].push_back(file);
  std::map<std::string, Repository> repositories;
  OutsideGit outside;
  for (const auto& [folder, inside] : by_folder) {
    const std::optional<Repository> repository = repository_of(folder);
    if (!repository) {
      outside.unheld.insert(inside.begin(), inside.end());
      continue;
    }
    std::vector<std::string>& list = by_top[repository->top];
    list.insert(list.end(), inside.begin(), inside.end());
    repositories.emplace(repository->top, *repository);
  }
  for (const auto& [top, inside] : by_top)
    if (Expected<void> asked = ask_repository(repositories.at(top), inside, outside); !asked)
      return asked.error();
  return outside;
}

std::string commit_of(const std::string& folder) {
  const ProcessResult git = run_git(folder, {"rev-parse", "--short=12", "HEAD"});
  const ProcessResult state = run_git(folder, {"status", "--porcelain=v1", "--", "."});
  if (git.status != 0 || state.status != 0) return "";
  return without_newline(git.output) + (state.output.empty() ? "" : " with uncommitted changes");
}

}  // namespace tzc::rewriter
