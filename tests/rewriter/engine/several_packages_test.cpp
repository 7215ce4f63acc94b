// SPDX-License-Identifier: BSD-3-Clause
// Packages that are solved as one: an interface between them changes with all that use it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "golden/case.h"

namespace tzc::rewriter {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

const char* const header = "lib/include/lib/fill.h";
const std::string ros_headers = "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n";

struct Steps : Progress {
  void step(const std::string& stage, unsigned, unsigned of, const std::string& what) override {
    units[stage] = of;
    if (stage.rfind("parsing", 0) == 0) ++parses[what];
  }
  std::map<std::string, unsigned> units;   ///< of each stage
  std::map<std::string, unsigned> parses;  ///< of each unit
};

/// A converter that a library exports, a node of another package that publishes what it fills, and a package that has
/// nothing to do with them.
class SeveralPackages : public ::testing::Test {
 protected:
  std::map<std::string, std::string> files = {
      {header, "#pragma once\n#include <sensor_msgs/Image.h>\nvoid fill(sensor_msgs::Image& image);\n"},
      {"lib/src/fill.cpp",
       "#include \"../include/lib/fill.h\"\nvoid fill(sensor_msgs::Image& image) { image.data.resize(10); "
       "}\n"},
      {"node/src/node.cpp", "#include \"../../lib/include/lib/fill.h\"\n" + ros_headers +
                                "void step(ros::NodeHandle& nh) {\n"
                                "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n"
                                "  sensor_msgs::Image image;\n  fill(image);\n  pub.publish(image);\n}\n"},
      {"other/src/other.cpp",
       ros_headers + "void step(ros::NodeHandle& nh) {\n"
                     "  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(\"other\", 10);\n"
                     "  sensor_msgs::Image image;\n  image.data.resize(10);\n  pub.publish(image);\n}\n"}};

  Expected<PortPlans> plan(const std::vector<std::string>& packages,
                           const std::set<std::string>& headers_in_use = {}) {
    written.emplace(files);
    EngineOptions options = written->options({});
    options.build_dirs.clear();
    std::vector<std::string> folders;
    for (const std::string& package : packages) {
      folders.push_back(folder(package));
      if (package != headers_only) options.build_dirs[folder(package)] = folder("build");
    }
    options.packages = FolderSet(folders);
    options.others.headers_in_use.emplace();
    for (const std::string& name : headers_in_use) options.others.headers_in_use->insert(folder(name));
    options.judges = judges;
    options.progress = &progress;
    if (!used_later.empty())
      options.others.more_headers_in_use = [this](const UnitsOfFile& units) {
        EXPECT_EQ(units.count(folder(used_later)), 1u);
        return std::set<std::string>{folder(used_later)};
      };
    for (const auto& [name, definition] : copied) {
      const std::size_t begin = files.at(name).find(definition);
      options.others.copied.push_back({folder(name), begin, begin + definition.size(), "/ws/src/copy.h"});
    }
    return plan_ports(options);
  }
  std::string folder(const std::string& name) const { return written->dir() + "/" + name; }

  static Level level(const PortPlan& plan) {
    for (const Site& site : plan.report.sites)
      if (site.kind == SiteKind::publish) return site.level;
    return Level::plain;
  }

