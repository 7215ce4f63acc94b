// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/settings.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "roscpp/near_word.h"

namespace tzc {
namespace detail {
namespace {

/// A setting's text, and where it was set, for warnings.
struct Entry {
  const std::string& text;
  std::string place;  ///< "~tzc/policy", "TZC_POLICY"
  std::vector<std::string>& warnings;

  void refuse(const std::string& why) const {
    warnings.push_back(place + " cannot be '" + text + "': " + why + "; it is ignored");
  }
};

template <class Option>
struct Word {
  const char* word;
  Option option;
};

template <class Option, std::size_t size>
void read(const Entry& entry, const Word<Option> (&words)[size], std::optional<Option>& option) {
  std::vector<std::string> valid;
  for (const Word<Option>& one : words) {
    if (entry.text == one.word) option = one.option;
    if (entry.text == one.word) return;
    valid.push_back(one.word);
  }
  entry.refuse("it is one of " + listed(valid) + did_you_mean(entry.text, valid));
}

constexpr Word<PolicyKind> kPolicies[] = {{"best_effort", PolicyKind::best_effort},
                                          {"medium_effort", PolicyKind::medium_effort},
                                          {"worst_effort", PolicyKind::worst_effort}};
constexpr Word<Prefault> kPrefaults[] = {
    {"none", Prefault::none}, {"on_first_use", Prefault::on_first_use}, {"all", Prefault::all}};
constexpr Word<OnExhausted> kOnExhausted[] = {{"deliver", OnExhausted::deliver}, {"drop", OnExhausted::drop}};
constexpr Word<bool> kSwitches[] = {{"0", false},  {"1", true},   {"false", false}, {"true", true},
                                    {"no", false}, {"yes", true}, {"off", false},   {"on", true}};

/// The power of two of a size's suffix: K, M or G, perhaps with B or iB. -1: not a suffix.
int suffix_bits(std::string suffix) {
  for (const char* end : {"iB", "B"})
    if (suffix.size() > 1 && suffix.substr(1) == end) suffix.resize(1);
  const std::string letters = "KMG";
  const std::size_t place = suffix.empty() ? 0 : letters.find(static_cast<char>(suffix[0] & ~0x20));
  if (suffix.empty() || suffix == "B") return 0;
  return suffix.size() == 1 && place != std::string::npos ? static_cast<int>(10 * (place + 1)) : -1;
}

/// A whole number of digits alone, at most 64 bits.
std::optional<std::uint64_t> parse_digits(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::uint64_t number = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || number > (std::numeric_limits<std::uint64_t>::max() - 9) / 10)
      return std::nullopt;
    number = 10 * number + static_cast<std::uint64_t>(c - '0');
  }
  return number;
}

void read_size(const Entry& entry, std::optional<std::size_t>& option) {
  const std::size_t digits = std::min(entry.text.find_first_not_of("0123456789"), entry.text.size());
  const std::optional<std::uint64_t> number = parse_digits(entry.text.substr(0, digits));
  const int bits = suffix_bits(entry.text.substr(digits));
  if (number && bits >= 0 && *number <= std::numeric_limits<std::size_t>::max() >> bits)
    option = static_cast<std::size_t>(*number) << bits;
  else
    entry.refuse("it must be a whole number of bytes, or one with K, M or G behind it (64M)");
}

template <class Number>
void read_number(const Entry& entry, Number& option) {
  const std::optional<std::uint64_t> number = parse_digits(entry.text);
  if (number && *number <= static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    option = static_cast<Number>(*number);
  else
    entry.refuse("it must be a whole number");
}

void read_switch(const Entry& entry, bool& setting) {
  std::optional<bool> given;
  read(entry, kSwitches, given);
  setting = given.value_or(setting);
}

/// Blanks and commas are no part of a topic's name. Nobody knows here which namespace a relative one is meant in.
void read_topics(const Entry& entry, Settings& settings) {
  std::string list = entry.text;
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream stream(list);
  for (std::string topic; stream >> topic;) {
    if (topic[0] == '/')
      settings.disable_topics.insert(topic);
    else
      entry.warnings.push_back(
          entry.place + " names the topic '" + topic +
          "', which is ignored: write the resolved name, with a slash in front, as rostopic list shows it");
  }
}

void read_policy_attempts(const Entry& entry, Settings& settings) {
  unsigned attempts = settings.policy_attempts.value_or(0);
  const std::size_t before = entry.warnings.size();
  read_number(entry, attempts);
  if (entry.warnings.size() == before) settings.policy_attempts = attempts;
}

struct Setting {
  const char* name;
  const char* old_name;  ///< accepted for one release, with a warning; null: none
  void (*read)(const Entry&, Settings&);
};

constexpr Setting kSettings[] = {
    {"disable", nullptr, [](const Entry& entry, Settings& s) { read_switch(entry, s.disable); }},
    {"disable_topics", nullptr, read_topics},
    {"private_writes", nullptr,
     [](const Entry& entry, Settings& s) { read_switch(entry, s.private_writes); }},
    {"statistics_page", nullptr,
     [](const Entry& entry, Settings& s) { read_switch(entry, s.statistics_page); }},
    {"memory_size", nullptr, [](const Entry& entry, Settings& s) { read_size(entry, s.memory_size); }},
    {"memory_ceiling", nullptr, [](const Entry& entry, Settings& s) { read_size(entry, s.memory_ceiling); }},
    {"policy", nullptr, [](const Entry& entry, Settings& s) { read(entry, kPolicies, s.policy); }},
    {"policy_attempts", "attempts", read_policy_attempts},
    {"prefault", nullptr, [](const Entry& entry, Settings& s) { read(entry, kPrefaults, s.prefault); }},
    {"on_exhausted", nullptr,
     [](const Entry& entry, Settings& s) { read(entry, kOnExhausted, s.on_exhausted); }},
    {"upgrade_attempts", "tries",
     [](const Entry& entry, Settings& s) { read_number(entry, s.upgrade_attempts); }},
};

using Texts = std::map<std::string, std::string>;

/// The text of a setting in one of its two places, under its name or its old one; null when it is not set there.
const std::string* find(const Texts& texts, const Setting& setting, std::string& name) {
  for (const char* one : {setting.name, setting.old_name}) {
    const auto found = one ? texts.find(one) : texts.end();
    if (found == texts.end() || found->second.empty()) continue;
    name = one;
    return &found->second;
  }
  return nullptr;
}

void read_setting(const SettingTexts& texts, const Setting& setting, Settings& settings,
                  std::vector<std::string>& warnings) {
  std::string name;
  const std::string* parameter = find(texts.parameters, setting, name);
  const std::string* text = parameter ? parameter : find(texts.environment, setting, name);
  if (!text) return;
  const auto place = [&](const std::string& of) { return parameter ? "~tzc/" + of : environment_name(of); };
  if (name != setting.name)
    warnings.push_back(place(name) + " is now called " + place(setting.name) +
                       "; the old name will go with the next release");
  setting.read(Entry{*text, place(name), warnings}, settings);
}

void warn_of_unknown(const Texts& parameters, std::vector<std::string>& warnings) {
  const std::vector<std::string> known = setting_names();
  for (const auto& parameter : parameters)
    if (std::find(known.begin(), known.end(), parameter.first) == known.end())
      warnings.push_back("~tzc/" + parameter.first + " is not a parameter of TZC and is ignored" +
                         did_you_mean(parameter.first, known, "~tzc/"));
}

/// Variables that libraries read by themselves.
constexpr const char* kOtherVariables[] = {"TZC_GUARD", "TZC_GUARD_QUARANTINE", "TZC_STATISTICS",
                                           "TZC_TRACE"};

/// Others may have variables of their own that begin with TZC_: only what looks like a slip is told.
void warn_of_slips(const std::vector<std::string>& variables, std::vector<std::string>& warnings) {
  std::vector<std::string> known(std::begin(kOtherVariables), std::end(kOtherVariables));
  for (const std::string& name : setting_names()) known.push_back(environment_name(name));
  for (const std::string& variable : variables) {
    const std::string hint = did_you_mean(variable, known);
    if (!hint.empty() && std::find(known.begin(), known.end(), variable) == known.end())
      warnings.push_back("the environment's " + variable + " is none of TZC's variables and is ignored" +
                         hint);
  }
}

}  // namespace

std::vector<std::string> setting_names() {
  std::vector<std::string> names;
  for (const Setting& setting : kSettings) {
    names.push_back(setting.name);
    if (setting.old_name) names.push_back(setting.old_name);
  }
  return names;
}

std::string environment_name(const std::string& setting) {
  std::string name = "TZC_";
  for (const char c : setting) name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return name;
}

Settings parse_settings(const SettingTexts& texts, std::vector<std::string>& warnings) {
  Settings settings;
  for (const Setting& setting : kSettings) read_setting(texts, setting, settings, warnings);
  warn_of_unknown(texts.parameters, warnings);
  warn_of_slips(texts.other_variables, warnings);
  return settings;
}

PublisherOptions overridden(const PublisherOptions& in_code, const Settings& settings) {
  PublisherOptions options = in_code;
  options.memory_size = settings.memory_size.value_or(in_code.memory_size);
  if (settings.policy && *settings.policy != in_code.policy.kind) options.policy = Policy();
  options.policy.kind = settings.policy.value_or(in_code.policy.kind);
  options.policy.attempts = settings.policy_attempts.value_or(options.policy.attempts);
  options.prefault = settings.prefault.value_or(in_code.prefault);
  options.on_exhausted = settings.on_exhausted.value_or(in_code.on_exhausted);
  return options;
}

}  // namespace detail
}  // namespace tzc
