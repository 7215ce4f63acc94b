// SPDX-License-Identifier: BSD-3-Clause
#include "proof/cmake_reads.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// CMake's own modules lie beside hundreds that are not read.
bool is_of_a_package(const fs::path& file) {
  return file.parent_path().filename() == "cmake";
}

void note_inputs(const json& document, const PathMap& to_user, FileAccesses& accesses) {
  const fs::path source = document.at("paths").at("source").get<std::string>();
  const std::string build = document.at("paths").at("build");
  for (const json& input : document.at("inputs")) {
    const std::string file = (source / input.at("path").get<std::string>()).lexically_normal();
    if (input.value("isGenerated", false) || is_below(file, build)) continue;
    const std::string named = to_user.in_word(file);
    accesses.note(named);
    if (named == file && is_of_a_package(named)) accesses.note(fs::path(named).parent_path(), Access::tree);
  }
}

}  // namespace

void note_cmake_reads(const std::string& build_dir, const PathMap& to_user, FileAccesses& accesses) {
  std::error_code failed;
  bool found = false;
  try {
    for (fs::directory_iterator at(build_dir + "/.cmake/api/v1/reply", failed), end; !failed && at != end;
         at.increment(failed)) {
      if (at->path().filename().string().rfind("cmakeFiles-v1", 0) != 0) continue;
      const Expected<std::string> text = read_file(at->path());
      if (!text) break;
      note_inputs(json::parse(*text), to_user, accesses);
      found = true;
    }
  } catch (const json::exception&) {
    found = false;
  }
  if (!found) accesses.give_up();
}

}  // namespace tzc::rewriter
