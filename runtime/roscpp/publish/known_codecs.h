// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/codec.h>

#include <list>
#include <mutex>
#include <typeinfo>

namespace tzc {
namespace detail {

/// The codecs of the types that are published on a topic. Thread-safe.
class KnownCodecs {
 public:
  /// One that is known already is left as it is.
  void add(const MessageCodec& codec);
  bool has(const std::type_info& type) const { return find(type) != nullptr; }
  /// Null when the type is not known; otherwise valid while this object lives.
  const MessageCodec* find(const std::type_info& type) const;
  /// The one that was added first; null: none was.
  const MessageCodec* first() const;

 private:
  mutable std::mutex mutex_;
  std::list<MessageCodec> codecs_;  ///< only ever grows, so addresses stay valid
};

}  // namespace detail
}  // namespace tzc
