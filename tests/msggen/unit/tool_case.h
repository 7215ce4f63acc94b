// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A folder for a test's definitions and headers, and the tool's commands with what they print.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/temp_dir.h"
#include "tool/commands.h"

namespace tzc::msggen::test {

namespace fs = std::filesystem;

class Tool : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }
  std::string write(const std::string& name, const std::string& text) { return folder_.write(name, text); }
  std::string read(const std::string& name) const { return folder_.read(name); }
  std::vector<std::string> files_below(const std::string& name) const {
    std::vector<std::string> files;
    if (!fs::exists(path(name))) return files;
    for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
      if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(path(name)).string());
    }
    return files;
  }

  int generate_files(const std::vector<std::string>& files, bool if_changed = false) {
    GenerateOptions options;
    options.package = "demo";
    options.output = path("out");
    options.files = files;
    options.if_changed = if_changed;
    return generate(options, console_);
  }
  nlohmann::json census(const std::vector<std::string>& inputs, const std::string& package = "") {
    ClassifyOptions options;
    options.inputs = inputs;
    options.package = package;
    options.json = true;
    EXPECT_EQ(classify(options, console_), exit_good) << err_.str();
    return nlohmann::json::parse(out_.str());
  }

  tzc::test::TempDir folder_;
  std::ostringstream out_, err_;
  Console console_{out_, err_};
};

}  // namespace tzc::msggen::test
