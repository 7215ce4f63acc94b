// SPDX-License-Identifier: BSD-3-Clause
// What known_functions.def says of TZC's own functions and classes: under another name it would say nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace tzc::rewriter::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// The headers that users include as <tzc/...>.
std::vector<std::string> public_headers() {
  std::vector<std::string> headers;
  for (const auto& entry : fs::recursive_directory_iterator(TZC_SOURCES "/runtime"))
    if (entry.path().extension() == ".h" && entry.path().string().find("/include/tzc/") != std::string::npos)
      headers.push_back(content_of(entry.path()));
  return headers;
}

/// {"tzc", "image_transport", "subscribe"}, for each name of TZC.
std::vector<std::vector<std::string>> names_of_tzc() {
  static const std::regex entry("\\(\"(tzc::[^\"]*)\"\\)"), word("\\w+");
  const std::string table = content_of(TZC_SOURCES "/rewriter/facts/syntax/known_functions.def");
  std::vector<std::vector<std::string>> names;
  for (std::sregex_iterator one(table.begin(), table.end(), entry), end; one != end; ++one) {
    const std::string name = (*one)[1];
    names.emplace_back(std::sregex_token_iterator(name.begin(), name.end(), word),
                       std::sregex_token_iterator());
  }
  return names;
}

bool declares(const std::string& header, const std::vector<std::string>& name) {
  const auto has = [&](const std::string& text) { return header.find(text) != std::string::npos; };
  return std::all_of(name.begin(), name.end() - 1,
                     [&](const auto& space) { return has("namespace " + space); }) &&
         (has(" " + name.back() + "(") || has("class " + name.back()));
}

TEST(KnownFunctions, those_of_tzc_are_declared_in_its_headers) {
  const std::vector<std::string> headers = public_headers();
  const std::vector<std::vector<std::string>> names = names_of_tzc();
  EXPECT_GT(names.size(), 5u);
  for (const std::vector<std::string>& name : names)
    EXPECT_TRUE(std::any_of(headers.begin(), headers.end(),
                            [&](const std::string& header) { return declares(header, name); }))
        << "no header declares '" << name.back() << "'";
}

}  // namespace
}  // namespace tzc::rewriter::test
