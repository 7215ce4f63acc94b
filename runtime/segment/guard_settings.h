// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace guard {

/// What follows the report of a late access.
enum class Action { none, go_on, abort };

/// What TZC_GUARD says; none: guard mode is off.
Action action() noexcept;

}  // namespace guard
}  // namespace tzc
