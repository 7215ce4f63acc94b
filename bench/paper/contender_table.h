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

}  // namespace bench
}  // namespace tzc
