// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sweep.h"

namespace tzc {
namespace bench {

/// Every contender that this program was built with, in the order of the tables: a new one is a line in the .cpp file.
Contenders all_contenders();

/// What is measured in real time: TZC's core, Ach's way, and a bare wake-up.
Contenders real_time_contenders();

/// The versions of what they use, by name.
nlohmann::json contender_versions();

/// "tcpros, tzc": for messages.
std::string names_of(const Contenders& contenders);

/// The contender of this name; null: there is none.
Contender* find_contender(const Contenders& contenders, const std::string& name);

}  // namespace bench
}  // namespace tzc
