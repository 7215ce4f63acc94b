// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/descriptor_budget.h"

namespace tzc {
namespace detail {

std::string descriptor_advice() {
  return "more than seven eighths of the " + std::to_string(channel::descriptor_limit()) +
         " file descriptors that this process may have are in use, and the others are left to roscpp; raise "
         "the limit (ulimit -n)";
}

}  // namespace detail
}  // namespace tzc
