// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "support/temp_dir.h"

namespace tzc::command_line::test {
namespace {

using testing::HasSubstr;

std::string fault(const CLI::Validator& validator, std::string text) {
  return validator(text);
}

TEST(NumberBetween, takes_its_range_and_nothing_else) {
  const CLI::Validator seconds = number_between(0.1, 3600);
  for (const char* good : {"0.1", "1", "1e3", "3600"}) EXPECT_EQ(fault(seconds, good), "") << good;
  for (const char* bad : {"0", "-1", "3601", "inf", "nan", "NAN", "-nan", "nan(1)", "much", "1s", ""})
    EXPECT_NE(fault(seconds, bad), "") << bad;
}

TEST(SizeInBytes, is_never_negative) {
  const CLI::Validator size = size_in_bytes();
  std::string text = "4k";
  EXPECT_EQ(size(text), "");
  EXPECT_EQ(text, "4096");
  for (const char* bad : {"-5", "-1k", "many", "99999999999999999999", "17e", ""})
    EXPECT_NE(fault(size, bad), "") << bad;
}

TEST(FileToWrite, exists_or_can_be_made) {
  const tzc::test::TempDir folder;
  folder.write("there", "old");
  EXPECT_EQ(fault(file_to_write(), folder / "there"), "");
  EXPECT_EQ(fault(file_to_write(), folder / "new"), "");
  EXPECT_EQ(fault(file_to_write(), "in_the_working_directory"), "");
}

TEST(FileToWrite, is_no_folder_and_in_no_folder_that_is_missing) {
  const tzc::test::TempDir folder;
  EXPECT_THAT(fault(file_to_write(), folder / ""), HasSubstr("is a folder"));
  EXPECT_THAT(fault(file_to_write(), folder / "none/new"), HasSubstr("cannot be written: No such file"));
  EXPECT_THAT(fault(file_to_write(), "-"), HasSubstr("standard output"));
}

/// The exit status, -1: the program goes on; and the value of --rate.
std::pair<int, double> status_and_rate(std::vector<const char*> arguments) {
  CLI::App app("a program", "program");
  double rate = 1;
  app.add_option("--rate", rate)->check(number_between(0, 10));
  app.callback([&] {
    if (rate == 7) throw CLI::ValidationError("--rate", "7 is taken");
  });
  arguments.insert(arguments.begin(), "program");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto over = parse(app, static_cast<int>(arguments.size()), arguments.data());
  testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  return {over.value_or(-1), rate};
}

TEST(Parse, sets_options_or_ends_the_command) {
  EXPECT_EQ(status_and_rate({"--rate", "3"}), std::make_pair(-1, 3.0));
  EXPECT_EQ(status_and_rate({"--rate=3"}), std::make_pair(-1, 3.0));
  EXPECT_EQ(status_and_rate({"--help"}).first, 0);
  for (const char* mistake : {"--rate=nan", "--rate=11", "--rat=1", "--rate", "--rate=7", "more"})
    EXPECT_EQ(status_and_rate({mistake}).first, 2) << mistake;
}

TEST(Parse, does_not_take_the_next_argument_for_an_empty_value) {
  EXPECT_EQ(status_and_rate({"--rate=", "3"}).first, 2);
}

TEST(Parse, refuses_an_empty_value) {
  EXPECT_EQ(status_and_rate({"--rate", ""}).first, 2);
}

std::string incomplete(std::vector<const char*> arguments) {
  return why_incomplete(static_cast<int>(arguments.size()), arguments.data());
}

TEST(WhyIncomplete, ends_where_options_do) {
  EXPECT_EQ(incomplete({"program", "--a=b", "x=", "--", "--c=", ""}), "");
  EXPECT_EQ(incomplete({"program", "--a=b", "--c="}), "--c=: a value is missing behind the '='");
  EXPECT_EQ(incomplete({"program", "--a", ""}), "an argument is empty, behind '--a'");
}

}  // namespace
}  // namespace tzc::command_line::test
