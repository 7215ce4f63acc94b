// SPDX-License-Identifier: BSD-3-Clause
// Which components an error of the edited sources is attributed to.
#include "verify/attribution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edits/apply.h"
#include "solve/facts_of.h"

namespace tzc::rewriter::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const char* const node = "/p/node.cpp";
const char* const original_text =
    "void run() {\n"
    "  Image image;\n"
    "  Image other;\n"
    "  use(image);\n"
    "  pub.publish(other);\n"
    "}\n";
const char* const edited_text =
    "#include <tzc/ros.h>\n"
    "void run() {\n"
    "  tzc::Image image;\n"
    "  pub.allocate(image);\n"
    "  tzc::Image other;\n"
    "  use(image);\n"
    "  pub.publish(other);\n"
    "}\n";

Facts facts_of_node() {
  Facts facts = FactsBuilder()
                    .add(entity("pub", EntityRole::publisher))
                    .add(entity("image", EntityRole::message))
                    .add(entity("other", EntityRole::message))
                    .facts;
  facts.data_uses.push_back({id("image"), {node, 4, 7}});
  Publish publish;
  publish.where = {node, 0, 0, 5, 3};
  publish.publisher = id("pub");
  publish.messages = {id("other")};
  facts.publishes.emplace(publish.id(), publish);
  return facts;
}

/// The messages `image` and `other` are edited, the publisher is not.
class Attributed : public testing::Test {
 protected:
  Attributed() : facts_(facts_of_node()), components_(facts_) {
    insert("void run", "#include <tzc/ros.h>\n", std::nullopt);
    insert("Image image", "tzc::", of("image"));
    insert("\n  Image other", "\n  pub.allocate(image);", of("image"));
    insert("Image other", "tzc::", of("other"));
    contents_[node] = *apply_edits(original_text, edits_);
    attribution_.emplace(facts_, components_,
                         EditedSources{edits_, contents_, [](const std::string& file) {
                                         return file == node ? std::optional<std::string>(original_text)
                                                             : std::nullopt;
                                       }});
  }

  ComponentId of(const std::string& name) const { return components_.of(id(name))->id; }
  static Diagnostic error(unsigned line, std::vector<Location> notes = {}, const std::string& file = node) {
    return {{file, line, 1}, "does not compile", std::move(notes)};
  }
  std::vector<ComponentId> suspects(const Diagnostic& error) const {
    return attribution_->suspects_of(error);
  }

  Facts facts_;
  Components components_;
  Edits edits_;
  FileContents contents_;
  std::optional<Attribution> attribution_;

 private:
  void insert(const std::string& before, const std::string& text, std::optional<ComponentId> component) {
    const std::size_t offset = std::string(original_text).find(before);
    edits_.push_back({node, offset, 0, text, component, "rule"});
  }
};

TEST_F(Attributed, the_edits_give_the_text_that_the_cases_count_lines_in) {
  EXPECT_EQ(contents_[node], edited_text);
}

TEST_F(Attributed, an_error_on_an_edited_line_is_its_components) {
  EXPECT_THAT(suspects(error(3)), ElementsAre(of("image")));
  EXPECT_THAT(suspects(error(5)), ElementsAre(of("other")));
}

TEST_F(Attributed, an_error_on_a_line_that_an_edit_added_is_its_components) {
  EXPECT_THAT(suspects(error(4)), ElementsAre(of("image")));
}

TEST_F(Attributed, a_line_without_an_edit_belongs_to_what_it_uses_or_publishes) {
  EXPECT_THAT(suspects(error(6)), ElementsAre(of("image")));
  EXPECT_THAT(suspects(error(7)), ElementsAre(of("other"))) << "the publisher has no edit";
}

TEST_F(Attributed, a_flow_belongs_to_its_line) {
  facts_.flows.push_back({id("pub"), id("other"), {node, 6, 1}, "", false, {}});
  EXPECT_THAT(suspects(error(8)), ElementsAre(of("other")));
}

TEST_F(Attributed, the_lines_of_notes_count_after_the_errors_own) {
  EXPECT_THAT(suspects(error(5, {{node, 3, 1}})), ElementsAre(of("other"), of("image")));
  EXPECT_THAT(suspects(error(3, {{node, 5, 1}, {node, 4, 1}})), ElementsAre(of("image"), of("other")));
}

TEST_F(Attributed, an_error_in_a_library_is_found_by_its_notes) {
  EXPECT_THAT(suspects(error(700, {{node, 5, 1}}, "/usr/include/lib.h")), ElementsAre(of("other")));
}

TEST_F(Attributed, an_include_that_belongs_to_the_file_suspects_no_component) {
  EXPECT_THAT(suspects(error(1)), IsEmpty());
}

TEST_F(Attributed, the_line_of_another_file_is_no_suspect) {
  EXPECT_THAT(suspects(error(3, {}, "/p/other.cpp")), IsEmpty());
}

TEST_F(Attributed, a_name_on_the_line_is_a_first_guess) {
  EXPECT_THAT(attribution_->named_at(error(6)), UnorderedElementsAre(of("image")));
  EXPECT_THAT(attribution_->named_at(error(7)), UnorderedElementsAre(of("other"))) << "pub is not edited";
  EXPECT_THAT(attribution_->named_at(error(8, {{node, 4, 1}})), UnorderedElementsAre(of("image")));
  EXPECT_THAT(attribution_->named_at(error(2)), IsEmpty());
}

TEST_F(Attributed, the_components_of_a_unit_are_those_with_an_edit_in_its_files) {
  EXPECT_THAT(attribution_->edited_in({"/p/a.h", node}), UnorderedElementsAre(of("image"), of("other")));
  EXPECT_THAT(attribution_->edited_in({"/p/a.h"}), IsEmpty());
}

TEST_F(Attributed, lines_map_back_to_the_original) {
  EXPECT_EQ(attribution_->original(node, 6).first, 4u);
  EXPECT_EQ(attribution_->original(node, 4).first, 2u)
      << "an added line stands for the one that its edit begins on";
  EXPECT_EQ(attribution_->original("/p/untouched.cpp", 9).last, 9u);
}

}  // namespace
}  // namespace tzc::rewriter::test
