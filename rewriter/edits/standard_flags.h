// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// -std=..., or --std=..., which compilers take for the same.
bool is_standard_flag(const std::string& word);

/// The flag with C++14 in place of an older standard ("-std=gnu++11" to "-std=gnu++14"); others as they are.
/// The port raises what the build files ask for in the same way.
std::string raised_standard(const std::string& flag);

/// Whether the flag names a standard before C++14.
inline bool is_old_standard(const std::string& flag) {
  return raised_standard(flag) != flag;
}

/// Whether the flag names C++98, C++03 or what was to become C++11: later standards reject some of their code.
bool is_before_cxx11(const std::string& flag);

}  // namespace tzc::rewriter
