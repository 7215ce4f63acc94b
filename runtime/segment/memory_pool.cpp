// SPDX-License-Identifier: BSD-3-Clause
#include "segment/memory_pool.h"

#include <utility>

#include "posix/fork_epoch.h"
#include "posix/mapping.h"

namespace tzc {
namespace segment {
namespace {

// Address space of the file alone: more than the segments of one process can ever need.
constexpr std::size_t pool_bytes = sizeof(void*) >= 8 ? std::size_t{1} << 40 : std::size_t{1} << 30;

struct OfProcess {
  std::mutex mutex;
  std::weak_ptr<MemoryPool> pool;
  std::uint32_t epoch = posix::fork_epoch();
};

OfProcess& known() {
  static auto* const one = new OfProcess;  // never destroyed: segments may live until the end
  return *one;
}

}  // namespace

// A forked child leaves its parent's alone: its lock may be in any state.
std::shared_ptr<MemoryPool> MemoryPool::of_process() {
  OfProcess& of_process = known();
  const std::lock_guard<std::mutex> lock(of_process.mutex);
  auto pool = posix::forked_since(of_process.epoch) ? nullptr : of_process.pool.lock();
  if (pool) return pool;
  auto file = posix::create_sparse_memory_file("tzc-segments", pool_bytes);
  if (!file) return nullptr;
  pool = std::make_shared<MemoryPool>(std::move(*file));
  of_process.pool = pool;
  of_process.epoch = posix::fork_epoch();
  return pool;
}

MemoryPool::MemoryPool(posix::MemoryFile file)
    : file_(std::move(file)), epoch_(posix::fork_epoch()), free_(0, file_.size) {}

std::uint64_t MemoryPool::take(std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return free_.allocate(bytes, Extents::none, posix::page_size());
}

// The pages go first: nobody may find them in a part that is given out again.
void MemoryPool::give_back(std::uint64_t offset, std::size_t bytes) noexcept {
  if (posix::forked_since(epoch_)) return;
  posix::give_back(file_, static_cast<std::size_t>(offset), bytes);
  const std::lock_guard<std::mutex> lock(mutex_);
  free_.release(offset, bytes);
}

}  // namespace segment
}  // namespace tzc
