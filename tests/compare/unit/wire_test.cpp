// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "messages.h"
#include "wire/value_text.h"

namespace tzc::compare {
namespace {

using ::testing::ElementsAre;
using testing::header_section;
using ::testing::IsEmpty;
using testing::Wire;

const FieldFilter nothing = [](const std::string&) { return false; };

Field definition(const std::string& text) {
  const std::optional<Field> field = parse_definition("test/Type", text);
  EXPECT_TRUE(field) << text;
  return field.value_or(Field());
}

std::vector<std::string> paths(const Field& field) {
  std::vector<std::string> all;
  for (const Field& child : field.children) {
    all.push_back(child.path);
    for (const std::string& path : paths(child)) all.push_back(path);
  }
  return all;
}

TEST(definition, expands_types_and_passes_over_comments_and_constants) {
  const Field root =
      definition(std::string("# a comment\nuint8 RED=1\nstring NAME = a # no comment\nint32 UNTIDY   =3\r\n"
                             "Header header\nPoint[] points # trailing\nfloat64[9] k\n") +
                 header_section + "==========\nMSG: test/Point\nfloat32 x\nfloat32 y\n");
  EXPECT_THAT(paths(root), ElementsAre("header", "header.seq", "header.stamp", "header.frame_id", "points[]",
                                       "points[].x", "points[].y", "k[]"));
  EXPECT_EQ(root.children[2].fixed_count, 9U);
  EXPECT_EQ(root.children[1].element, 8U) << "two float32";
  EXPECT_FALSE(root.children[0].element) << "a header contains a string";
}

TEST(definition, a_missing_type_is_no_definition) {
  EXPECT_FALSE(parse_definition("test/Type", "Unknown x\n"));
  EXPECT_FALSE(parse_definition("test/Type", "uint8[x] y\n"));
}

TEST(definition, a_type_that_contains_itself_is_no_definition) {
  EXPECT_FALSE(parse_definition("test/Type", "test/Type x\n"));
}

std::vector<std::pair<std::size_t, std::size_t>> masked(const Masks& masks, const Bytes& message) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const Range& range : masks.ranges(message).value_or(std::vector<Range>{{99, 99}}))
    result.emplace_back(range.offset, range.size);
  return result;
}

TEST(masks, sequence_numbers_of_headers_at_any_depth) {
  const Field root =
      definition(std::string("string name\nPicture[] pictures\nstd_msgs/Header header\nuint32 seq\n") +
                 header_section + "==========\nMSG: test/Picture\nHeader header\nuint8[] data\n");
  const Bytes message = Wire()
                            .text("ab")
                            .put(std::uint32_t{2})
                            .header(7, 1, "")
                            .bytes({1, 2, 3})
                            .header(8, 2, "x")
                            .bytes({})
                            .header(9, 3, "")
                            .put(std::uint32_t{10});
  // 6 bytes of name and 4 of the count; a picture: header of 16 bytes and its frame, 4 + 3 bytes of data
  EXPECT_THAT(masked(Masks(root, nothing), message),
              ElementsAre(std::pair(10, 4), std::pair(33, 4), std::pair(54, 4)))
      << "the last field is called seq and is no header's";
}

TEST(masks, a_type_that_is_only_called_header_is_none) {
  const Field root =
      parse_definition("my/Type",
                       "Header header\n==========\nMSG: std_msgs/Header\nuint32 seq\nstring frame_id\n")
          .value();
  EXPECT_THAT(masked(Masks(root, nothing), Wire().put(std::uint32_t{1}).text("x")), IsEmpty());
}

TEST(masks, a_topic_of_headers) {
  const Field root = parse_definition("std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id\n").value();
  EXPECT_TRUE(root.is_header);
  EXPECT_THAT(masked(Masks(root, nothing), Wire().header(1, 2)), ElementsAre(std::pair(0, 4)));
}

TEST(masks, stamps_on_request) {
  const Field root = definition(std::string("Header header\ntime stamp\n") + header_section);
  const Bytes message = Wire().header(1, 2, "").put(std::uint64_t{5});
  EXPECT_THAT(masked(Masks(root, filter_for(root, {true, {}})), message),
              ElementsAre(std::pair(0, 4), std::pair(4, 8)))
      << "the message's own stamp is data";
  EXPECT_THAT(masked(Masks(root, filter_for(root, {false, {"stamp"}})), message),
              ElementsAre(std::pair(0, 4), std::pair(16, 8)));
}

