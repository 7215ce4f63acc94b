// SPDX-License-Identifier: BSD-3-Clause
#include "segment/private_views.h"

#include <sys/mman.h>

#include <cstring>
#include <mutex>
#include <utility>

#include "posix/fork_epoch.h"
#include "posix/memory_file.h"
#include "posix/shared_memory.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::uint32_t written = 0x80000000;  // in a run: its pages are writable

std::size_t pages_of(std::uint64_t bytes, std::size_t page) {
  return static_cast<std::size_t>((bytes + page - 1) / page);
}

}  // namespace

Expected<std::unique_ptr<PrivateViews>> PrivateViews::create(posix::Mapping mapping,
                                                             WriteListener* listener) {
  std::unique_ptr<PrivateViews> views(new PrivateViews(std::move(mapping), listener));
  if (views->runs_) return {std::move(views)};
  Error error;
  error.what = "keep account of the pages of a received segment: out of memory";
  return error;
}

// calloc: pages of the account that are not needed are never touched.
PrivateViews::PrivateViews(posix::Mapping mapping, WriteListener* listener)
    : mapping_(std::move(mapping)),
      page_(posix::page_size()),
      listener_(listener),
      runs_(static_cast<Run*>(std::calloc(pages_of(mapping_.size(), page_), sizeof(Run)))) {
  if (runs_) watched_ = posix::watch_write_faults(mapping_.data(), mapping_.size(), *this);
}

PrivateViews::~PrivateViews() {
  if (watched_) posix::forget_write_faults(mapping_.data());
}

bool PrivateViews::begin(std::uint64_t offset, std::uint64_t bytes) {
  std::uint32_t none = 0;
  const auto pages = static_cast<std::uint32_t>(pages_of(bytes, page_));
  if (!watched_) return false;
  return runs_[offset / page_].compare_exchange_strong(none, pages, std::memory_order_acq_rel);
}

bool PrivateViews::end(std::uint64_t offset, std::uint64_t bytes) {
  const bool was_written = is_written(offset);
  if (was_written) restore(mapping_.data() + offset, pages_of(bytes, page_) * page_);
  runs_[offset / page_].store(0, std::memory_order_release);
  return was_written;
}

bool PrivateViews::is_written(std::uint64_t offset) const {
  return (runs_[offset / page_].load(std::memory_order_acquire) & written) != 0;
}

// Locked pages (mlockall) are not dropped: they are unlocked for that.
void PrivateViews::restore(std::uint8_t* begin, std::size_t bytes) const {
  ::mprotect(begin, bytes, PROT_READ);
  if (::madvise(begin, bytes, MADV_DONTNEED) == 0) return;
  ::munlock(begin, bytes);
  ::madvise(begin, bytes, MADV_DONTNEED);
  ::mlock(begin, bytes);
}

template <class Visit>
void PrivateViews::for_each_view(Visit visit) const noexcept {
  const std::size_t all = mapping_.size() / page_;
  for (std::size_t first = 0; first < all;) {
    const std::size_t pages = runs_[first].load(std::memory_order_acquire) & ~written;
    if (pages != 0) visit(first, pages);
    first += pages != 0 ? pages : 1;
  }
}

bool PrivateViews::has_views() const noexcept {
  bool found = false;
  for_each_view([&found](std::size_t, std::size_t) { found = true; });
  return found;
}

// Of a view that was written to, too: only the pages that were are copies already.
bool PrivateViews::copy_in_child() noexcept {
  bool all = true;
  for_each_view([this, &all](std::size_t first, std::size_t pages) {
    runs_[first].fetch_or(written, std::memory_order_acq_rel);
    const bool writable =
        ::mprotect(mapping_.data() + first * page_, pages * page_, PROT_READ | PROT_WRITE) == 0;
    if (writable) mapping_.populate(first * page_, pages * page_);
    all = all && writable;
  });
  return all;
}

bool PrivateViews::make_writable(const posix::WriteFault& fault) noexcept {
  const auto faulted = static_cast<std::size_t>(fault.address - mapping_.data()) / page_;
  for (std::size_t first = faulted + 1; first-- > 0;) {
    const std::uint32_t run = runs_[first].load(std::memory_order_acquire);
    if (run == 0) continue;
    const std::size_t pages = run & ~written;
    if (faulted - first >= pages) return false;
    runs_[first].fetch_or(written, std::memory_order_acq_rel);
    if (listener_ != nullptr) listener_->first_write();
    return ::mprotect(mapping_.data() + first * page_, pages * page_, PROT_READ | PROT_WRITE) == 0;
  }
  return false;
}

namespace {

// Without a fault, at which a debugger would stop in every program: what a system may refuse are the other steps.
bool write_and_drop(const posix::MemoryFile& file, const std::uint8_t* original) {
  auto mapping = posix::Mapping::map(file.shared_fd(), file.size, posix::Access::read_private);
  if (!mapping) return false;
  auto views = PrivateViews::create(std::move(*mapping), nullptr);
  if (!views || !(*views)->begin(0, file.size)) return false;
  auto* view = const_cast<std::uint8_t*>((*views)->data());
  if (view[0] != 1 || !(*views)->make_writable(posix::WriteFault{view, nullptr})) return false;
  view[0] = 2;
  if (original[0] != 1) return false;
  return (*views)->end(0, file.size) && view[0] == 1;
}

bool try_private_pages() {
  const std::size_t size = posix::page_size();
  const auto memory = posix::create_shared_memory("tzc-self-check", size, size, posix::Sharing::peers_read);
  if (!memory) return false;
  memory->mapping.data()[0] = 1;
  return write_and_drop(memory->file, memory->mapping.data());
}

}  // namespace

// A forked child may have entered a sandbox since.
bool can_make_private_pages() {
  static std::mutex mutex;
  static bool possible = try_private_pages();
  static std::uint32_t epoch = posix::fork_epoch();
  const std::lock_guard<std::mutex> lock(mutex);
  if (posix::forked_since(epoch)) possible = try_private_pages();
  epoch = posix::fork_epoch();
  return possible;
}

}  // namespace segment
}  // namespace tzc
