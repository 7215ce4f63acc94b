// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tzc {
namespace bench {

/// TZC's settings in the environment, of docs/configuration.md: "TZC_GUARD=1, TZC_POLICY=best_effort".
std::string settings_of_environment();

/// The option below.
constexpr char keep_settings[] = "--keep-settings";

/// What to say of settings that nobody asked to measure with, and that would change the figures unseen; empty: there are none.
std::string refused_settings();

/// Adds --keep-settings. Without it parsing fails where refused_settings has something to say. For a command whose app has no
/// callback.
void add_keep_settings(CLI::App& app);

}  // namespace bench
}  // namespace tzc
