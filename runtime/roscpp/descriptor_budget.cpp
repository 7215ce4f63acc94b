// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/descriptor_budget.h"

namespace tzc {
namespace detail {

std::string descriptor_advice() {
  return channel::descriptors_in_use() + ", and the others are left to roscpp; raise the limit (ulimit -n)";
}

}  // namespace detail
}  // namespace tzc
