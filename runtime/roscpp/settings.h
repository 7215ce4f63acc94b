// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/options.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tzc {
namespace detail {

/// The user's settings for one node (docs/configuration.md). An absent one leaves the code's value.
struct Settings {
  bool disable = false;
  bool private_writes = true;
  bool statistics_page = true;
  std::set<std::string> disable_topics;
  std::optional<std::size_t> memory_size;
  std::optional<std::size_t> memory_ceiling;  ///< of the process
  std::optional<PolicyKind> policy;
  std::optional<unsigned> policy_attempts;
  std::optional<Prefault> prefault;
  std::optional<OnExhausted> on_exhausted;
  int upgrade_attempts = 10;
};

/// Texts as they were set, by the name of the setting: parameters below ~tzc, and TZC_... of the environment under the
/// same names (TZC_MEMORY_SIZE is "memory_size").
struct SettingTexts {
  std::map<std::string, std::string> parameters;
  std::map<std::string, std::string> environment;
  std::vector<std::string> other_variables;  ///< further variables of the environment that begin with TZC_
};

/// The environment's variable of each setting, old names included: TZC_MEMORY_SIZE for "memory_size".
std::vector<std::string> setting_names();
std::string environment_name(const std::string& setting);

/// A parameter overrides the environment. A text that cannot be parsed is ignored; each such text, each
/// unknown parameter, each variable whose name is almost a setting's, and each old name adds a line to `warnings`. Pure.
Settings parse_settings(const SettingTexts& texts, std::vector<std::string>& warnings);

/// The code's options, overridden by the settings. A policy other than the code's gets that policy's default
/// number of attempts. Pure.
PublisherOptions overridden(const PublisherOptions& in_code, const Settings& settings);

}  // namespace detail
}  // namespace tzc
