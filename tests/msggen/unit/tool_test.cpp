// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tool_case.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Tool, generates_services_and_messages) {
  EXPECT_EQ(generate_files({write("msg/A.msg", "uint8[] x\n"), write("srv/B.srv", "A a\n---\n")}), exit_good)
      << err_.str();
  EXPECT_THAT(files_below("out"),
              ::testing::UnorderedElementsAre("tzc/demo/A.h", "tzc/demo/B.h", "tzc/demo/BRequest.h",
                                              "tzc/demo/BResponse.h"));
}

TEST_F(Tool, writes_nothing_when_one_file_of_many_is_bad) {
  const auto good = write("msg/A.msg", "uint8[] x\n"), bad = write("msg/B.msg", "uint8[ x\n");
  EXPECT_EQ(generate_files({good, bad}), exit_bad_input);
  EXPECT_FALSE(fs::exists(path("out")));
  EXPECT_THAT(err_.str(), HasSubstr("B.msg:1:6: error:"));
}

TEST_F(Tool, keeps_going_past_definitions_with_faults) {
  GenerateOptions options;
  options.package = "demo";
  options.output = path("out");
  options.keep_going = true;
  options.files = {write("msg/Bad.msg", "uint8 class\n"), write("msg/Uses.msg", "Bad bad\n"),
                   write("msg/Good.msg", "uint8[] x\n"), write("action/Two.action", "uint8 a\n---\n"),
                   write("srv/Ask.srv", "uint8 new\n---\nuint8 a\n")};
  EXPECT_EQ(generate(options, console_), exit_good);
  EXPECT_THAT(err_.str(), HasSubstr("Bad.msg:1:7: warning: the field's name 'class' is a C++ keyword"));
  EXPECT_THAT(err_.str(), Not(HasSubstr("error:")));
  EXPECT_THAT(read("out/tzc/demo/Bad.h"),
              HasSubstr("#error \"there is no TZC header of demo/Bad: Bad.msg:1: the field's name 'class'"));
  EXPECT_THAT(read("out/tzc/demo/Uses.h"), HasSubstr("#error"));
  EXPECT_THAT(read("out/tzc/demo/TwoActionGoal.h"), HasSubstr("#error"));
  EXPECT_THAT(read("out/tzc/demo/AskRequest.h"), HasSubstr("#error"));
  for (const char* name : {"Good", "Ask"})
    EXPECT_THAT(read(std::string("out/tzc/demo/") + name + ".h"), Not(HasSubstr("#error"))) << name;
}

/// An installed package that has declared messages and has none.
TEST_F(Tool, keeps_going_without_a_folder_that_nobody_needs) {
  GenerateOptions options;
  options.package = "demo";
  options.output = path("out");
  options.includes = {"empty_msgs:" + path("no/such/folder")};
  options.files = {write("msg/Good.msg", "uint8[] x\n"), write("msg/Uses.msg", "empty_msgs/Part part\n")};
  EXPECT_EQ(generate(options, console_), exit_usage);
  EXPECT_THAT(err_.str(), HasSubstr("no such folder"));
  options.keep_going = true;
  EXPECT_EQ(generate(options, console_), exit_good);
  EXPECT_THAT(read("out/tzc/demo/Good.h"), Not(HasSubstr("#error")));
  EXPECT_THAT(read("out/tzc/demo/Uses.h"), HasSubstr("#error"));
}

TEST_F(Tool, does_not_keep_going_past_files_that_are_no_definitions) {
  GenerateOptions options;
  options.package = "demo";
  options.output = path("out");
  options.keep_going = true;
  for (const std::string& file : {path("msg/Nowhere.msg"), write("README.txt", "uint8 a\n")}) {
    options.files = {write("msg/Good.msg", "uint8[] x\n"), file};
    EXPECT_EQ(generate(options, console_), exit_bad_input) << file;
    EXPECT_FALSE(fs::exists(path("out"))) << file;
  }
}

TEST_F(Tool, what_was_there_survives_a_bad_run) {
  generate_files({write("msg/A.msg", "uint8[] x\n")});
  const std::string before = read("out/tzc/demo/A.h");
  generate_files({write("msg/A.msg", "uint16[] x\n"), write("msg/B.msg", "?")});
  EXPECT_EQ(read("out/tzc/demo/A.h"), before);
}

TEST_F(Tool, an_output_that_cannot_be_written_leaves_nothing_behind) {
  write("out/tzc", "a file where a folder should be");
  EXPECT_EQ(generate_files({write("msg/A.msg", "uint8[] x\n")}), exit_bad_input);
  EXPECT_THAT(err_.str(), HasSubstr("cannot create"));
  EXPECT_THAT(files_below("out"), ::testing::ElementsAre("tzc"));
}

TEST_F(Tool, a_folder_that_is_named_like_a_definition_is_named) {
  fs::create_directories(path("Folder.msg"));
  EXPECT_EQ(generate_files({path("Folder.msg")}), exit_bad_input);
  EXPECT_THAT(err_.str(), AllOf(HasSubstr("Folder.msg"), HasSubstr("Is a directory")));
}

TEST_F(Tool, if_changed_leaves_files_alone_and_otherwise_their_time_is_new) {
  const auto file = write("msg/A.msg", "uint8[] x\n");
  generate_files({file});
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(path("out/tzc/demo/A.h"), old);
  generate_files({file}, true);
  EXPECT_EQ(fs::last_write_time(path("out/tzc/demo/A.h")), old);
  generate_files({file}, false);
  EXPECT_NE(fs::last_write_time(path("out/tzc/demo/A.h")), old);
}

