// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/casts_elsewhere.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "edits/files.h"
#include "edits/source_text.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

class CastsElsewhereTest : public ::testing::Test {
 protected:
  CastsElsewhereTest() { package("demo"); }

  void package(const std::string& name) {
    folder_.write(name + "/package.xml", "<package><name>" + name + "</name></package>\n");
  }
  std::string put(const std::string& package, const std::string& file, const std::string& text) {
    this->package(package);
    return folder_.write(package + "/" + file, text);
  }
  /// What "demo" includes, and what its code says.
  void demo(const std::string& text) { folder_.write("demo/src/node.cpp", text); }

  std::string root() const { return canonical_path(folder_.path()); }
  IncludeGraph graph() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(root()))
      if (is_there(entry.path() / "package.xml")) all.push_back(entry.path());
    return IncludeGraph(FolderSet(all));
  }
  /// Their names, each with a space.
  std::string given() const {
    std::string names;
    for (const std::string& folder : packages_that_may_be_given(FolderSet(root() + "/demo"), graph(),
                                                                [](const std::string&) { return false; }))
      names += folder.substr(root().size() + 1) + " ";
    return names;
  }
  /// The line of a cast of an image in a file with this text; 0: there is none.
  unsigned cast_in(const std::string& text) {
    const std::string file = canonical_path(put("other", "src/other.cpp", text));
    const auto where = CastsElsewhere(FolderSet(root() + "/other"), {file}).of("sensor_msgs/Image");
    return where ? where->line : 0;
  }

  tzc::test::TempDir folder_;
};

TEST_F(CastsElsewhereTest, a_package_that_is_included_may_be_given_a_message_and_what_it_includes_too) {
  demo("#include <near/near.h>\n");
  put("near", "include/near/near.h", "");
  put("near", "src/near.cpp", "#include <far/far.h>\n");
  put("far", "include/far/far.h", "");
  put("stranger", "src/stranger.cpp", "#include <far/far.h>\n");
  EXPECT_EQ(given(), "far near ");
}

TEST_F(CastsElsewhereTest, so_may_one_that_includes_the_package_and_what_that_includes) {
  put("demo", "include/demo/base.h", "");
  put("user", "src/user.cpp", "#include <demo/base.h>\n#include <far/far.h>\n");
  put("far", "include/far/far.h", "");
  put("stranger", "src/stranger.cpp", "#include <far/far.h>\n");
  EXPECT_EQ(given(), "far user ");
}

TEST_F(CastsElsewhereTest, so_may_a_plugin_whose_base_it_includes_but_no_nodelet) {
  demo("#include <base/base.h>\n");
  put("base", "include/base/base.h", "");
  put("plugin", "src/plugin.cpp",
      "#include <base/base.h>\nPLUGINLIB_EXPORT_CLASS(plugin::Grow, base::Filter)\n");
  put("nodelet_of_another", "src/nodelet.cpp",
      "#include <base/base.h>\nPLUGINLIB_EXPORT_CLASS(another::Node, nodelet::Nodelet)\n");
  EXPECT_EQ(given(), "base plugin ");
}

TEST_F(CastsElsewhereTest, tzc_itself_does_not_count) {
  demo("#include <tzc/ros.h>\n");
  put("tzc", "include/tzc/ros.h", "");
  EXPECT_EQ(given(), "");
}

TEST_F(CastsElsewhereTest, casts_that_name_the_message) {
  EXPECT_EQ(
      cast_in("\nvoid f(const sensor_msgs::Image& m) { const_cast<sensor_msgs::Image&>(m).data.clear(); }\n"),
      2u);
  EXPECT_EQ(cast_in("auto p = boost::const_pointer_cast<sensor_msgs::Image>(m);\n"), 1u);
  EXPECT_EQ(cast_in("auto p = *(sensor_msgs::Image*)m.get();\n"), 1u);
  EXPECT_EQ(cast_in("f((Image&)*m);\n"), 1u);
  EXPECT_EQ(cast_in("ros::MessageEvent<Image const> e(event, false);\n"), 1u);
  EXPECT_EQ(cast_in("const_cast<sensor_msgs::Image_<std::allocator<void>>*>(m);\n"), 1u);
  EXPECT_EQ(cast_in("const_cast<boost::shared_ptr<sensor_msgs::Image>&>(m);\n"), 1u);
}

TEST_F(CastsElsewhereTest, casts_that_name_it_by_another_name) {
  EXPECT_EQ(cast_in("using Frame = sensor_msgs::Image;\nauto& m = const_cast<Frame&>(n);\n"), 2u);
  EXPECT_EQ(cast_in("typedef sensor_msgs::Image Frame;\ntypedef Frame Shot;\nconst_cast<Shot*>(n);\n"), 3u);
  EXPECT_EQ(cast_in("#define FRAME sensor_msgs::Image\nconst_cast<FRAME&>(n);\n"), 2u);
}

TEST_F(CastsElsewhereTest, a_parameter_of_a_template_may_be_each_message_that_the_package_names) {
  const std::string generic = "template <class M>\nvoid f(const M& m) { const_cast<M&>(m).data.clear(); }\n";
  EXPECT_EQ(cast_in(generic), 0u);
  EXPECT_EQ(cast_in(generic + "template void f(const sensor_msgs::Image&);\n"), 2u);
  EXPECT_EQ(cast_in("#include <sensor_msgs/Image.h>\nauto& v = const_cast<std::vector<uint8_t>&>(m.data);\n"),
            2u);
  EXPECT_EQ(cast_in("#include <sensor_msgs/Image.h>\nconst_cast<std::remove_const_t<decltype(m)>&>(m);\n"),
            2u);
}

TEST_F(CastsElsewhereTest, casts_of_something_else) {
  const std::string named = "#include <sensor_msgs/Image.h>\ntemplate <class T> struct Crtp;\n";
  EXPECT_EQ(cast_in(named + "const_cast<char*>(argv);\n"), 0u);
  EXPECT_EQ(cast_in(named + "const_cast<T*>(this)->f();\n"), 0u);
  EXPECT_EQ(cast_in(named + "const_cast<const T&>(m);\n"), 0u);
  EXPECT_EQ(cast_in(named + "const_cast<sensor_msgs::Image const&>(m);\n"), 0u);
  EXPECT_EQ(cast_in(named + "const_cast<stereo_msgs::Image&>(m);\n"), 0u);
  EXPECT_EQ(cast_in(named + "typedef pcl::PointCloud<T> Cloud;\nconst_cast<Cloud&>(cloud);\n"), 0u);
  EXPECT_EQ(cast_in(named + "T* p = (T*)malloc(5);\n"), 0u);
  EXPECT_EQ(cast_in(named + "const_cast<sensor_msgs::Image&>(*m).header.frame_id = \"map\";\n"), 0u);
  EXPECT_EQ(cast_in(named + "// const_cast<sensor_msgs::Image&>(m)\n"), 0u);
}

TEST_F(CastsElsewhereTest, declarations_are_no_casts) {
  EXPECT_EQ(cast_in("void f(sensor_msgs::Image&) const;\nvoid g(sensor_msgs::Image&);\n"), 0u);
  EXPECT_EQ(cast_in("void (*p)(sensor_msgs::Image&) = f;\nvoid operator()(Image&) override;\n"), 0u);
  EXPECT_EQ(cast_in("std::function<void(sensor_msgs::Image&)> f;\nauto l = [](sensor_msgs::Image& m) {};\n"),
            0u);
  EXPECT_EQ(cast_in("std::size_t n = sizeof(sensor_msgs::Image*);\n"), 0u);
}

}  // namespace
}  // namespace tzc::rewriter
