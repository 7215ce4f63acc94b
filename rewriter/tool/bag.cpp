// SPDX-License-Identifier: BSD-3-Clause
#include "tool/bag.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <vector>

namespace tzc::rewriter {
namespace {

enum Op : std::uint8_t { message = 2, bag_header = 3, index = 4, chunk = 5, chunk_info = 6, connection = 7 };

using Fields = std::map<std::string, std::string>;

template <class T>
T number(const std::string& bytes, std::size_t at = 0) {
  T value{};
  if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Record {
  Fields fields;
  std::uint64_t data_offset = 0;
  std::uint32_t data_size = 0;
  Op op() const { return static_cast<Op>(fields.count("op") ? number<std::uint8_t>(fields.at("op")) : 0); }
};

/// "length name=value" pairs.
Fields parse_fields(const std::string& header) {
  Fields fields;
  for (std::size_t at = 0; at + 4 <= header.size();) {
    const auto length = number<std::uint32_t>(header, at);
    const std::string field = header.substr(at + 4, length);
    const std::size_t equals = field.find('=');
    if (equals == std::string::npos) break;
    fields[field.substr(0, equals)] = field.substr(equals + 1);
    at += 4 + std::size_t{length};
  }
  return fields;
}

struct MessageAt {
  std::uint32_t offset, connection;
};

class Bag {
 public:
  explicit Bag(const std::string& path) : path_(path), file_(path, std::ios::binary) {}

  Expected<std::map<std::string, std::uint64_t>> run() {
    if (!file_) return Error{"cannot be read", path_, "name a recording that you may read after --bag"};
    std::string version;
    std::getline(file_, version);
    if (version != "#ROSBAG V2.0")
      return Error{"is no recording in format 2.0", path_, "convert it with rosbag fix"};
    file_size_ = size_of_file();
    Record record;
    if (!read(record) || record.op() != bag_header || number<std::uint64_t>(record.fields["index_pos"]) == 0)
      return Error{"was not closed properly, it has no index", path_, "run rosbag reindex on it"};
    while (read(record)) visit(record);
    finish_chunk();
    return by_topic();
  }

 private:
  std::uint64_t size_of_file() {
    const auto here = file_.tellg();
    file_.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(file_.tellg());
    file_.seekg(here);
    return size;
  }

  bool read_bytes(std::string& bytes, std::uint64_t size) {
    if (size > file_size_) return false;
    bytes.resize(size);
    return static_cast<bool>(file_.read(bytes.data(), static_cast<std::streamsize>(size)));
  }

  /// The record at the current place; leaves its data unread.
  bool read(Record& record) {
    std::string length, header;
    if (!read_bytes(length, 4) || !read_bytes(header, number<std::uint32_t>(length)) ||
        !read_bytes(length, 4))
      return false;
    record.fields = parse_fields(header);
    record.data_size = number<std::uint32_t>(length);
    record.data_offset = static_cast<std::uint64_t>(file_.tellg());
    file_.seekg(static_cast<std::streamoff>(record.data_offset + record.data_size));
    return true;
  }

  std::string data_of(const Record& record) {
    std::string data;
    const auto here = file_.tellg();
    file_.seekg(static_cast<std::streamoff>(record.data_offset));
    read_bytes(data, record.data_size);
    file_.clear();
    file_.seekg(here);
    return data;
  }

  void visit(const Record& record) {
    if (record.op() == connection)
      topics_[number<std::uint32_t>(field(record, "conn"))] = field(record, "topic");
    if (record.op() == chunk) {
      finish_chunk();
      chunk_ = record;
    }
    if (record.op() == index) add_index(record);
  }

  static std::string field(const Record& record, const std::string& name) {
    const auto found = record.fields.find(name);
    return found == record.fields.end() ? "" : found->second;
  }

  /// Entries of 12 bytes: time, offset of the message record in the uncompressed chunk.
  void add_index(const Record& record) {
    const auto connection = number<std::uint32_t>(field(record, "conn"));
    const std::string data = data_of(record);
    for (std::size_t at = 0; at + 12 <= data.size(); at += 12)
      messages_.push_back({number<std::uint32_t>(data, at + 8), connection});
  }

  void finish_chunk() {
    std::sort(messages_.begin(), messages_.end(), [](auto& a, auto& b) { return a.offset < b.offset; });
    const auto end = number<std::uint32_t>(field(chunk_, "size"));
    const bool is_plain = field(chunk_, "compression") == "none";
    for (std::size_t i = 0; i < messages_.size(); ++i) {
      const std::uint32_t next = i + 1 < messages_.size() ? messages_[i + 1].offset : end;
      const std::uint64_t size = is_plain ? exact_size(messages_[i]) : guessed_size(messages_[i], next);
      std::uint64_t& largest = largest_[messages_[i].connection];
      largest = std::max(largest, size);
    }
    messages_.clear();
  }

  std::uint64_t exact_size(const MessageAt& at) {
    Record record;
    file_.clear();
    const auto here = file_.tellg();
    file_.seekg(static_cast<std::streamoff>(chunk_.data_offset + at.offset));
    const bool is_message = read(record) && record.op() == message;
    file_.clear();
    file_.seekg(here);
    return is_message ? record.data_size : 0;
  }

  /// A message record's own header has 46 bytes: op, conn, time and the two lengths.
  static std::uint64_t guessed_size(const MessageAt& at, std::uint32_t next) {
    constexpr std::uint32_t header = 46;
    return next > at.offset + header ? next - at.offset - header : 0;
  }

  std::map<std::string, std::uint64_t> by_topic() const {
    std::map<std::string, std::uint64_t> sizes;
    for (const auto& [connection, size] : largest_) {
      const auto topic = topics_.find(connection);
      if (topic != topics_.end()) sizes[topic->second] = std::max(sizes[topic->second], size);
    }
    return sizes;
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t file_size_ = 0;
  Record chunk_;
  std::vector<MessageAt> messages_;
  std::map<std::uint32_t, std::string> topics_;
  std::map<std::uint32_t, std::uint64_t> largest_;
};

}  // namespace

Expected<std::map<std::string, std::uint64_t>> measure_bag(const std::string& file) {
  return Bag(file).run();
}

std::map<std::string, std::uint64_t> by_source_name(const std::map<std::string, std::uint64_t>& sizes) {
  std::map<std::string, std::uint64_t> all;
  const auto add = [&](const std::string& name, std::uint64_t size) {
    all[name] = std::max(all[name], size);
  };
  for (const auto& [topic, size] : sizes) {
    add(topic, size);
    for (std::size_t slash = topic.find('/'); slash != std::string::npos;
         slash = topic.find('/', slash + 1)) {
      add(topic.substr(slash + 1), size);
      add("~" + topic.substr(slash + 1), size);
    }
  }
  return all;
}

}  // namespace tzc::rewriter
