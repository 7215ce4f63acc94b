// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/configuration.h"

#include <ros/console.h>
#include <ros/param.h>
#include <tzc/process_memory.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <sstream>

#include "roscpp/roscpp_version.h"
#include "roscpp/settings.h"

namespace tzc {
namespace detail {
namespace {

using XmlRpc::XmlRpcValue;

/// In bytes. What is more was a negative number before its conversion.
constexpr std::size_t kMostMemory = std::numeric_limits<std::ptrdiff_t>::max();

/// Whole numbers as such: one beyond 2^31, which XMLRPC's integers cannot hold, comes as a double.
std::string to_text(double number) {
  std::ostringstream text;
  if (number == std::floor(number)) text << std::fixed << std::setprecision(0);
  text << number;
  return text.str();
}

std::string to_text(XmlRpcValue& value) {
  std::ostringstream text;
  if (value.getType() == XmlRpcValue::TypeString) return static_cast<std::string>(value);
  if (value.getType() == XmlRpcValue::TypeDouble) return to_text(static_cast<double>(value));
  if (value.getType() == XmlRpcValue::TypeArray) {
    for (int i = 0; i < value.size(); ++i) text << (i ? "," : "") << to_text(value[i]);
  } else {
    text << value;
  }
  return text.str();
}

void read_environment(SettingTexts& texts) {
  std::map<std::string, std::string> settings;  // by the environment's name
  for (const std::string& name : setting_names()) settings[environment_name(name)] = name;
  for (char** variable = environ; variable && *variable; ++variable) {
    const std::string text = *variable;
    const std::string name = text.substr(0, text.find('='));
    if (name.compare(0, 4, "TZC_") != 0) continue;
    if (const auto setting = settings.find(name); setting != settings.end())
      texts.environment[setting->second] = text.substr(std::min(name.size() + 1, text.size()));
    else
      texts.other_variables.push_back(name);
  }
}

SettingTexts read_texts(std::vector<std::string>& warnings) {
  SettingTexts texts;
  read_environment(texts);
  XmlRpcValue parameters;
  if (!ros::param::get("~tzc", parameters)) return texts;
  if (parameters.getType() == XmlRpcValue::TypeStruct)
    for (auto& parameter : parameters) texts.parameters[parameter.first] = to_text(parameter.second);
  else
    warnings.push_back("~tzc is '" + to_text(parameters) +
                       "' and is ignored: TZC's parameters lie below it, as in ~tzc/memory_size");
  return texts;
}

Settings read_settings() {
  std::vector<std::string> warnings;
  const SettingTexts texts = read_texts(warnings);
  const Settings settings = parse_settings(texts, warnings);
  for (const std::string& warning : warnings)
    ROS_WARN_STREAM("TZC: " << warning << " (share/doc/tzc/configuration.md)");
  if (settings.memory_ceiling.value_or(0) != 0) set_memory_ceiling(*settings.memory_ceiling);
  return settings;
}

std::atomic<bool> are_read{false};

const Settings& settings() {
  static const Settings instance = read_settings();
  are_read = true;
  return instance;
}

}  // namespace

bool is_enabled(const std::string& topic) {
  return !settings().disable && settings().disable_topics.count(topic) == 0 && is_roscpp_known();
}

bool is_left_out(const std::string& topic) {
  return !settings().disable && settings().disable_topics.count(topic) != 0 && is_roscpp_known();
}

bool are_settings_read() {
  return are_read;
}

bool private_writes() {
  return settings().private_writes;
}

int upgrade_attempts_until_warning() {
  return settings().upgrade_attempts;
}

bool has_statistics_page() {
  return settings().statistics_page;
}

PublisherOptions configured(const PublisherOptions& in_code, const std::string& topic) {
  PublisherOptions options = overridden(in_code, settings());
  if (options.memory_size <= kMostMemory) return options;
  ROS_WARN_STREAM("TZC: " << topic << ": a memory size of " << options.memory_size
                          << " bytes cannot be meant (is it a negative number?); the memory sizes itself");
  options.memory_size = 0;
  return options;
}

}  // namespace detail
}  // namespace tzc
