// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tzc::test {

/// True while golden files are written instead of compared: TZC_UPDATE_GOLDEN=1 in the environment, the one switch of
/// all golden tests.
inline bool updates_golden() {
  const char* value = std::getenv("TZC_UPDATE_GOLDEN");
  return value && std::string(value) == "1";
}

inline std::string read_golden(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

inline void write_golden(const std::string& path, const std::string& content) {
  if (!(std::ofstream(path, std::ios::binary) << content))
    throw std::runtime_error(path + ": cannot be written");
}

/// The content of a golden file, to compare `actual` with. While golden files are updated it is `actual`.
inline std::string golden_file(const std::string& path, const std::string& actual) {
  if (updates_golden()) write_golden(path, actual);
  return read_golden(path);
}

/// A test case as one text file, in the grammar of LLVM's split-file: a line `//--- NAME` or `#--- NAME` starts the
/// section NAME; the text before the first of them is the head. The last section is `expected`.
class GoldenCase {
 public:
  using Section = std::pair<std::string, std::string>;  ///< name, text

  /// Throws when the last section is not `expected`: such a case would compare nothing.
  explicit GoldenCase(std::string path) : path_(std::move(path)) {
    std::istringstream lines(read_golden(path_));
    for (std::string line; std::getline(lines, line);) add(line);
    if (sections_.empty() || sections_.back().first != "expected")
      throw std::runtime_error(path_ + ": the last section must be `--- expected`");
    expected_ = sections_.back().second;
    sections_.pop_back();
  }

  const std::string& path() const { return path_; }
  const std::string& head() const { return head_; }
  /// All sections but `expected`, in the order of the file.
  const std::vector<Section>& sections() const { return sections_; }

  /// The text of a section; empty when there is none of that name.
  std::string section(const std::string& name) const {
    for (const auto& [title, text] : sections_)
      if (title == name) return text;
    return "";
  }

  const std::string& expected() const { return expected_; }

  /// What to compare `actual` with. While golden files are updated it is `actual`, and the file gets it.
  std::string expected(const std::string& actual) const {
    if (!updates_golden()) return expected_;
    write_golden(path_, input_ + actual);
    return actual;
  }

  /// The cases below a folder: their paths, sorted.
  static std::vector<std::string> all(const std::string& folder, const std::string& extension) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == extension) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  /// A case's path below the folder, without its extension, as a name that gtest accepts.
  static std::string test_name(const std::string& folder, const std::string& path) {
    std::string name = std::filesystem::relative(path, folder).replace_extension().string();
    std::replace_if(name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
  }

 private:
  void add(const std::string& line) {
    const bool in_expected = !sections_.empty() && sections_.back().first == "expected";
    if (!in_expected) input_ += line + "\n";
    if (line.rfind("//--- ", 0) == 0 || line.rfind("#--- ", 0) == 0)
      sections_.push_back({line.substr(line.find(' ') + 1), ""});
    else
      (sections_.empty() ? head_ : sections_.back().second) += line + "\n";
  }

  std::string path_, head_, input_, expected_;
  std::vector<Section> sections_;
};

}  // namespace tzc::test