  std::optional<test::Package> written;
  std::string headers_only, used_later;
  Steps progress;
  std::map<std::string, std::string> copied;  ///< file -> a definition of it that another package holds, too
  Judges judges;
};

TEST_F(SeveralPackages, one_name_for_different_things_in_two_programs_changes_neither) {
  files["node/src/publisher.cpp"] = ros_headers +
                                    "ros::Publisher out;\nvoid open(ros::NodeHandle& nh) {\n"
                                    "  out = nh.advertise<sensor_msgs::Image>(\"out\", 10);\n}\n";
  files["node/src/node.cpp"] =
      ros_headers +
      "ros::Publisher pub;\nsensor_msgs::Image out;\nvoid step() {\n"
      "  uint8_t* pixels = &out.data[0];\n  pub.publish(out);\n  pixels[0] = 1;\n}\n"
      "void open(ros::NodeHandle& nh, int) { pub = nh.advertise<sensor_msgs::Image>(\"a\", 1); }\n";
  const auto plans = plan({"node"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  const PortPlan& node = plans->at(folder("node"));
  EXPECT_EQ(level(node), Level::one_copy);
  for (const auto& [file, content] : node.contents)
    EXPECT_THAT(content, ::testing::Not(HasSubstr("allocate"))) << file;
}

TEST_F(SeveralPackages, a_converter_changes_with_its_caller) {
  const auto plans = plan({"lib", "node", "other"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  const PortPlan &lib = plans->at(folder("lib")), &node = plans->at(folder("node")),
                 &other = plans->at(folder("other"));
  EXPECT_EQ(level(node), Level::zero_copy);
  EXPECT_THAT(lib.contents.at(folder(header)), HasSubstr("tzc::sensor_msgs::Image& image"));
  EXPECT_EQ(lib.contents.count(folder("lib/src/fill.cpp")), 1u);
  EXPECT_EQ(lib.contents.count(folder("node/src/node.cpp")), 0u);
  EXPECT_THAT(lib.joined, ElementsAre(folder("node")));
  EXPECT_THAT(node.joined, ElementsAre(folder("lib")));
  EXPECT_THAT(other.joined, IsEmpty()) << "what it changes does not depend on them";
  EXPECT_EQ(level(other), Level::zero_copy);
}

TEST_F(SeveralPackages, one_that_has_nothing_but_headers_changes_with_who_includes_them) {
  files.erase("lib/src/fill.cpp");
  files[header] =
      "#pragma once\n#include <sensor_msgs/Image.h>\n"
      "inline void fill(sensor_msgs::Image& image) { image.data.resize(10); }\n";
  headers_only = "lib";
  const auto plans = plan({"lib", "node"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  const PortPlan &lib = plans->at(folder("lib")), &node = plans->at(folder("node"));
  EXPECT_EQ(level(node), Level::zero_copy);
  EXPECT_THAT(lib.contents.at(folder(header)), HasSubstr("tzc::sensor_msgs::Image& image"));
  EXPECT_THAT(lib.joined, ElementsAre(folder("node")));
  EXPECT_THAT(lib.ported_targets_files, IsEmpty());
}

TEST_F(SeveralPackages, a_definition_that_another_package_holds_too_stays_with_what_belongs_to_it) {
  const std::string holder =
      "struct Holder {\n  ros::Publisher pub;\n"
      "  void send() {\n    sensor_msgs::Image image;\n    image.data.resize(10);\n    pub.publish(image);\n "
      " }\n};\n";
  files["node/src/holder.h"] = ros_headers + holder;
  files["node/src/node.cpp"] =
      "#include \"holder.h\"\nvoid step(ros::NodeHandle& nh) {\n  Holder holder;\n"
      "  holder.pub = nh.advertise<sensor_msgs::Image>(\"image\", 10);\n  holder.send();\n}\n";
  const auto ported = plan({"node"});
  ASSERT_TRUE(ported) << to_string(ported.error());
  EXPECT_EQ(level(ported->at(folder("node"))), Level::zero_copy);
  copied["node/src/holder.h"] = holder;
  const auto kept = plan({"node"});
  ASSERT_TRUE(kept) << to_string(kept.error());
  EXPECT_EQ(level(kept->at(folder("node"))), Level::one_copy);
  EXPECT_THAT(kept->at(folder("node")).contents,
              ElementsAre(Pair(folder("node/src/node.cpp"), HasSubstr("holder.pub = tzc::attached<"))));
  EXPECT_THAT(kept->at(folder("node")).report.sites.back().reason, HasSubstr("/ws/src/copy.h"));
}

TEST_F(SeveralPackages, each_has_what_its_own_report_and_build_files_need) {
  const auto plans = plan({"lib", "node", "other"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  const PortPlan &lib = plans->at(folder("lib")), &node = plans->at(folder("node"));
  EXPECT_THAT(lib.ported_targets_files, ElementsAre(folder("lib/src/fill.cpp")));
  EXPECT_THAT(node.ported_targets_files, ElementsAre(folder("node/src/node.cpp")));
  EXPECT_THAT(lib.tzc_types, ElementsAre("sensor_msgs/Image"));
  EXPECT_THAT(node.tzc_types, Contains("sensor_msgs/Image"));
  EXPECT_THAT(lib.report.sites, IsEmpty());
  EXPECT_EQ(node.report.sites.size(), 2u);
  for (const char* name : {"node", "other"}) {
    const auto alone = plan({name});
    const auto together = plan({"lib", "node", "other"});
    ASSERT_TRUE(alone && together);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(alone->begin()->second.report.sites[i].id, together->at(folder(name)).report.sites[i].id);
  }
}

TEST_F(SeveralPackages, alone_the_caller_has_to_copy) {
  const auto plans = plan({"node"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  EXPECT_EQ(level(plans->at(folder("node"))), Level::one_copy);
}

TEST_F(SeveralPackages, a_header_that_others_include_stays) {
  const auto plans = plan({"lib", "node"}, {header});
  ASSERT_TRUE(plans) << to_string(plans.error());
  EXPECT_EQ(level(plans->at(folder("node"))), Level::one_copy);
  EXPECT_THAT(plans->at(folder("lib")).contents, IsEmpty());
  EXPECT_THAT(plans->at(folder("node")).joined, IsEmpty());
}

TEST_F(SeveralPackages, a_header_that_turns_out_to_be_in_use_stays_and_who_reads_it_is_read_again) {
  used_later = header;
  const auto plans = plan({"lib", "node", "other"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  EXPECT_EQ(level(plans->at(folder("node"))), Level::one_copy);
  EXPECT_THAT(plans->at(folder("lib")).contents, IsEmpty());
  EXPECT_EQ(level(plans->at(folder("other"))), Level::zero_copy);
  EXPECT_EQ(progress.units["parsing"], 3u);
  EXPECT_EQ(progress.units["parsing again"], 2u);
}

/// A node that holds a pointer while a shared pointer lets go, and a unit of that name, which shows that this may publish.
void add_deleter(std::map<std::string, std::string>& files, const std::string& unit) {
  files[unit] =
      "#include <memory>\nvoid send();\nvoid arm(std::shared_ptr<int>& guard) {\n"
      "  guard = std::shared_ptr<int>(new int(0), [](int* number) { send(); delete number; });\n}\n";
  files["node/src/node.cpp"] =
      "#include \"../../lib/include/lib/fill.h\"\n#include <memory>\n" + ros_headers +
      "ros::Publisher pub;\nsensor_msgs::Image image;\nvoid send() { pub.publish(image); }\n"
      "void open(ros::NodeHandle& nh) { pub = nh.advertise<sensor_msgs::Image>(\"image\", 10); }\n"
      "void step(std::shared_ptr<int>& guard) {\n  image = sensor_msgs::Image();\n  "
      "image.data.resize(100000);\n"
      "  uint8_t* first = &image.data[0];\n  guard.reset();\n  *first = 1;\n}\n";
}

TEST_F(SeveralPackages, what_a_unit_shows_holds_for_those_before_and_behind_it_and_none_is_read_again) {
  const std::map<std::string, std::string> without = files;
  for (const std::string unit : {"node/src/a.cpp", "node/src/z.cpp"}) {
    files = without;
    add_deleter(files, unit);
    progress.parses.clear();
    const auto plans = plan({"node"});
    ASSERT_TRUE(plans) << to_string(plans.error());
    EXPECT_EQ(level(plans->at(folder("node"))), Level::one_copy) << unit;
    EXPECT_EQ(progress.parses[folder("node/src/node.cpp")], 1u) << unit;
    EXPECT_EQ(progress.parses[folder(unit)], 1u);
  }
}

TEST_F(SeveralPackages, a_deleter_that_no_unit_shows_keeps_nothing) {
  add_deleter(files, "node/src/shows.cpp");
  files.erase("node/src/shows.cpp");
  const auto plans = plan({"node"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  EXPECT_EQ(level(plans->at(folder("node"))), Level::zero_copy);
}

TEST_F(SeveralPackages, who_only_reads_a_changed_header_has_to_know_tzc_too) {
  files["reader/src/reader.cpp"] = "#include \"../../lib/include/lib/fill.h\"\nint main() {}\n";
  const auto plans = plan({"lib", "node", "reader"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  const PortPlan& reader = plans->at(folder("reader"));
  EXPECT_THAT(reader.contents, IsEmpty());
  EXPECT_THAT(reader.ported_targets_files, ElementsAre(folder("reader/src/reader.cpp")));
  EXPECT_THAT(reader.joined, ElementsAre(folder("lib"), folder("node")));
}

TEST_F(SeveralPackages, a_use_that_would_not_compile_keeps_the_interface) {
  files["reader/src/reader.cpp"] =
      "#include \"../../lib/include/lib/fill.h\"\nvoid (*keep)(sensor_msgs::Image&) = &fill;\n";
  const auto plans = plan({"lib", "node", "reader"});
  ASSERT_TRUE(plans) << to_string(plans.error());
  EXPECT_THAT(plans->at(folder("lib")).contents, IsEmpty());
  EXPECT_EQ(level(plans->at(folder("node"))), Level::one_copy);
}

TEST_F(SeveralPackages, a_package_of_which_nothing_compiles_is_named) {
  files["node/src/node.cpp"] = "#error not here\n";
  judges.original_errors = [](const std::string& unit) {
    return std::vector<CompilerError>{{unit, {unit, 1, 1}, "not here", {}}};
  };
  const auto plans = plan({"lib", "node"});
  ASSERT_FALSE(plans);
  EXPECT_EQ(plans.error().where, folder("node/src/node.cpp"));
}

}  // namespace
}  // namespace tzc::rewriter