TEST(masks, a_field_with_all_that_is_inside) {
  const Field root =
      definition("Pair[] pairs\nuint8 end\n==========\nMSG: test/Pair\nstring key\nuint16[] values\n");
  const Bytes message = Wire()
                            .put(std::uint32_t{1})
                            .text("key")
                            .put(std::uint32_t{2})
                            .put(std::uint32_t{77})
                            .put(std::uint8_t{5});
  EXPECT_THAT(masked(Masks(root, filter_for(root, {false, {"pairs[]"}})), message),
              ElementsAre(std::pair(8, 3), std::pair(15, 4)));
}

TEST(masks, bytes_that_do_not_fit_are_left_alone) {
  const Field root = definition(std::string("Header header\nuint8[] data\n") + header_section);
  const Masks masks(root, nothing);
  const Bytes whole = Wire().header(1, 2).bytes({1, 2, 3});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    const Bytes before = cut;
    EXPECT_FALSE(masks.apply(cut)) << size;
    EXPECT_EQ(cut, before);
  }
  Bytes longer = whole;
  longer.push_back(0);
  EXPECT_FALSE(masks.apply(longer));
  Bytes huge = Wire().header(1, 2).put(std::uint32_t{0xffffffff});
  EXPECT_FALSE(masks.apply(huge));
}

struct Expected {
  std::string field, where, first, second;
  std::size_t offset;
};
void PrintTo(const Expected& e, std::ostream* out) {
  *out << e.field << " " << e.where << " " << e.first << " " << e.second << " " << e.offset;
}

MATCHER_P(is, e, ::testing::PrintToString(e)) {
  return arg.field == e.field && arg.where == e.where && arg.first_value == e.first &&
         arg.second_value == e.second && arg.first_offset == e.offset;
}
}  // namespace

void PrintTo(const FieldDifference& d, std::ostream* out) {
  *out << d.field << " " << d.where << " " << d.first_value << " " << d.second_value << " " << d.first_offset
       << "/" << d.second_offset;
}

