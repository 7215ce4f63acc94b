// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tzc::rewriter::test {

/// A test case as one text file: lines before the first header are its comment, "=== NAME" starts a section.
class CaseFile {
 public:
  explicit CaseFile(const std::string& path) : path_(path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      if (line.rfind("=== ", 0) == 0)
        sections_.push_back({line.substr(4), ""});
      else
        (sections_.empty() ? comment_ : sections_.back().second) += line + "\n";
    }
  }

  const std::vector<std::pair<std::string, std::string>>& sections() const { return sections_; }

  std::string section(const std::string& name) const {
    for (const auto& [title, text] : sections_)
      if (title == name) return text;
    return "";
  }

  /// With TZC_REGENERATE in the environment the file gets `actual` as its section "expected"; returns what to
  /// compare with.
  std::string expected(const std::string& actual) {
    if (!std::getenv("TZC_REGENERATE")) return section("expected");
    std::ofstream file(path_);
    file << comment_;
    for (const auto& [title, text] : sections_)
      if (title != "expected") file << "=== " << title << "\n" << text;
    file << "=== expected\n" << actual;
    return actual;
  }

  static std::vector<std::string> all(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".case") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::string path_, comment_;
  std::vector<std::pair<std::string, std::string>> sections_;
};

}  // namespace tzc::rewriter::test
