// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/page_writer.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
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
  ++number_;
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

void PageWriter::publish() {
  if (!reserve(sizeof table_)) return;
  table_.updated_ns = now_ns();
  std::memcpy(mapping_.data() + offset(), &table_, sizeof table_);
  header().published.store(number_, std::memory_order_release);
}

}  // namespace statistics
}  // namespace tzc
