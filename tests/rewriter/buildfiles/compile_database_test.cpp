// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/compile_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ResponseFiles : public ::testing::Test {
 protected:
  CompileCommand command(const std::string& text) const {
    folder_.write(
        "build/compile_commands.json",
        nlohmann::json::array({{{"directory", folder_ / "build"}, {"file", "x.cpp"}, {"command", text}}})
            .dump());
    return read_compile_commands(folder_ / "build")->at(0);
  }
  tzc::test::TempDir folder_;
};

TEST_F(ResponseFiles, are_read_from_the_folder_of_the_command) {
  folder_.write("build/all.rsp", "-I/one \"-DA=b c\"\n@more.rsp\n");
  folder_.write("build/more.rsp", "-I/two");
  const CompileCommand found = command("c++ @all.rsp -o CMakeFiles/x.dir/x.o -c x.cpp");
  EXPECT_THAT(found.arguments,
              ElementsAre("c++", "-I/one", "-DA=b c", "-I/two", "-o", "CMakeFiles/x.dir/x.o", "-c", "x.cpp"));
  EXPECT_EQ(found.target, "x");
  EXPECT_THAT(found.response_files, ElementsAre(folder_ / "build/all.rsp", folder_ / "build/more.rsp"));
}

TEST_F(ResponseFiles, that_are_not_there_are_words) {
  const CompileCommand found = command("c++ @none.rsp -c x.cpp");
  EXPECT_THAT(found.arguments, ElementsAre("c++", "@none.rsp", "-c", "x.cpp"));
  EXPECT_THAT(found.response_files, IsEmpty());
}

TEST_F(ResponseFiles, that_name_themselves_have_an_end) {
  folder_.write("build/self.rsp", "-DX @self.rsp");
  EXPECT_LT(command("c++ @self.rsp -c x.cpp").arguments.size(), 20u);
}

}  // namespace
}  // namespace tzc::rewriter
