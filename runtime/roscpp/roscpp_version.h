// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

namespace tzc {
namespace detail {

/// Major, minor, patch; compared as such.
using RoscppVersion = std::array<int, 3>;

/// The versions whose private members lie where roscpp_access.h takes them to be, and whose locks are taken in the
/// order that the transport counts on: from the first up to, not including, the second. docs/versions.md says how that
/// was checked.
constexpr RoscppVersion kFirstKnownRoscpp{1, 15, 9};
constexpr RoscppVersion kFirstUnknownRoscpp{1, 18, 0};

/// "1.15.15"; what follows the third number does not matter. Nothing when there are no three numbers.
std::optional<RoscppVersion> parse_roscpp_version(const std::string& text);

/// The version of the library in that file: the end of its name (Debian: libroscpp.so.1.15.15; links are followed), or
/// ../share/roscpp/package.xml (a catkin prefix). Nothing when neither tells.
std::optional<RoscppVersion> version_of_library(const std::string& path);

/// Why TZC must not touch private members: the version it was compiled for or the one that the process runs on is not
/// known. Empty: it may. A library that does not tell is taken to be the one that belongs to the headers. Pure.
std::string reason_to_leave_alone(const RoscppVersion& headers, const std::optional<RoscppVersion>& library);

/// The roscpp of this process is one that TZC knows. When it is not, the first call warns, and every topic has to stay
/// on TCPROS. Thread-safe.
bool is_roscpp_known();
/// The same without a word, while the library is loaded and there is no log yet.
bool is_roscpp_known_so_early();

}  // namespace detail
}  // namespace tzc
