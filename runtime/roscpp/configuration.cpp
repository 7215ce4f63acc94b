// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/configuration.h"

#include <ros/console.h>
#include <ros/param.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace tzc {
namespace {

/// All settings as text: ROS parameters win over the environment, both over the code.
using Settings = std::map<std::string, std::string>;

struct Variable {
  const char* environment;
  const char* parameter;  ///< below ~tzc
};
constexpr Variable kVariables[] = {
    {"TZC_DISABLE", "disable"},           {"TZC_DISABLE_TOPICS", "disable_topics"},
    {"TZC_MEMORY_SIZE", "memory_size"},   {"TZC_POLICY", "policy"},
    {"TZC_ATTEMPTS", "attempts"},         {"TZC_PREFAULT", "prefault"},
    {"TZC_ON_EXHAUSTED", "on_exhausted"}, {"TZC_TRIES", "tries"},
};

/// Whole numbers as such: one beyond 2^31, which XMLRPC's integers cannot hold, comes as a double.
std::string to_text(double number) {
  std::ostringstream text;
  if (number == std::floor(number)) text << std::fixed << std::setprecision(0);
  text << number;
  return text.str();
}

std::string to_text(XmlRpc::XmlRpcValue& value) {
  using XmlRpc::XmlRpcValue;
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

Settings read_settings() {
  Settings settings;
  XmlRpc::XmlRpcValue parameters;
  const bool has_parameters =
      ros::param::get("~tzc", parameters) && parameters.getType() == XmlRpc::XmlRpcValue::TypeStruct;
  for (const Variable& variable : kVariables) {
    if (const char* text = std::getenv(variable.environment)) settings[variable.parameter] = text;
    if (has_parameters && parameters.hasMember(variable.parameter))
      settings[variable.parameter] = to_text(parameters[variable.parameter]);
  }
  return settings;
}

const Settings& settings() {
  static const Settings instance = read_settings();
  return instance;
}

const std::string* find(const char* name) {
  const auto found = settings().find(name);
  return found == settings().end() || found->second.empty() ? nullptr : &found->second;
}

bool is_true(const std::string& text) {
  return text != "0" && text != "false";
}

/// Blanks are no part of a name.
std::set<std::string> split(std::string list) {
  std::replace(list.begin(), list.end(), ',', ' ');
  std::set<std::string> items;
  std::istringstream stream(list);
  for (std::string item; stream >> item;) items.insert(item);
  return items;
}

/// Sets `option` to what `text` names; warns about a name that is none.
template <class Option>
void choose(const char* name, const std::map<std::string, Option>& choices, Option& option) {
  const std::string* text = find(name);
  if (!text) return;
  const auto found = choices.find(*text);
  if (found != choices.end())
    option = found->second;
  else
    ROS_WARN_STREAM_ONCE("TZC: ~tzc/" << name << " can't be '" << *text
                                      << "' (see docs/configuration.md); ignored");
}

template <class Number>
void read_number(const char* name, Number& number) {
  const std::string* text = find(name);
  if (!text) return;
  char* end = nullptr;
  const unsigned long long parsed = std::strtoull(text->c_str(), &end, 10);
  if (*end == '\0' && text->front() != '-')
    number = static_cast<Number>(parsed);
  else
    ROS_WARN_STREAM_ONCE("TZC: ~tzc/" << name << " must be a whole number, not '" << *text << "'; ignored");
}

}  // namespace

bool is_enabled(const std::string& topic) {
  const std::string* disable = find("disable");
  if (disable && is_true(*disable)) return false;
  const std::string* topics = find("disable_topics");
  return !topics || split(*topics).count(topic) == 0;
}

int most_tries() {
  int tries = 10;
  read_number("tries", tries);
  return tries;
}

/// Another policy than the code's comes with its own number of attempts: the code's may be none at all.
static Policy configured(const Policy& in_code) {
  PolicyKind kind = in_code.kind;
  choose<PolicyKind>("policy",
                     {{"best_effort", PolicyKind::best_effort},
                      {"medium_effort", PolicyKind::medium_effort},
                      {"worst_effort", PolicyKind::worst_effort}},
                     kind);
  Policy policy = kind == in_code.kind ? in_code : Policy();
  policy.kind = kind;
  read_number("attempts", policy.attempts);
  return policy;
}

PublisherOptions configured(const PublisherOptions& in_code) {
  PublisherOptions options = in_code;
  read_number("memory_size", options.memory_size);
  options.policy = configured(in_code.policy);
  choose<Prefault>(
      "prefault",
      {{"none", Prefault::none}, {"on_first_use", Prefault::on_first_use}, {"all", Prefault::all}},
      options.prefault);
  choose<OnExhausted>("on_exhausted", {{"deliver", OnExhausted::deliver}, {"drop", OnExhausted::drop}},
                      options.on_exhausted);
  return options;
}

}  // namespace tzc
