// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "posix/hot.h"
#include "posix/zeroed_memory.h"

namespace tzc {
namespace segment {

/// For each slot of a segment the last generation that was sent to one subscriber; 0: none was. A row of notes is made when a
/// block of its slots is first sent: blocks mostly lie in the first slots, and there are thousands of subscribers.
class SentNotes {
 public:
  using Note = std::atomic<std::uint32_t>;

  /// What the constructor needs.
  static Expected<posix::ZeroedMemory> table(std::uint32_t slots) {
    return posix::ZeroedMemory::create(rows_of(slots) * sizeof(std::atomic<Row*>));
  }
  SentNotes(std::uint32_t slots, posix::ZeroedMemory table)
      : rows_(rows_of(slots)), table_(std::move(table)) {}
  ~SentNotes() {
    for (std::uint32_t row = 0; row < rows_; ++row) delete row_at(row).load(std::memory_order_relaxed);
  }
  SentNotes(const SentNotes&) = delete;
  SentNotes& operator=(const SentNotes&) = delete;

  /// To be written. One thread at a time.
  TZC_HOT Note& at(std::uint32_t slot) {
    std::atomic<Row*>& row = row_at(slot / row_slots);
    if (row.load(std::memory_order_relaxed) == nullptr) row.store(new Row, std::memory_order_release);
    return row.load(std::memory_order_relaxed)->notes[slot % row_slots];
  }
  /// Any thread.
  const Note& of(std::uint32_t slot) const {
    static const Note nothing{0};
    const Row* const row = row_at(slot / row_slots).load(std::memory_order_acquire);
    return row == nullptr ? nothing : row->notes[slot % row_slots];
  }

 private:
  static constexpr std::uint32_t row_slots = 16;  // what a queue of the usual length takes
  struct Row {
    Note notes[row_slots] = {};
  };

  static std::size_t rows_of(std::uint32_t slots) { return (slots + row_slots - 1) / row_slots; }
  std::atomic<Row*>& row_at(std::size_t row) const {
    return reinterpret_cast<std::atomic<Row*>*>(table_.data())[row];
  }

  const std::size_t rows_;
  const posix::ZeroedMemory table_;
};

}  // namespace segment
}  // namespace tzc
