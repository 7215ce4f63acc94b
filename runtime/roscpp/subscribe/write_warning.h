// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace detail {

/// Code of this node has written to a message of the topic that it received. Warns once for each topic. Any thread.
void warn_of_write(const std::string& topic);

/// This system does not let a subscriber write to pages of its own, so each message is copied. Warns once.
void warn_of_copies(const std::string& topic);

}  // namespace detail
}  // namespace tzc
