// SPDX-License-Identifier: BSD-3-Clause
#include "proof/unit_needs.h"

#include <algorithm>
#include <filesystem>

#include "edits/files.h"
#include "edits/standard_flags.h"
#include "proof/compiler_reads.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Folders that compilers search by default.
const std::vector<std::string> default_folders = {"/usr/local/include", "/usr/include"};

bool sees_tzc(const CompileCommand& command) {
  const std::vector<std::string> folders = include_folders(command);
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    return !folder.empty() && is_there(fs::path(command.directory) / folder / "tzc/ros.h");
  });
}

/// The value of __cplusplus without a -std flag.
bool compiler_defaults_to_cxx14(const CompileCommand& command) {
  std::vector<std::string> words;
  for (const std::string& word : command.arguments) {
    if (word.rfind("-", 0) == 0) break;
    words.push_back(word);
  }
  words.insert(words.end(), {"-dM", "-E", "-x", "c++", "/dev/null"});
  const std::string output = run_process(words).output;
  const std::size_t at = output.find("__cplusplus ");
  return at != std::string::npos && std::atol(output.c_str() + at + 12) >= 201402L;
}

}  // namespace

std::string standard_of(const CompileCommand& command) {
  std::string flag;
  for (const std::string& word : command.arguments)
    if (is_standard_flag(word)) flag = word;
  return flag;
}

std::vector<std::string> include_folders(const CompileCommand& command) {
  std::vector<std::string> folders = default_folders;
  const auto& words = command.arguments;
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const std::string flag : {"-I", "-isystem", "-iquote", "-idirafter"}) {
      if (words[i] == flag && i + 1 < words.size())
        folders.push_back(words[i + 1]);
      else if (words[i].rfind(flag, 0) == 0)
        folders.push_back(words[i].substr(flag.size()));
    }
  return folders;
}

std::optional<Lack> lacks_standard(const CompileCommand& command) {
  static const char* const raise_it =
      "raise the standard there to C++14 or later, as in set(CMAKE_CXX_STANDARD 14), and run tzc-rewrite "
      "again";
  const std::string standard = standard_of(command);
  if (is_old_standard(standard))
    return Lack{"it is compiled with " + standard + ", TZC's headers need C++14", raise_it};
  if (standard.empty() && !compiler_defaults_to_cxx14(command))
    return Lack{
        "it is compiled as the compiler's default, which is older than the C++14 that TZC's headers need",
        raise_it};
  return {};
}

std::optional<Lack> lacks_for_tzc(const CompileCommand& command) {
  if (!sees_tzc(command)) return Lack{"TZC's headers are in none of its include folders", ""};
  return lacks_standard(command);
}

bool includes_any(const CompileCommand& command, const FileContents& files, const PathMap& to_user,
                  MissingHeaders missing) {
  Command run{without_outputs(command.arguments), command.directory, {}};
  run.arguments.push_back("-M");
  if (missing == MissingHeaders::are_made) run.arguments.push_back("-MG");
  const ProcessResult result = run_process(run);
  if (result.status != 0) return true;
  const std::vector<std::string> read = prerequisites_of(result.output);
  return std::any_of(read.begin(), read.end(), [&](const std::string& file) {
    const fs::path path = fs::path(command.directory) / file;
    return files.count(canonical_path(to_user.in_word(path.lexically_normal().string()))) != 0;
  });
}

const CmakeTarget* linked_without_tzc(const std::vector<CmakeTarget>& all, const std::string& target) {
  for (const CmakeTarget& one : all)
    if (one.name == target)
      for (const CmakeTarget* linked : linked_with(all, one))
        if (!linked->links("tzc_roscpp")) return linked;
  return nullptr;
}

}  // namespace tzc::rewriter
