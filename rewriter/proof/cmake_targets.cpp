// SPDX-License-Identifier: BSD-3-Clause
#include "proof/cmake_targets.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "buildfiles/compile_database.h"
#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

json read_json(const fs::path& file) {
  const Expected<std::string> text = read_file(file);
  return text ? json::parse(*text) : json();
}

std::string file_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

CmakeTarget target_of(const json& document, const std::string& source_dir) {
  CmakeTarget target;
  target.name = document.at("name");
  target.type = document.at("type");
  target.product = document.value("nameOnDisk", "");
  for (const json& source : document.value("sources", json::array())) {
    const fs::path path = source.at("path").get<std::string>();
    target.sources.insert((path.is_absolute() ? path : source_dir / path).lexically_normal());
  }
  if (document.contains("link"))
    for (const json& fragment : document["link"].value("commandFragments", json::array()))
      for (const std::string& word : shell_words(fragment.at("fragment"))) target.linked.push_back(word);
  return target;
}

/// "NAME::@HASH" to "NAME".
std::string name_of_id(const std::string& id) {
  return id.substr(0, id.find("::@"));
}

std::vector<CmakeTarget> targets_in(const fs::path& reply) {
  std::vector<CmakeTarget> targets;
  for (const auto& entry : fs::directory_iterator(reply)) {
    if (entry.path().filename().string().rfind("codemodel-v2", 0) != 0) continue;
    const json model = read_json(entry.path());
    const std::string source_dir = model.at("paths").at("source");
    for (const json& of_configuration : model.at("configurations"))
      for (const json& reference : of_configuration.at("targets")) {
        const json document = read_json(reply / reference.at("jsonFile").get<std::string>());
        targets.push_back(target_of(document, source_dir));
        for (const json& needed : document.value("dependencies", json::array()))
          targets.back().made_before.insert(name_of_id(needed.at("id")));
      }
  }
  return targets;
}

bool takes_objects_of(const CmakeTarget& target, const CmakeTarget& objects) {
  return std::any_of(target.sources.begin(), target.sources.end(), [&](const std::string& source) {
    return source.find("/" + objects.name + ".dir/") != std::string::npos;
  });
}

}  // namespace

bool CmakeTarget::links(const std::string& library_prefix) const {
  return std::any_of(linked.begin(), linked.end(), [&](const std::string& word) {
    const std::string file = file_name(word);
    return file.rfind("lib" + library_prefix, 0) == 0 || file.rfind("-l" + library_prefix, 0) == 0;
  });
}

std::vector<CmakeTarget> read_cmake_targets(const std::string& build_dir) {
  const fs::path reply = build_dir + "/.cmake/api/v1/reply";
  if (!is_there(reply)) return {};
  try {
    return targets_in(reply);
  } catch (const json::exception&) {
    return {};
  }
}

std::vector<const CmakeTarget*> linked_with(const std::vector<CmakeTarget>& all, const CmakeTarget& target) {
  if (target.is_linked()) return {&target};
  std::vector<const CmakeTarget*> found;
  for (const CmakeTarget& other : all) {
    const bool links = std::any_of(other.linked.begin(), other.linked.end(), [&](const std::string& word) {
      return !target.product.empty() && file_name(word) == target.product;
    });
    if (other.is_linked() && (links || takes_objects_of(other, target))) found.push_back(&other);
  }
  return found;
}

}  // namespace tzc::rewriter