namespace {

TEST(field_difference, names_the_element_and_the_byte) {
  const Field root = definition("uint16[] data\nfloat32 x\n");
  const Bytes first = Wire()
                          .put(std::uint32_t{3})
                          .put(std::uint16_t{1})
                          .put(std::uint16_t{2})
                          .put(std::uint16_t{300})
                          .put(0.5F);
  const Bytes second = Wire()
                           .put(std::uint32_t{3})
                           .put(std::uint16_t{1})
                           .put(std::uint16_t{2})
                           .put(std::uint16_t{44})
                           .put(1.5F);
  // 300 and 44 differ in their upper byte only.
  EXPECT_THAT(field_differences(root, first, second),
              ElementsAre(is(Expected{"data[]", "data[2]", "300", "44", 9}),
                          is(Expected{"x", "x", "0.5", "1.5", 12})));
}

TEST(field_difference, finds_the_first_element_of_nested_messages) {
  const Field root = definition(
      "Pair[] pairs\n==========\nMSG: test/Pair\nPoint[2] ends\nstring name\n"
      "==========\nMSG: test/Point\nint32 x\nint32 y\n");
  const auto message = [](std::int32_t y, const std::string& name) {
    Wire wire;
    wire.put(std::uint32_t{2});
    for (int pair = 0; pair < 2; ++pair) {
      for (std::int32_t value : {1, 2, 3, pair == 1 ? y : 4}) wire.put(value);
      wire.text(name);
    }
    return Bytes(wire);
  };
  EXPECT_THAT(field_differences(root, message(4, "a"), message(5, "b")),
              ElementsAre(is(Expected{"pairs[].name", "pairs[0].name", "\"a\"", "\"b\"", 24}),
                          is(Expected{"pairs[].ends[].y", "pairs[1].ends[1].y", "4", "5", 37})));
}

TEST(field_difference, lengths_differ) {
  const Field root = definition("uint8[] data\nstring[] names\nuint8 end\n");
  const Bytes first = Wire().bytes({1, 2, 3}).put(std::uint32_t{1}).text("a").put(std::uint8_t{7});
  const Bytes second = Wire().bytes({1, 2}).put(std::uint32_t{2}).text("a").text("b").put(std::uint8_t{7});
  EXPECT_THAT(field_differences(root, first, second),
              ElementsAre(is(Expected{"data[]", "data", "3 elements", "2 elements", 0}),
                          is(Expected{"names[]", "names", "1 elements", "2 elements", 7})))
      << "what follows is found in its new place";
}

TEST(field_difference, many_equal_messages_are_passed_over) {
  const Field root = definition("Point[] points\n==========\nMSG: test/Point\nint32 x\nint32 y\n");
  Wire first, second;
  first.put(std::uint32_t{100'000});
  second.put(std::uint32_t{100'000});
  for (std::int32_t i = 0; i < 100'000; ++i) {
    first.put(i).put(i);
    second.put(i).put(i == 99'998 ? -1 : i);
  }
  EXPECT_THAT(field_differences(root, first, second),
              ElementsAre(is(Expected{"points[].y", "points[99998].y", "99998", "-1", 4 + 99'998 * 8 + 4})));
}

TEST(field_difference, bytes_without_a_definition) {
  const Field unknown;
  EXPECT_THAT(field_differences(unknown, {1, 2, 3}, {1, 9, 3, 4}),
              ElementsAre(is(Expected{"", "", "2 bytes left", "3 bytes left", 1})));
  EXPECT_THAT(field_differences(unknown, {1, 2}, {1, 2}), IsEmpty());
}

TEST(field_difference, damaged_bytes_end_where_they_stop_to_fit) {
  const Field root = definition("uint32 x\nuint8[] data\n");
  const Bytes first = Wire().put(std::uint32_t{1}).bytes({1, 2, 3});
  Bytes second = first;
  second.resize(9);
  const auto found = field_differences(root, first, second);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.back().field, "");
}

// Bytes from anywhere: nothing is read outside of them (AddressSanitizer would tell), masks change masked
// ranges alone, and messages that differ are never called equal.
TEST(field_difference, random_bytes) {
  const Field root = definition(
      std::string("Header header\nPair[] pairs\nstring[2] names\nuint16[] data\n") + header_section +
      "==========\nMSG: test/Pair\nHeader header\nfloat64[2] ends\nduration[] times\n");
  const Masks masks(root, nothing);
  std::mt19937 dice(7);
  for (int round = 0; round < 20'000; ++round) {
    Bytes first(dice() % 120);
    for (auto& byte : first) byte = static_cast<std::uint8_t>(dice() % 8 == 0 ? dice() % 4 : 0);
    Bytes second = first;
    if (!second.empty()) second[dice() % second.size()] ^= static_cast<std::uint8_t>(1 + dice() % 255);
    if (dice() % 4 == 0) second.resize(dice() % 120);
    masks.apply(first);
    masks.apply(second);
    ASSERT_EQ(field_differences(root, first, second).empty(), first == second) << round;
  }
}

TEST(value_text, of_every_kind) {
  const auto text = [](Kind kind, const Bytes& bytes) {
    return value_text(kind, bytes.data(), bytes.size());
  };
  EXPECT_EQ(text(Kind::int8, {0xff}), "-1");
  EXPECT_EQ(text(Kind::uint8, {0xff}), "255");
  EXPECT_EQ(text(Kind::boolean, {1}), "1");
  EXPECT_EQ(text(Kind::int16, Wire().put(std::int16_t{-300})), "-300");
  EXPECT_EQ(text(Kind::uint64, Wire().put(~std::uint64_t{0})), "18446744073709551615");
  EXPECT_EQ(text(Kind::float64, Wire().put(0.1)), "0.1");
  EXPECT_EQ(text(Kind::time, Wire().put(std::uint32_t{5}).put(std::uint32_t{20})), "5.000000020");
  EXPECT_EQ(text(Kind::string, {'a', '"', 0, 'b'}), "\"a\\x22\\x00b\"");
  EXPECT_EQ(text(Kind::string, Bytes(200, 'x')).size(), 64U);
}

}  // namespace
}  // namespace tzc::compare
