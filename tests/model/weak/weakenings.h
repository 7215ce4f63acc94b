// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "weak/explorer.h"

namespace tzc {
namespace model {
namespace weak {

struct Scenario {
  std::string name;
  std::function<Explorer()> explorer;
};

/// What the explorations run on, in words.
struct Names {
  std::vector<std::string> threads;
  std::vector<std::string> locations;
};

/// A weakening that no scenario notices, and why it is not made.
struct Spare {
  std::string weakening;  // as it is printed
  std::string reason;
};

/// Explores every scenario; then weakens, one at a time, each memory order that the code under test asked for, and
/// demands that a scenario fails, unless it is listed as spare; then it must not. Returns the number of failures.
int explore_with_weakenings(const std::vector<Scenario>& scenarios, const Names& names,
                            const std::vector<Spare>& spares);

}  // namespace weak
}  // namespace model
}  // namespace tzc
