// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "segment/ack_file.h"
#include "segment/block.h"

namespace tzc {
namespace segment {

/// Takes back what is in flight to a subscriber: the channel's connections.
class Revoker {
 public:
  virtual ~Revoker() = default;
  /// Revokes each record that refers to the block and was not taken yet, and those sent before it.
  virtual void revoke(const BlockName& block) = 0;
  /// Revokes what is in flight by the grace of PublisherOptions::buffered_bytes.
  virtual void revoke_buffered() = 0;
  /// Adds the addresses of the handles of the block that records have which were not written yet, until they are revoked. A record has
  /// one for each time that it names the block, and connections share records.
  virtual void add_waiting(const BlockName& block, std::vector<const void*>& handles) const = 0;
};

/// The subscribers that know a segment, and what they hold of it. Thread-safe.
class Holders {
 public:
  void attach(const std::shared_ptr<AckFile>& ack_file, const std::weak_ptr<Revoker>& revoker);
  void detach(const std::shared_ptr<AckFile>& ack_file);

  /// A subscriber may read the block, now or once it takes it.
  bool hold(const BlockName& block) const;
  /// A subscriber took the block and did not release it yet.
  bool have_taken(const BlockName& block) const;
  /// Asks every connection that may have the block in flight to revoke it.
  void revoke(const BlockName& block) const;
  void revoke_buffered() const;
  /// How many handles of the block the records have that wait in this process to be written, to one subscriber or several.
  std::size_t waiting_handles(const BlockName& block) const;
  /// A slot that some subscriber says it released something of; no_slot: no more now. For the allocator alone.
  std::uint32_t next_released();
  std::size_t count() const;

 private:
  std::vector<std::shared_ptr<Revoker>> revokers() const;

  struct Holder {
    std::shared_ptr<AckFile> ack_file;
    std::weak_ptr<Revoker> revoker;
  };

  mutable std::mutex mutex_;
  std::vector<Holder> holders_;
  std::size_t next_ = 0;  // to be asked for what it released: in turns, or one could keep the others from it
};

}  // namespace segment
}  // namespace tzc
