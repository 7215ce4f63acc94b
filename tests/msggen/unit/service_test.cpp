// SPDX-License-Identifier: BSD-3-Clause
// To genmsg a service's request and response are no messages that a field could have.
#include <gmock/gmock.h>

#include "library_case.h"
#include "support/temp_dir.h"

namespace tzc::msggen::test {
namespace {

using ::testing::HasSubstr;

/// Definitions in files, found by name.
class ServiceMessages : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("srv/Ask.srv", "uint8 q\n---\nuint8 a\n");
    folder_.write("msg/U.msg", "AskResponse r\n");
  }
  std::string faults() const {
    std::string text;
    for (const Diagnostic& d : diagnostics_.sorted()) text += render(d);
    return text;
  }

  tzc::test::TempDir folder_;
  Diagnostics diagnostics_;
  Library library_{{{{"demo", {folder_ / "msg"}}}, {}, false}, diagnostics_};
};

TEST_F(ServiceMessages, their_messages_are_no_types_of_fields) {
  EXPECT_FALSE(library_.find("demo/U"));
  EXPECT_THAT(faults(), HasSubstr("U.msg:1:1: error: unknown type 'AskResponse'"));
  EXPECT_THAT(faults(), HasSubstr("hint: it is a service's request or response"));
}

TEST_F(ServiceMessages, that_were_read_before_change_nothing_about_it) {
  library_.add_file(folder_ / "srv/Ask.srv", "demo");
  EXPECT_FALSE(library_.find("demo/U"));
  EXPECT_THAT(faults(), HasSubstr("hint: it is a service's request or response"));
}

TEST_F(ServiceMessages, are_found_when_asked_for) {
  EXPECT_TRUE(library_.find("demo/AskRequest")) << faults();
  EXPECT_TRUE(library_.find("demo/AskResponse")) << faults();
}

TEST_F(ServiceMessages, a_message_of_such_a_name_is_one) {
  folder_.write("msg/SomeResponse.msg", "uint8 x\n");
  folder_.write("msg/V.msg", "SomeResponse r\n");
  EXPECT_TRUE(library_.find("demo/V")) << faults();
}

TEST_F(ServiceMessages, a_message_that_is_the_same_as_a_services_is_a_type) {
  folder_.write("msg/AskResponse.msg", "uint8 a\n\n");
  library_.add_file(folder_ / "srv/Ask.srv", "demo");
  EXPECT_TRUE(library_.find("demo/U")) << faults();
}

TEST_F(ServiceMessages, messages_of_actions_are_types) {
  folder_.write("action/Go.action", "uint8 g\n---\nuint8 r\n---\nuint8 f\n");
  folder_.write("msg/V.msg", "GoGoal g\nGoFeedback[] f\n");
  EXPECT_TRUE(library_.find("demo/V")) << faults();
}

}  // namespace
}  // namespace tzc::msggen::test
