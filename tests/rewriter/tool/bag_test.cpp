// SPDX-License-Identifier: BSD-3-Clause
#include "tool/bag.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"
#include "tool/parse_options.h"

namespace tzc::rewriter {
namespace {

template <class T>
std::string bytes(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}
std::string counted(const std::string& text) {
  return bytes(static_cast<std::uint32_t>(text.size())) + text;
}
std::string field(const std::string& name, const std::string& value) {
  return counted(name + "=" + value);
}
std::string record(const std::string& header, const std::string& data) {
  return counted(header) + counted(data);
}
std::string op(char code) {
  return field("op", std::string(1, code));
}

std::string message(unsigned connection, std::size_t size) {
  return record(op(2) + field("conn", bytes(connection)) + field("time", bytes(std::uint64_t{1})),
                std::string(size, 'm'));
}
std::string connection(unsigned number, const std::string& topic) {
  return record(op(7) + field("conn", bytes(number)) + field("topic", topic),
                field("type", "std_msgs/String"));
}
std::string index(unsigned connection, const std::vector<std::uint32_t>& offsets) {
  std::string data;
  for (const std::uint32_t offset : offsets) data += bytes(std::uint64_t{1}) + bytes(offset);
  return record(op(4) + field("conn", bytes(connection)), data);
}

/// Two messages on /a (100 and 300 bytes), one on /b (50 bytes) in one chunk.
std::string bag(const std::string& compression, bool closed = true) {
  const std::string head = record(op(3) + field("index_pos", bytes(std::uint64_t{closed})), "");
  const std::string first = message(0, 100), second = message(1, 50), third = message(0, 300);
  const std::string content = first + second + third;
  const std::string chunk = record(op(5) + field("compression", compression) +
                                       field("size", bytes(static_cast<std::uint32_t>(content.size()))),
                                   compression == "none" ? content : "compressed");
  const auto at2 = static_cast<std::uint32_t>(first.size()),
             at3 = static_cast<std::uint32_t>(at2 + second.size());
  return "#ROSBAG V2.0\n" + head + chunk + index(0, {0, at3}) + index(1, {at2}) + connection(0, "/a") +
         connection(1, "/b");
}

std::string measured(const std::string& content) {
  tzc::test::TempDir folder;
  const auto sizes = measure_bag(folder.write("x.bag", content));
  if (!sizes) return sizes.error().what;
  std::string text;
  for (const auto& [topic, size] : *sizes) text += topic + "=" + std::to_string(size) + " ";
  return text;
}

TEST(MeasureBag, largest_message_of_each_topic) {
  EXPECT_EQ(measured(bag("none")), "/a=300 /b=50 ");
}
TEST(MeasureBag, compressed_chunks_are_measured_by_their_index) {
  EXPECT_EQ(measured(bag("lz4")), "/a=300 /b=50 ");
}
TEST(MeasureBag, not_closed) {
  EXPECT_EQ(measured(bag("none", false)), "was not closed properly, it has no index");
}
TEST(MeasureBag, not_a_bag) {
  EXPECT_EQ(measured(""), "is no recording in format 2.0");
  EXPECT_EQ(measured("#ROSBAG V1.2\n"), "is no recording in format 2.0");
}
TEST(MeasureBag, cut_anywhere_never_crashes) {
  const std::string whole = bag("none");
  for (std::size_t size = 0; size < whole.size(); size += 3) measured(whole.substr(0, size));
}
TEST(MeasureBag, any_byte_changed_never_crashes) {
  for (const char* compression : {"none", "bz2"}) {
    std::string content = bag(compression);
    for (std::size_t i = 13; i < content.size(); i += i < 300 || i > 900 ? 1 : 9) {
      const char old = content[i];
      content[i] = static_cast<char>(0xff);
      measured(content);
      content[i] = old;
    }
  }
}

TEST(BySourceName, the_largest_of_all_topics_that_a_name_may_mean) {
  const auto sizes = by_source_name({{"/left/image", 10}, {"/right/image", 20}});
  EXPECT_EQ(sizes.at("/left/image"), 10u);
  EXPECT_EQ(sizes.at("left/image"), 10u);
  EXPECT_EQ(sizes.at("image"), 20u);
  EXPECT_EQ(sizes.at("~image"), 20u);
}

TEST(ParseSize, units) {
  EXPECT_EQ(parse_size("4096"), 4096u);
  EXPECT_EQ(parse_size("64K"), 65536u);
  EXPECT_EQ(parse_size("64MB"), 64u << 20);
  EXPECT_EQ(parse_size("1GiB"), 1u << 30);
  EXPECT_EQ(parse_size("64m"), parse_size("64M"));  // as a node takes them
}
TEST(ParseSize, nonsense) {
  for (const char* text : {"", "M", "-1", "1.5G", "1T", "99999999999999999999", "9000000000000G"})
    EXPECT_FALSE(parse_size(text)) << text;
}

}  // namespace
}  // namespace tzc::rewriter
