// SPDX-License-Identifier: BSD-3-Clause
// Which calls of an edited unit count as changed.
#include "verify/changed_calls.h"

#include <gtest/gtest.h>

namespace tzc::rewriter {
namespace {

/// A call in node.cpp of the function that `line` of api.h declares.
PackageCall call(unsigned line, const std::string& arguments = "") {
  PackageCall made;
  made.file = "node.cpp";
  made.callee_file = "api.h";
  made.callee_line = line;
  made.callee = "use";
  if (!arguments.empty()) made.instance = {"apply/1::", arguments};
  return made;
}

PackageCall in(const std::string& file, PackageCall made) {
  made.file = file;
  return made;
}

const unsigned replaced = 9;

/// The unit includes node.cpp and api.h, whose lines stay as they are; an edit replaces the calls of the function that the
/// line `replaced` declares.
bool is_changed(const std::vector<PackageCall>& before, const std::vector<PackageCall>& now) {
  OriginalUnit original{before, {}, {}, {}};
  original.has = [](const std::string& file) { return file == "node.cpp" || file == "api.h"; };
  original.is_line = [](const std::string&, unsigned edited, unsigned line) { return edited == line; };
  original.is_replaced = [](const PackageCall& call) { return call.callee_line == replaced; };
  return changed_call(original, now).has_value();
}

const char* const image = "sensor_msgs::Image_<std::allocator<void>>;";
const char* const image_twin = "tzc::sensor_msgs::Image;";
const char* const array = "tzc::Array<unsigned char>;";

TEST(ChangedCalls, another_overload_is_a_change) {
  EXPECT_FALSE(is_changed({call(1), call(2)}, {call(1), call(2)}));
  EXPECT_TRUE(is_changed({call(1), call(2)}, {call(1), call(1)}));
}

TEST(ChangedCalls, a_call_that_comes_or_goes_is_a_change) {
  EXPECT_TRUE(is_changed({call(1)}, {call(1), call(2)}));
  EXPECT_TRUE(is_changed({call(1), call(2)}, {call(1)}));
  EXPECT_TRUE(is_changed({call(1)}, {}));
  EXPECT_TRUE(is_changed({}, {call(1)}));
}

TEST(ChangedCalls, a_call_that_an_edit_replaces_may_go) {
  EXPECT_FALSE(is_changed({call(1), call(replaced), call(2)}, {call(1), call(2)}));
  EXPECT_FALSE(is_changed({call(replaced)}, {}));
  EXPECT_TRUE(is_changed({call(1), call(replaced), call(2)}, {call(1), call(3), call(2)}));
}

TEST(ChangedCalls, the_order_of_files_does_not_matter) {
  EXPECT_FALSE(is_changed({call(1), in("api.h", call(2))}, {in("api.h", call(2)), call(1)}));
}

TEST(ChangedCalls, a_header_that_the_unit_did_not_include_has_nothing_to_change) {
  EXPECT_FALSE(is_changed({call(1)}, {in("more.h", call(2)), call(1)}));
  EXPECT_TRUE(is_changed({call(1)}, {in("api.h", call(2)), call(1)}));
}

TEST(ChangedCalls, a_template_is_compared_by_what_it_is_instantiated_for) {
  EXPECT_FALSE(is_changed({call(1, image), call(2, "int;")}, {call(2, "int;"), call(1, image)}));
  EXPECT_TRUE(is_changed({call(1, image), call(2, "int;")}, {call(2, "int;"), call(2, image)}));
}

TEST(ChangedCalls, a_twin_must_do_what_its_message_did) {
  EXPECT_FALSE(is_changed({call(1, image), call(2, "int;")}, {call(1, image_twin), call(2, "int;")}));
  EXPECT_TRUE(is_changed({call(1, image), call(2, "int;")}, {call(2, image_twin), call(2, "int;")}));
}

TEST(ChangedCalls, also_when_other_code_still_uses_the_message) {
  EXPECT_FALSE(is_changed({call(1, image)}, {call(1, image), call(1, image_twin)}));
  EXPECT_TRUE(is_changed({call(1, image), call(2, "int;")}, {call(1, image), call(2, image_twin)}));
}

TEST(ChangedCalls, a_new_instantiation_must_do_what_all_of_its_template_did) {
  EXPECT_FALSE(is_changed({call(1, image)}, {call(1, array)}));
  EXPECT_TRUE(is_changed({call(1, image)}, {call(2, array)}));
  EXPECT_TRUE(is_changed({call(1, image), call(2, "int;")}, {call(1, array)}));
}

/// Where the instantiation begins.
PackageCall begin(const std::string& arguments) {
  PackageCall made = call(0, arguments);
  made.callee_file = "";
  return made;
}

TEST(ChangedCalls, an_instantiation_that_called_a_library_must_go_on_to) {
  EXPECT_FALSE(is_changed({begin(image)}, {begin(image_twin)}));
  EXPECT_TRUE(is_changed({begin(image)}, {begin(image_twin), call(1, image_twin)}));
}

TEST(ChangedCalls, a_template_that_was_never_instantiated_has_nothing_to_change) {
  EXPECT_FALSE(is_changed({call(1)}, {call(1), call(2, image)}));
}

TEST(ChangedCalls, what_is_picked_has_a_name) {
  PackageCall made = call(1);
  EXPECT_EQ(picked_by(made), "'use'");
  made.callee = "(lambda)::operator()";
  EXPECT_EQ(picked_by(made), "lambda");
  made.callee = "api::run::(lambda)::operator()::(lambda)::operator()";
  EXPECT_EQ(picked_by(made), "lambda in 'api::run'");
  made.callee = "api::run::(lambda)::operator()::Local::use";
  EXPECT_EQ(picked_by(made), "'api::run::(lambda)::operator()::Local::use'");
}

}  // namespace
}  // namespace tzc::rewriter
