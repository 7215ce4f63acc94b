// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "statistics/page_layout.h"
#include "tzc/error.h"

namespace tzc {
namespace statistics {

/// Cuts a text to the room that a row has for it.
template <std::size_t size>
void copy_text(char (&row)[size], const std::string& text) {
  std::memset(row, 0, size);
  std::memcpy(row, text.data(), text.size() < size ? text.size() : size - 1);
}

/// Writes the statistics page of this process, a table at a time: begin, add rows, publish. Never blocks; readers cannot
/// write to it or shrink it. Not thread-safe. The page goes with this object, or with the process.
class PageWriter {
 public:
  /// Costs one descriptor, and memory for what is written. Errors: no descriptor or memory left, or a system on which
  /// a page cannot be found by others.
  static Expected<std::shared_ptr<PageWriter>> create(const std::string& node);

  /// Begins a table; its rows replace those of the last one when it is published.
  void begin();
  void add(const TopicRow& row) { add(&row, sizeof row); }
  /// Belongs to the topic that was added last.
  void add(const ConnectionRow& row) { add(&row, sizeof row); }
  void add(const SubscriptionRow& row) { add(&row, sizeof row); }
  /// \name Rows of the last table once more, which therefore nobody else has to keep. None after a round that was not published.
  /// @{
  /// The topic's connections.
  void repeat_connections(const std::string& topic);
  /// All subscriptions.
  void repeat_subscriptions();
  /// @}
  void publish();

 private:
  PageWriter(posix::MemoryFile file, posix::Mapping mapping)
      : file_(std::move(file)), mapping_(std::move(mapping)) {}
  void add(const void* row, std::size_t bytes);
  std::size_t last_rows() const;
  const std::uint8_t* last_row(std::size_t index) const;
  bool reserve(std::size_t end);
  std::size_t offset() const { return table_offset(number_); }
  PageHeader& header() const { return *reinterpret_cast<PageHeader*>(mapping_.data()); }

  posix::MemoryFile file_;
  posix::Mapping mapping_;
  std::uint64_t number_ = 0;
  TableHeader table_{};
  std::size_t reserved_[2] = {0, 0};  ///< bytes of each table that are committed: a write there cannot fault
};

}  // namespace statistics
}  // namespace tzc
