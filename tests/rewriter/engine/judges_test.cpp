// SPDX-License-Identifier: BSD-3-Clause
// What the engine asks the judges of a port, and what it makes of their answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "edits/files.h"
#include "golden/case.h"

namespace tzc::rewriter {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string includes = "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n";

/// A function that publishes an image.
std::string publisher(const std::string& name) {
  return includes + "void " + name +
         "(ros::NodeHandle& nh) {\n  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"" + name +
         "\", 10);\n  sensor_msgs::Image image;\n  image.data.resize(10);\n  pub.publish(image);\n}\n";
}

class JudgesTest : public ::testing::Test {
 protected:
  Expected<PortPlan> plan(const std::map<std::string, std::string>& files) {
    package.emplace(files);
    return plan_again();
  }
  Expected<PortPlan> plan_again() {
    EngineOptions options = package->options({});
    options.judges = judges;
    options.strict = strict;
    options.jobs = jobs;
    return plan_port(options);
  }
  std::string path(const std::string& file) const { return package->dir() + "/" + file; }

  static std::string levels(const PortPlan& plan) {
    std::string text;
    for (const Site& site : plan.report.sites)
      if (site.kind == SiteKind::publish)
        text += (site.level == Level::zero_copy ? "zero_copy "
                 : site.level == Level::plain   ? "plain "
                                                : "one_copy ") +
                site.code + "\n";
    return text;
  }

  std::optional<test::Package> package;
  Judges judges;
  bool strict = false;
  unsigned jobs = 1;
};

TEST_F(JudgesTest, what_is_judged_is_what_is_written) {
  std::string judged;
  judges.written_text = [](const std::string&, const std::string&, const std::string& edited) {
    return edited + "// formatted\n";
  };
  judges.compiler = [&](const FileContents& contents, const std::set<std::string>&) {
    judged = contents.begin()->second;
    return std::vector<CompilerError>();
  };
  const auto port = plan({{"src/node.cpp", publisher("run")}});
  ASSERT_TRUE(port);
  EXPECT_THAT(judged, HasSubstr("// formatted"));
  EXPECT_EQ(port->contents.at(path("src/node.cpp")), judged);
}

/// Formatting may break what the edits alone would not.
TEST_F(JudgesTest, text_that_does_not_compile_is_noticed_although_the_edits_do) {
  judges.written_text = [](const std::string&, const std::string&, std::string edited) {
    const std::size_t at = edited.find("tzc::sensor_msgs::Image image");
    return at == std::string::npos ? edited : edited.insert(at, "not_a_type ");
  };
  const auto port = plan({{"src/node.cpp", publisher("run")}});
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_EQ(levels(*port), "one_copy TZC1009\n");
}

TEST_F(JudgesTest, the_compilers_errors_demote_what_stands_on_their_line) {
  judges.compiler = [&](const FileContents& contents, const std::set<std::string>& units) {
    std::vector<CompilerError> errors;
    for (const auto& [file, content] : contents) {
      const std::size_t at = content.find("tzc::sensor_msgs::Image image");
      if (at == std::string::npos || file != path("src/one.cpp")) continue;
      const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<long>(at), '\n');
      errors.push_back({*units.begin(), {file, static_cast<unsigned>(line), 1}, "GCC does not like it", {}});
    }
    return errors;
  };
  const auto port = plan({{"src/one.cpp", publisher("one")}, {"src/two.cpp", publisher("two")}});
  ASSERT_TRUE(port);
  EXPECT_EQ(levels(*port), "one_copy TZC1009\nzero_copy \n");
  EXPECT_THAT(port->report.sites[1].reason, HasSubstr("GCC does not like it"));
}

TEST_F(JudgesTest, a_unit_is_judged_again_only_when_its_text_changed) {
  std::vector<std::set<std::string>> asked;
  judges.compiler = [&](const FileContents& contents, const std::set<std::string>& units) {
    asked.push_back(units);
    std::vector<CompilerError> errors;
    const std::string one = path("src/one.cpp");
    if (contents.at(one).find("tzc::sensor_msgs::Image image") != std::string::npos)
      errors.push_back({one, {one, 0, 0}, "an error without a place", {}});
    return errors;
  };
  const auto port = plan({{"src/one.cpp", publisher("one")}, {"src/two.cpp", publisher("two")}});
  ASSERT_TRUE(port);
  EXPECT_EQ(levels(*port), "one_copy TZC1009\nzero_copy \n");
  ASSERT_FALSE(asked.empty());
  EXPECT_EQ(asked[0].size(), 2u);
  for (std::size_t i = 1; i < asked.size(); ++i) EXPECT_THAT(asked[i], ElementsAre(path("src/one.cpp"))) << i;
  EXPECT_LE(asked.size(), 5u);
}

