// SPDX-License-Identifier: BSD-3-Clause
#include "channel/spare_descriptors.h"

#include "posix/descriptor_use.h"

namespace tzc {
namespace channel {

bool has_spare_descriptors() noexcept {
  return posix::has_spare_descriptors();
}

std::string descriptors_in_use() {
  return posix::descriptors_in_use();
}

}  // namespace channel
}  // namespace tzc
