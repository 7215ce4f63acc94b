// SPDX-License-Identifier: BSD-3-Clause
#include "channel/spare_descriptors.h"

#include "posix/descriptor_use.h"

namespace tzc {
namespace channel {

std::size_t descriptor_limit() noexcept {
  return posix::descriptor_limit();
}

bool has_spare_descriptors() noexcept {
  return posix::has_spare_descriptors();
}

}  // namespace channel
}  // namespace tzc
