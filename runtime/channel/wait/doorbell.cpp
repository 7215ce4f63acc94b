// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/doorbell.h"

#include <mutex>
#include <new>
#include <utility>

#include "channel/wait/weak_map.h"
#include "posix/futex.h"
#include "posix/shared_memory.h"

namespace tzc {
namespace channel {
namespace {

/// The doorbells of other processes that this one has mapped. Thread-safe.
class OpenDoorbells {
 public:
  Expected<std::shared_ptr<Doorbell>> find_or_map(const posix::FileIdentity& file, int fd, std::size_t size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (auto known = open_.find(file)) return {std::move(known)};
    auto mapping = posix::Mapping::map(fd, size, posix::Access::read_write);
    if (!mapping) return mapping.error();
    auto doorbell = std::make_shared<Doorbell>(std::move(*mapping));
    open_.keep(file, doorbell);
    return {std::move(doorbell)};
  }

 private:
  std::mutex mutex_;
  WeakMap<posix::FileIdentity, Doorbell> open_;
};

OpenDoorbells& open_doorbells() {
  static auto* const one = new OpenDoorbells;  // never destroyed: the service thread runs until the end
  return *one;
}

}  // namespace

Expected<std::shared_ptr<Doorbell>> Doorbell::create() {
  const std::size_t size = posix::page_size();
  auto memory = posix::create_shared_memory("tzc-doorbell", size, size, posix::Sharing::peers_write);
  if (!memory) return memory.error();
  auto doorbell = std::make_shared<Doorbell>(std::move(memory->mapping));
  doorbell->file_ = std::move(memory->file);
  new (doorbell->mapping_.data()) DoorbellPage;
  return {std::move(doorbell)};
}

Expected<std::shared_ptr<Doorbell>> Doorbell::open(posix::FileDescriptor file, std::size_t size) {
  Error wrong;
  wrong.what = "refuse a doorbell of " + std::to_string(size) + " bytes";
  if (size < sizeof(DoorbellPage) || size > (std::size_t{1} << 20)) return wrong;
  const Status checked = posix::check_received(file.get(), size, posix::Sharing::peers_write);
  if (!checked) return checked.error();
  const auto identity = posix::identify(file.get());
  if (!identity) return identity.error();
  return open_doorbells().find_or_map(*identity, file.get(), size);
}

void Doorbell::ring(std::uint32_t number) {
  DoorbellPage& at = page();
  DoorbellWords<std::atomic<std::uint32_t>&, std::atomic<std::uint64_t>&> words{
      at.bell, at.sleeping, at.groups, at.leaves[number / 64]};
  ring_doorbell(words, number, [&at](std::uint32_t sleeper) { posix::wake_sleeper(at.bell, sleeper); });
}

}  // namespace channel
}  // namespace tzc
