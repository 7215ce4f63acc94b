// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/configuration.h"

#include <ros/console.h>
#include <ros/param.h>
#include <tzc/process_memory.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

#include "roscpp/roscpp_version.h"
#include "roscpp/settings.h"

namespace tzc {
namespace detail {
namespace {

using XmlRpc::XmlRpcValue;

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

SettingTexts read_texts() {
  SettingTexts texts;
  XmlRpcValue parameters;
  if (ros::param::get("~tzc", parameters) && parameters.getType() == XmlRpcValue::TypeStruct)
    for (auto& parameter : parameters) texts.parameters[parameter.first] = to_text(parameter.second);
  for (const std::string& name : setting_names())
    if (const char* text = std::getenv(environment_name(name).c_str())) texts.environment[name] = text;
  return texts;
}

Settings read_settings() {
  std::vector<std::string> warnings;
  const Settings settings = parse_settings(read_texts(), warnings);
  for (const std::string& warning : warnings)
    ROS_WARN_STREAM("TZC: " << warning << " (share/doc/tzc/configuration.md)");
  if (settings.memory_ceiling.value_or(0) != 0) set_memory_ceiling(*settings.memory_ceiling);
  return settings;
}

const Settings& settings() {
  static const Settings instance = read_settings();
  return instance;
}

}  // namespace

bool is_enabled(const std::string& topic) {
  return !settings().disable && settings().disable_topics.count(topic) == 0 && is_roscpp_known();
}

bool is_left_out(const std::string& topic) {
  return !settings().disable && settings().disable_topics.count(topic) != 0 && is_roscpp_known();
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

PublisherOptions configured(const PublisherOptions& in_code) {
  return overridden(in_code, settings());
}

}  // namespace detail
}  // namespace tzc
