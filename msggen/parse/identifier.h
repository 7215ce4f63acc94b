// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tzc::msggen {

/// Why the text cannot name a field, message or package, as the end of a sentence that begins with
/// the name ("is a C++ keyword"); empty when it can.
std::string identifier_fault(std::string_view name);

/// The same for a constant, which genmsg lets begin with underscores.
std::string constant_name_fault(std::string_view name);

}  // namespace tzc::msggen
