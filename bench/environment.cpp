// SPDX-License-Identifier: BSD-3-Clause
#include "environment.h"

#include <cstdlib>

#include "command_line/arguments.h"

namespace tzc {
namespace bench {
namespace {

// Others may have variables of their own that begin with TZC_.
constexpr const char* variables[] = {
    "TZC_DISABLE",          "TZC_DISABLE_TOPICS", "TZC_PRIVATE_WRITES",   "TZC_STATISTICS_PAGE",
    "TZC_MEMORY_SIZE",      "TZC_MEMORY_CEILING", "TZC_POLICY",           "TZC_POLICY_ATTEMPTS",
    "TZC_ATTEMPTS",         "TZC_TRIES",          "TZC_PREFAULT",         "TZC_ON_EXHAUSTED",
    "TZC_UPGRADE_ATTEMPTS", "TZC_GUARD",          "TZC_GUARD_QUARANTINE", "TZC_TRACE",
    "TZC_STATISTICS"};

}  // namespace

std::string settings_of_environment() {
  std::string settings;
  for (const char* variable : variables) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || *value == '\0') continue;
    settings += (settings.empty() ? "" : ", ") + std::string(variable) + "=" + value;
  }
  return settings;
}

std::string refused_settings() {
  const std::string settings = settings_of_environment();
  return settings.empty() ? ""
                          : "the environment has " + settings +
                                ", which would change the figures: unset it, or give " + keep_settings;
}

void add_keep_settings(CLI::App& app) {
  app.add_flag(keep_settings,
               "measure with the TZC_ variables of the environment, which are refused otherwise");
  app.callback([&app] {
    const std::string why = app.count(keep_settings) == 0 ? refused_settings() : "";
    if (!why.empty()) throw CLI::ValidationError(why);
  });
}

}  // namespace bench
}  // namespace tzc
