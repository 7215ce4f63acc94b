// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "posix/mapping.h"
#include "posix/write_fault.h"
#include "tzc/error.h"

namespace tzc {
namespace segment {

/// Told that this process writes to a received payload.
class WriteListener {
 public:
  /// At the first write to a view. In a signal handler: async-signal-safe.
  virtual void first_write() noexcept = 0;

 protected:
  ~WriteListener() = default;
};

/// A mapping of a segment in which views of payloads lie: read-only and private. When code of this process
/// writes to a view nevertheless, the pages of that payload become writable, and the kernel copies them: no other
/// process sees a byte of it, and nothing crashes. Before the payload is acknowledged its pages are protected again and
/// the copies dropped. A payload that is not written to costs one store at its begin and one at its end. Who shows a view to
/// the program's code calls posix::keep_watching_write_faults() before.
///
/// begin and end: any thread, for one payload not at the same time.
class PrivateViews final : public posix::WriteFaultArea {
 public:
  /// `mapping`: read-only and private. `listener` lives as long as any view; null: none. Error: no memory.
  static Expected<std::unique_ptr<PrivateViews>> create(posix::Mapping mapping, WriteListener* listener);
  ~PrivateViews();

  const std::uint8_t* data() const { return mapping_.data(); }
  /// A view of a payload, which begins on a page, is made. False: another one lives, or writes cannot be noticed (too
  /// many segments), so this needs memory of its own.
  bool begin(std::uint64_t offset, std::uint64_t bytes);
  /// The view is gone. True: it was written to; the memory is the publisher's again.
  bool end(std::uint64_t offset, std::uint64_t bytes);
  /// Whether the view that begins there was written to until now.
  bool is_written(std::uint64_t offset) const;

  bool has_views() const noexcept;
  /// In a forked child: every view is a copy from now on, whatever becomes of the memory. False: the system refuses that.
  bool copy_in_child() noexcept;

  bool make_writable(const posix::WriteFault& fault) noexcept override;

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  using Run = std::atomic<std::uint32_t>;

  PrivateViews(posix::Mapping mapping, WriteListener* listener);
  void restore(std::uint8_t* begin, std::size_t bytes) const;
  template <class Visit>
  void for_each_view(Visit visit) const noexcept;

  const posix::Mapping mapping_;
  const std::size_t page_;
  WriteListener* const listener_;
  std::unique_ptr<Run[], Free> runs_;  // for each page: 0, or how many pages the view has that begins there
  bool watched_ = false;
};

/// Whether this system lets a process write to pages of its own in a file that it cannot write to, and drop them again:
/// tried once in each process, on a file of its own. A sandbox may refuse the system calls.
bool can_make_private_pages();

}  // namespace segment
}  // namespace tzc