/// An error without a place for each of these functions whose message is ported.
CompilerCheck rejects(const std::vector<std::string>& names, unsigned& rounds) {
  return [names, &rounds](const FileContents& contents, const std::set<std::string>&) {
    ++rounds;
    std::vector<CompilerError> errors;
    if (contents.empty()) return errors;
    const auto& [file, text] = *contents.begin();
    for (const std::string& name : names) {
      const std::size_t begin = text.find("void " + name + "(");
      const std::size_t end = text.find("\n}", begin);
      if (text.substr(begin, end - begin).find("tzc::sensor_msgs::Image image") != std::string::npos)
        errors.push_back({file, {file, 0, 0}, "no " + name, {}});
    }
    return errors;
  };
}

TEST_F(JudgesTest, of_several_errors_without_a_place_each_costs_its_own_message) {
  std::string unit = includes;
  for (const char* name : {"one", "two", "three", "four"}) unit += publisher(name).substr(includes.size());
  unsigned rounds = 0;
  judges.compiler = rejects({"one", "three"}, rounds);
  const auto port = plan({{"src/node.cpp", unit}});
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_EQ(levels(*port), "one_copy TZC1009\nzero_copy \none_copy TZC1009\nzero_copy \n");
  EXPECT_LE(rounds, 12u);
}

/// A compiler that stops at its first error would need a round for each message.
TEST_F(JudgesTest, many_errors_of_a_unit_end_in_few_rounds) {
  std::string unit = includes;
  for (int i = 0; i < 30; ++i) unit += publisher("run" + std::to_string(i)).substr(includes.size());
  unsigned rounds = 0;
  judges.compiler = [&](const FileContents& contents, const std::set<std::string>& units) {
    ++rounds;
    std::vector<CompilerError> errors;
    const std::string& content = contents.begin()->second;
    const std::size_t at = content.find("tzc::sensor_msgs::Image image");
    if (at == std::string::npos) return errors;
    const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<long>(at), '\n');
    errors.push_back({*units.begin(), {*units.begin(), static_cast<unsigned>(line), 1}, "no", {}});
    return errors;
  };
  const auto port = plan({{"src/node.cpp", unit}, {"src/other.cpp", publisher("other")}});
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_LE(rounds, 20u);
}

TEST_F(JudgesTest, however_many_units_have_errors_without_a_place_the_trials_are_linear) {
  constexpr unsigned units = 24, trials = 32 + units;
  std::map<std::string, std::string> files;
  for (unsigned i = 0; i < units; ++i) {
    std::string unit = includes;
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h"})
      unit += publisher(name + std::to_string(i)).substr(includes.size());
    files["src/node" + std::to_string(i) + ".cpp"] = unit;
  }
  unsigned judged = 0;
  judges.compiler = [&](const FileContents& contents, const std::set<std::string>& asked) {
    judged += asked.size();
    std::vector<CompilerError> errors;
    for (const std::string& unit : asked)
      if (const auto text = contents.find(unit);
          text != contents.end() && text->second.find("tzc::sensor_msgs::Image image") != std::string::npos)
        errors.push_back({unit, {unit, 0, 0}, "no", {}});
    return errors;
  };
  const auto port = plan(files);
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_THAT(levels(*port), Not(HasSubstr("zero_copy")));
  EXPECT_LE(judged, 10 * units + trials);
}

TEST_F(JudgesTest, a_unit_that_the_compiler_refuses_too_is_left_out) {
  judges.original_errors = [](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {unit, 1, 1}, "'missing' was not declared", {}}};
  };
  const std::map<std::string, std::string> files = {{"src/bad.cpp", publisher("bad") + "int x = missing;\n"},
                                                    {"src/good.cpp", publisher("good")}};
  const auto port = plan(files);
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_EQ(levels(*port), "zero_copy \n");
  ASSERT_EQ(port->report.notes.size(), 1u);
  EXPECT_EQ(port->report.notes[0].code, "TZC3003");
  EXPECT_THAT(port->report.notes[0].text, HasSubstr("'missing' was not declared"));
  EXPECT_THAT(port->report.notes[0].text, HasSubstr("possible sites in lines 4, 7"));
  strict = true;
  EXPECT_FALSE(plan(files));
}

TEST_F(JudgesTest, a_file_that_two_targets_compile_is_left_out_once) {
  judges.original_errors = [](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {unit, 1, 1}, "'missing' was not declared", {}}};
  };
  package.emplace(std::map<std::string, std::string>{{"src/bad.cpp", "int x = missing;\n"},
                                                     {"src/good.cpp", publisher("good")}});
  const std::string file = path("build/compile_commands.json"), text = *read_file(file);
  std::string second = text.substr(1, text.find('}'));  // of the first entry
  second.replace(second.find("c++ "), 4, "c++ -DSECOND ");
  ASSERT_TRUE(write_file(file, "[" + second + "," + text.substr(1)));
  const auto port = plan_again();
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_EQ(port->report.notes.size(), 1u);
}

