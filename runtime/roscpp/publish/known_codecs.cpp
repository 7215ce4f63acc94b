// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/known_codecs.h"

#include <algorithm>

namespace tzc {
namespace detail {

void KnownCodecs::add(const MessageCodec& codec) {
  if (has(*codec.type)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  codecs_.push_back(codec);
}

const MessageCodec* KnownCodecs::find(const std::type_info& type) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(codecs_.begin(), codecs_.end(),
                                  [&](const MessageCodec& codec) { return *codec.type == type; });
  return found == codecs_.end() ? nullptr : &*found;
}

const MessageCodec* KnownCodecs::first() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return codecs_.empty() ? nullptr : &codecs_.front();
}

}  // namespace detail
}  // namespace tzc
