// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/page_writer.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <new>
#include <utility>

#include "posix/shared_memory.h"

namespace tzc {
namespace statistics {
namespace {

std::uint64_t now_ns() {
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(since_boot).count());
}

RowKind kind_of(const std::uint8_t* row) {
  RowKind kind{};
  std::memcpy(&kind, row, sizeof kind);
  return kind;
}

bool is_topic(const std::uint8_t* row, const std::string& topic) {
  TopicRow wanted{};
  copy_text(wanted.topic, topic);
  return kind_of(row) == RowKind::topic &&
         std::memcmp(row + offsetof(TopicRow, topic), wanted.topic, sizeof wanted.topic) == 0;
}

#ifdef TZC_PORTABLE
constexpr bool can_be_found = false;  // no system but Linux shows a process's memory files
#else
constexpr bool can_be_found = true;
#endif

}  // namespace

Expected<std::shared_ptr<PageWriter>> PageWriter::create(const std::string& node) {
  Error failure;
  failure.what = "make a statistics page: no other process could find it on this system";
  if (!can_be_found) return failure;
  auto memory =
      posix::create_shared_memory(page_name, page_bytes, posix::page_size(), posix::Sharing::peers_read);
  if (!memory) return memory.error();
  std::shared_ptr<PageWriter> page(new PageWriter(std::move(memory->file), std::move(memory->mapping)));
  auto* const header = new (page->mapping_.data()) PageHeader{};
  header->version = page_version;
  header->pid = static_cast<std::uint32_t>(::getpid());
  header->started_ns = now_ns();
  copy_text(header->node, node);
  header->magic = page_magic;
  return page;
}

// Who has copied a row of this table sees afterwards that the one before it was published meanwhile, and copies again.
void PageWriter::begin() {
  std::atomic_thread_fence(std::memory_order_release);
  number_ = header().published.load(std::memory_order_relaxed) +
            1;  // a table that was not published is written anew
  table_ = TableHeader{number_, 0, 0, 0};
}

bool PageWriter::reserve(std::size_t end) {
  std::size_t& done = reserved_[number_ % 2];
  if (end <= done) return true;
  const std::size_t page = posix::page_size();
  const std::size_t wanted = (end + page - 1) / page * page;
  if (!posix::reserve(file_, offset() + done, wanted - done)) return false;
  done = wanted;
  return true;
}

void PageWriter::add(const void* row, std::size_t bytes) {
  const std::size_t at = sizeof(TableHeader) + table_.rows * row_bytes;
  if (table_.rows == most_rows || !reserve(at + row_bytes)) {
    ++table_.left_out;
    return;
  }
  std::memcpy(mapping_.data() + offset() + at, row, bytes);
  ++table_.rows;
}

// The one before it lies where this table is being written.
std::size_t PageWriter::last_rows() const {
  const std::uint64_t published = header().published.load(std::memory_order_relaxed);
  if (published == 0) return 0;
  TableHeader last;
  std::memcpy(&last, mapping_.data() + table_offset(published), sizeof last);
  return last.rows;
}

const std::uint8_t* PageWriter::last_row(std::size_t index) const {
  return mapping_.data() + table_offset(number_ - 1) + sizeof(TableHeader) + index * row_bytes;
}

void PageWriter::repeat_connections(const std::string& topic) {
  const std::size_t rows = last_rows();
  std::size_t row = 0;
  while (row < rows && !is_topic(last_row(row), topic)) ++row;
  for (++row; row < rows && kind_of(last_row(row)) == RowKind::connection; ++row)
    add(last_row(row), row_bytes);
}

void PageWriter::repeat_subscriptions() {
  const std::size_t rows = last_rows();
  for (std::size_t row = 0; row < rows; ++row)
    if (kind_of(last_row(row)) == RowKind::subscription) add(last_row(row), row_bytes);
}

void PageWriter::publish() {
  if (!reserve(sizeof table_)) return;
  table_.updated_ns = now_ns();
  std::memcpy(mapping_.data() + offset(), &table_, sizeof table_);
  header().published.store(number_, std::memory_order_release);
}

}  // namespace statistics
}  // namespace tzc
