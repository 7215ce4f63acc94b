// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc {
namespace detail {

/// True while TZC may open further descriptors: it stops at seven eighths of the process's limit, so that descriptors
/// remain for roscpp's own sockets, which every topic needs. Thread-safe, two system calls.
bool has_spare_descriptors();

/// A text for users: why has_spare_descriptors() is false, and what to do about it.
std::string descriptor_advice();

}  // namespace detail
}  // namespace tzc
