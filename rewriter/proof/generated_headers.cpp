// SPDX-License-Identifier: BSD-3-Clause
#include "proof/generated_headers.h"

#include <filesystem>

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// "demo_msgs" of "tzc/demo_msgs/Cloud.h".
std::string package_of(const std::string& header) {
  return fs::path(header).parent_path().filename();
}

}  // namespace

std::set<std::string> included_headers(const std::string& text, const std::set<std::string>& headers) {
  std::set<std::string> included;
  for (const std::string& header : headers)
    for (const std::string& written : {"<" + header + ">", "\"" + header + "\""})
      if (text.find(written) != std::string::npos) included.insert(header);
  return included;
}

/// One that makes something in the header's folder, which is its package's: CMake's reply names a rule by the first of its outputs.
const CmakeTarget* GeneratedHeaders::maker_of(const std::string& path) const {
  const fs::path folder = fs::path(path).parent_path();
  for (const CmakeTarget& target : targets_)
    for (const std::string& source : target.sources)
      if (fs::path(source).parent_path() == folder) return &target;
  return nullptr;
}

std::set<std::string> GeneratedHeaders::made_before(const std::string& target) const {
  std::set<std::string> all, left = {target};
  while (!left.empty()) {
    const std::string next = *left.begin();
    left.erase(left.begin());
    if (!all.insert(next).second) continue;
    for (const CmakeTarget& one : targets_)
      if (one.name == next) left.insert(one.made_before.begin(), one.made_before.end());
  }
  return all;
}

/// The unit's own, and those of changed headers that it reads.
std::set<std::string> GeneratedHeaders::needed(const CompileCommand& command, const std::string& unit) const {
  std::set<std::string> needed;
  for (const auto& [file, text] : contents_) {
    std::set<std::string> of_file = included_headers(text, headers_);
    if (of_file.empty()) continue;
    if (file == unit || includes_any(command, {{file, text}}, to_user_, MissingHeaders::are_made))
      needed.merge(of_file);
  }
  return needed;
}

std::optional<Lack> GeneratedHeaders::lack_of_header(const CompileCommand& command,
                                                     const std::string& header) const {
  for (const std::string& folder : include_folders(command)) {
    const fs::path path = (fs::path(command.directory) / folder / header).lexically_normal();
    if (fs::exists(path)) return {};
    const CmakeTarget* maker = maker_of(path);
    if (!maker) continue;
    if (made_before(command.target).count(maker->name)) return {};
    return Lack{"nothing says that " + maker->name + " makes <" + header + "> before it",
                "add_dependencies(" + command.target + " " + maker->name + ") says so"};
  }
  return Lack{"nothing makes <" + header + ">, which it includes",
              "write tzc_generate_messages(" + package_of(header) + ") behind the command that finds catkin"};
}

std::optional<Lack> GeneratedHeaders::lack(const CompileCommand& command, const std::string& unit) const {
  if (headers_.empty() || targets_.empty()) return {};
  for (const std::string& header : needed(command, unit))
    if (std::optional<Lack> lack = lack_of_header(command, header)) return lack;
  return {};
}

}  // namespace tzc::rewriter
