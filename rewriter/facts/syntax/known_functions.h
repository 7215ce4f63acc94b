// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// The known effects of functions on a pointer argument: known_functions.def holds the table and its terms.
enum class Keeping { unknown, nothing, nothing_and_result_is_new };

Keeping keeping_of(const std::string& function);
bool is_view_class(const std::string& name);
bool is_owner_class(const std::string& name);
bool calls_nothing(const std::string& function);
/// Each call comes back: it throws nothing but for want of memory.
bool always_returns(const std::string& function);
bool is_quiet_function(const std::string& function);
/// Its callbacks run one at a time.
bool runs_one_at_a_time(const std::string& function);
/// A function, or a class by its constructor.
bool makes_thread(const std::string& name);

}  // namespace tzc::rewriter
