// SPDX-License-Identifier: BSD-3-Clause
#include "paper/plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "temp_dir.h"

namespace {

using namespace tzc::bench;
using testing::HasSubstr;
using tzc::test::TempDir;

constexpr char whole_svg[] = "echo '<svg></svg>' > a.svg.tmp\n";
constexpr char whole_png[] = R"(printf 'PNG IEND\256\102\140\202' > a.png.tmp)";

/// gnuplot is played by a script that ends with status 0, whatever it has written.
struct Draw : testing::Test {
  Draw() {
    const char* const path = ::getenv("PATH");
    path_before = path != nullptr ? path : "";
    ::setenv("PATH", (tools.path() + ":" + path_before).c_str(), 1);
  }
  ~Draw() override { ::setenv("PATH", path_before.c_str(), 1); }

  void play(const std::string& script) {
    const std::string file = tools.write("gnuplot", "#!/bin/sh\n" + script);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  /// What draw says when it fails, without taking anything; empty: it does not.
  std::string failure() {
    try {
      draw(store, "a", "the script\n");
      return "";
    } catch (const StoreError& error) {
      for (const char* name : {"a.svg", "a.png", "a.svg.tmp", "a.png.tmp"})
        EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
      return error.what();
    }
  }

  std::string path_before;
  TempDir tools, folder;
  Store store{folder.path()};
};

TEST_F(Draw, takes_whole_files) {
  play(std::string(whole_svg) + whole_png);
  EXPECT_EQ(draw(store, "a", "the script\n"), "<svg></svg>\n");
  EXPECT_THAT(folder.read("a.png"), HasSubstr("IEND"));
}

TEST_F(Draw, refuses_half_an_svg) {
  play(std::string("echo '<svg><g>' > a.svg.tmp\n") + whole_png);
  EXPECT_THAT(failure(), HasSubstr("has not written all of " + store.path_of("a.svg")));
}

TEST_F(Draw, refuses_half_a_png) {
  play(std::string(whole_svg) + "printf 'PNG IDAT' > a.png.tmp");
  EXPECT_THAT(failure(), HasSubstr("has not written all of " + store.path_of("a.png")));
}

TEST_F(Draw, refuses_a_plot_that_is_not_there) {
  play("exit 0");
  EXPECT_THAT(failure(), HasSubstr("a.svg"));
}

TEST_F(Draw, leaves_the_users_own_settings_out) {
  play(std::string("[ \"$*\" = '-d a.gnuplot' ] || exit 1\n") + whole_svg + whole_png);
  EXPECT_EQ(failure(), "");
}

}  // namespace
