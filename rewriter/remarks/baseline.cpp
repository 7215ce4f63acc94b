// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/baseline.h"

#include <nlohmann/json.hpp>

#include "edits/files.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;

std::string key(const std::string& package, const std::string& id) {
  return package + " " + id;
}

}  // namespace

Expected<Baseline> Baseline::read(const std::string& file) {
  const Expected<std::string> text = read_file(file);
  if (!text) return Error{text.error().what, file, "write one with --report FILE.json"};
  Baseline baseline;
  try {
    const json document = json::parse(*text);
    const json packages = document.contains("packages") ? document["packages"] : json::array({document});
    for (const json& package : packages)
      for (const json& site : package.at("sites"))
        baseline.codes_[key(package.at("package"), site.at("id"))] = site.at("code");
  } catch (const json::exception&) {
    return Error{"is no report of tzc-rewrite", file, "write one with --report FILE.json"};
  }
  return baseline;
}

bool Baseline::accepts(const Report& report, const Site& site) const {
  const auto found = codes_.find(key(report.package, site.id));
  return found != codes_.end() && found->second == site.code;
}

}  // namespace tzc::rewriter