/// Whichever thread is the fastest: the first unit takes long to read.
TEST_F(JudgesTest, units_that_do_not_parse_are_named_in_their_order) {
  judges.original_errors = [](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {unit, 1, 1}, "'missing' was not declared", {}}};
  };
  std::string slow;
  for (int i = 0; i < 20000; ++i) slow += "void f" + std::to_string(i) + "();\n";
  const std::map<std::string, std::string> files = {{"src/a.cpp", slow + "int x = missing;\n"},
                                                    {"src/b.cpp", "int x = missing;\n"},
                                                    {"src/good.cpp", publisher("good")}};
  jobs = 3;
  const auto port = plan(files);
  ASSERT_TRUE(port) << to_string(port.error());
  ASSERT_EQ(port->report.notes.size(), 2u);
  EXPECT_EQ(port->report.notes[0].where->file, path("src/a.cpp"));
  EXPECT_EQ(port->report.notes[1].where->file, path("src/b.cpp"));
  strict = true;
  const auto refused = plan(files);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().where, HasSubstr("src/a.cpp"));
}

TEST_F(JudgesTest, a_unit_that_only_clang_refuses_is_an_error) {
  judges.original_errors = [](const std::string&) { return std::vector<CompilerError>(); };
  const auto port = plan({{"src/bad.cpp", "int x = missing;\n"}, {"src/good.cpp", publisher("good")}});
  ASSERT_FALSE(port);
  EXPECT_THAT(port.error().what, HasSubstr("does not parse"));
}

TEST_F(JudgesTest, when_no_unit_compiles_that_is_an_error) {
  judges.original_errors = [](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {}, "no", {}}};
  };
  const auto port = plan({{"src/bad.cpp", "int x = missing;\n"}});
  ASSERT_FALSE(port);
  EXPECT_THAT(port.error().hint, Not(HasSubstr("Build the package"))) << "nothing is missing";
}

TEST_F(JudgesTest, the_hint_to_build_first_stands_at_missing_headers) {
  const std::string missing = "generated.h: No such file or directory";
  judges.original_errors = [&](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {}, missing, {}}};
  };
  const auto left_out = plan({{"src/bad.cpp", "#include \"generated.h\"\n"}});
  ASSERT_FALSE(left_out);
  EXPECT_THAT(left_out.error().hint, HasSubstr("Build the package first"));
  strict = true;
  const auto refused = plan({{"src/bad.cpp", "#include \"generated.h\"\n"}});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().hint, HasSubstr("Build the package first"));
  const auto other = plan({{"src/bad.cpp", "int x = missing;\n"}});
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().hint, Not(HasSubstr("Build the package")));
}

/// The build names the package by a symbolic link; the port is judged at that path, too.
TEST_F(JudgesTest, a_linked_package_is_judged_with_its_edits) {
  const std::string refused_by_clang =
      "#include <other/library.h>\nvoid run(ros::NodeHandle& nh) {\n"
      "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n"
      "  sensor_msgs::Image image;\n  other::decode(image.data);\n  pub.publish(image);\n}\n";
  package.emplace(std::map<std::string, std::string>{{"src/node.cpp", refused_by_clang}});
  EngineOptions options = package->options({});
  const auto real = plan_port(options);
  ASSERT_TRUE(real);
  const tzc::test::TempDir elsewhere;
  fs::create_directory_symlink(package->dir(), elsewhere / "linked");
  std::string commands = *read_file(path("build/compile_commands.json"));
  const std::string named = path("src/node.cpp");
  for (std::size_t at; (at = commands.find(named)) != std::string::npos;)
    commands.replace(at, named.size(), elsewhere / "linked/src/node.cpp");
  write_file(path("build/compile_commands.json"), commands).operator bool();
  const auto linked = plan_port(options);
  ASSERT_TRUE(linked) << to_string(linked.error());
  EXPECT_EQ(levels(*linked), levels(*real));
  EXPECT_EQ(levels(*linked), "one_copy TZC1009\n");
}

TEST_F(JudgesTest, a_unity_build) {
  package.emplace(std::map<std::string, std::string>{{"src/one.cpp", publisher("one")},
                                                     {"src/two.cpp", publisher("two")}});
  const std::string unity = path("build/demo/Unity/unity_0_cxx.cxx");
  fs::create_directories(fs::path(unity).parent_path());
  std::string commands = *read_file(path("build/compile_commands.json"));
  ASSERT_TRUE(write_file(
      unity, "#include \"" + path("src/one.cpp") + "\"\n#include \"" + path("src/two.cpp") + "\"\n"));
  const std::size_t second = commands.find("},{");
  commands = commands.substr(0, second) + "}]";
  for (std::size_t at; (at = commands.find(path("src/one.cpp"))) != std::string::npos;)
    commands.replace(at, path("src/one.cpp").size(), unity);
  ASSERT_TRUE(write_file(path("build/compile_commands.json"), commands));
  const auto port = plan_port(package->options({}));
  ASSERT_TRUE(port) << to_string(port.error());
  EXPECT_EQ(levels(*port), "zero_copy \nzero_copy \n");
  EXPECT_THAT(port->report.notes, IsEmpty());
  EXPECT_THAT(port->ported_targets_files, ElementsAre(unity));
}

}  // namespace
}  // namespace tzc::rewriter