TEST_F(Tool, census_of_several_packages) {
  write("src/stack/one/package.xml", "<package><name>one_msgs</name></package>");
  write("src/stack/one/msg/A.msg", "uint8[] x\ntwo/B[] y\nstring[] z\n");
  write("src/two/msg/B.msg", "float32 f\n");
  write("src/two/srv/C.srv", "one_msgs/A a\n---\nstring[] s\n");
  write("src/two/msg/D.msg", "missing_msgs/X x\n");
  const auto json = census({path("src")});
  EXPECT_EQ(json["types"]["one_msgs/A"]["data_fields"], nlohmann::json({"x", "y"}));
  EXPECT_EQ(json["types"]["two/B"]["fixed_length"], true);
  EXPECT_EQ(json["types"]["two/CRequest"]["data_fields"], nlohmann::json({"a.x", "a.y"}));
  EXPECT_EQ(json["types"]["two/CResponse"]["has_variable_array"], true);
  EXPECT_EQ(json["types"]["two/CResponse"]["needs_support"], true);  // its former name
  EXPECT_EQ(json["totals"], nlohmann::json({{"types", 4},
                                            {"has_variable_array", 3},
                                            {"has_data_part", 2},
                                            {"needs_support", 3},
                                            {"supported", 2},
                                            {"unsupported", 1}}));
  EXPECT_EQ(json["unresolved"], nlohmann::json({"two/D"}));
  EXPECT_THAT(err_.str(), HasSubstr("unknown package 'missing_msgs'"));
}

TEST_F(Tool, census_of_one_package_and_of_single_files) {
  const auto file = write("pkg/msg/A.msg", "B[] b\n");
  write("pkg/msg/B.msg", "uint8 x\n");
  fs::create_directories(path("empty"));
  EXPECT_EQ(census({path("pkg"), path("empty")})["totals"]["types"], 2);
  out_.str("");
  EXPECT_EQ(census({file})["types"]["pkg/A"]["data_fields"], nlohmann::json({"b"}));
  out_.str("");
  EXPECT_EQ(census({path("pkg/msg")})["types"].size(), 2u);
}

TEST_F(Tool, census_of_a_folder_inside_msg_knows_its_package) {
  write("pkg/package.xml", "<package><name>some_msgs</name></package>");
  write("pkg/msg/B.msg", "uint8 x\n");
  const auto file = write("pkg/msg/part/A.msg", "B[] b\n");
  for (const std::string& input : {path("pkg/msg/part"), file}) {
    EXPECT_EQ(census({input})["types"]["some_msgs/A"]["data_fields"], nlohmann::json({"b"})) << err_.str();
    out_.str("");
  }
  fs::remove(path("pkg/package.xml"));
  EXPECT_EQ(census({file})["types"].begin().key(), "pkg/A");
}

TEST_F(Tool, a_file_in_no_package_belongs_to_its_folder) {
  EXPECT_EQ(census({write("loose/A.msg", "uint8 x\n")})["types"].begin().key(), "loose/A");
}

TEST_F(Tool, census_with_nothing_to_count_is_bad_usage) {
  fs::create_directories(path("empty"));
  ClassifyOptions options;
  options.inputs = {path("empty"), path("nowhere")};
  EXPECT_EQ(classify(options, console_), exit_usage);
  EXPECT_THAT(err_.str(), HasSubstr("no message definitions"));
  EXPECT_THAT(err_.str(), HasSubstr("no such file or folder"));
}

TEST_F(Tool, explain_marks_each_field) {
  write("d/Cloud.msg", "Point[] points\nstring name\n");
  write("d/Point.msg", "uint8 kind\nfloat32 x\n");
  EXPECT_EQ(explain({{"demo:" + path("d")}, "demo/Cloud"}, console_), exit_good);
  EXPECT_EQ(out_.str(),
            "demo/Cloud  (md5 7a4f6d705f708ef46a77fe7e99ab3562)\n"
            "  has a data part: points\n"
            "  data     demo/Point[] points  8 bytes per element, 5 bytes on the wire\n"
            "  data       uint8 kind         1 byte\n"
            "  data       float32 x          4 bytes\n"
            "  control  string name          at least 4 bytes\n");
}

TEST_F(Tool, explain_with_a_folder_that_is_not_there_is_bad_usage) {
  write("d/A.msg", "uint8 x\n");
  for (const char* include : {"nope", "other:/no/such/folder"}) {
    EXPECT_EQ(explain({{include, "demo:" + path("d")}, "demo/A"}, console_), exit_usage) << include;
    EXPECT_EQ(out_.str(), "");
    EXPECT_THAT(err_.str(), HasSubstr(include));
  }
}

TEST_F(Tool, explain_takes_services) {
  write("srv/Ask.srv", "uint8[] q\n---\nbool a\n");
  fs::create_directories(path("msg"));
  EXPECT_EQ(explain({{"demo:" + path("msg")}, "demo/Ask"}, console_), exit_good) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("demo/Ask  (service, md5 "));
  EXPECT_THAT(out_.str(), HasSubstr("demo/AskResponse  (md5 "));
}

}  // namespace
}  // namespace tzc::msggen::test
