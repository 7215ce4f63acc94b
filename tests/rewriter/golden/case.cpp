// SPDX-License-Identifier: BSD-3-Clause
#include "golden/case.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "edits/apply.h"

namespace tzc::rewriter::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string commented(const std::string& line) {
  return line.empty() ? "//\n" : "// " + line + "\n";
}

const char* name(Level level) {
  static const char* const names[] = {"zero_copy", "one_copy", "plain", "not_needed", "shared", "copied"};
  return names[static_cast<int>(level)];
}

const char* name(SiteKind kind) {
  static const char* const names[] = {"advertise", "publish", "subscribe"};
  return names[static_cast<int>(kind)];
}

/// Lines that differ, by longest common subsequence.
std::string changed_lines(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::vector<int>> best(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      best[i][j] = a[i] == b[j] ? best[i + 1][j + 1] + 1 : std::max(best[i + 1][j], best[i][j + 1]);
  std::string text;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      ++i, ++j;
    } else if (i < a.size() && (j == b.size() || best[i + 1][j] >= best[i][j + 1])) {
      text += commented("-" + a[i++]);
    } else {
      text += commented("+" + b[j++]);
    }
  }
  return text;
}

std::string relative(const Package& package, const std::string& file) {
  return file.substr(package.dir().size() + 1);
}

std::string describe_sites(const Package& package, const PortPlan& plan) {
  std::string text;
  for (const Site& site : plan.report.sites) {
    std::string line = std::string(name(site.kind)) + " " + relative(package, site.where.file) + ":" +
                       std::to_string(site.where.line) + " " + site.message_type + " " + name(site.level);
    if (site.topic) line += " '" + *site.topic + "'";
    if (!site.code.empty()) line += " " + site.code;
    if (!site.reason.empty()) line += " " + site.reason;
    text += commented(line);
  }
  for (const Note& note : plan.report.notes)
    text += commented(
        "note " +
        (note.where ? relative(package, note.where->file) + ":" + std::to_string(note.where->line) + " "
                    : "") +
        note.code);
  return text;
}

/// A precompiled header is only for the flags that it was made with.
std::string compile_commands(const std::string& dir, const std::map<std::string, std::string>& files,
                             const std::string& flags) {
  const std::string more = flags.empty() ? " -include-pch " TZC_FAKES_PRECOMPILED : " " + flags;
  std::string text = "[";
  for (const auto& item : files) {
    if (fs::path(item.first).extension() != ".cpp") continue;
    text += std::string(text.size() > 1 ? "," : "") + "{\"directory\":\"" + dir + "\",\"file\":\"" + dir +
            "/" + item.first + "\",\"command\":\"c++ -std=c++17" + more + " -I" TZC_FAKES " -I" + dir +
            "/include -c " + dir + "/" + item.first + " -o x.o\"}";
  }
  return text + "]";
}

std::map<std::string, std::string> settings_of(const std::string& run_line) {
  std::map<std::string, std::string> settings;
  std::istringstream words(run_line);
  for (std::string word; words >> word;)
    settings[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  return settings;
}

std::string with_crlf(std::string text) {
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    text.replace(at, 1, "\r\n");
  return text;
}

}  // namespace

Case read_case(const std::string& path) {
  Case one{tzc::test::GoldenCase(path), {}, {}};
  std::istringstream head(one.golden.head());
  for (std::string line; std::getline(head, line);)
    if (line.rfind("//RUN:", 0) == 0) one.settings = settings_of(line.substr(6));
  one.files["src/node.cpp"] = one.golden.head();
  for (const auto& [name, text] : one.golden.sections()) one.files[name] += text;
  if (one.settings.count("crlf"))
    for (auto& item : one.files) item.second = with_crlf(item.second);
  return one;
}

Package package_of(const Case& one) {
  const auto flags = one.settings.find("flags");
  return Package(one.files, flags == one.settings.end() ? "" : flags->second);
}

Package::Package(const std::map<std::string, std::string>& files, const std::string& flags) {
  for (const auto& [name, content] : files) dir_.write(name, content);
  dir_.write("build/compile_commands.json", compile_commands(dir(), files, flags));
}

EngineOptions Package::options(const std::map<std::string, std::string>& settings) const {
  EngineOptions options;
  options.packages = dir();
  options.build_dirs = {{dir(), dir() + "/build"}};
  options.jobs = 1;
  const auto is = [&](const char* key, const char* value) {
    const auto found = settings.find(key);
    return found != settings.end() && found->second == value;
  };
  if (is("level", "one_copy")) options.max_level = Level::one_copy;
  if (is("level", "plain")) options.max_level = Level::plain;
  if (is("on-exhausted", "drop")) options.on_exhausted = OnExhausted::drop;
  if (is("on-exhausted", "return")) options.on_exhausted = OnExhausted::return_from_function;
  if (settings.count("mem-size")) options.mem_size = std::stoull(settings.at("mem-size"));
  if (settings.count("in-use")) options.others.headers_in_use = {dir() + "/" + settings.at("in-use")};
  // Cases have small arrays, so most of them would be left alone.
  options.small = settings.count("small") ? std::stoull(settings.at("small")) : 0;
  if (settings.count("measured")) options.measured_sizes["image"] = std::stoull(settings.at("measured"));
  if (settings.count("without")) options.without_rules.insert(settings.at("without"));
  if (settings.count("only"))
    options.wanted = [topic = settings.at("only")](const Site& site) { return site.topic == topic; };
  if (settings.count("except"))
    options.wanted = [topic = settings.at("except")](const Site& site) { return site.topic != topic; };
  return options;
}

std::map<std::string, std::string> ported(const Package& package, const Case& one, const PortPlan& plan) {
  std::map<std::string, std::string> files = one.files;
  for (const auto& [file, edits] : by_file(plan.edits)) {
    const std::string name = relative(package, file);
    Expected<std::string> content = apply_edits(files.at(name), edits);
    files[name] = content ? *content : to_string(content.error());
  }
  return files;
}

std::string outcome(const Expected<PortPlan>& plan) {
  if (!plan) return "error";
  for (const Level worst :
       {Level::plain, Level::one_copy, Level::copied, Level::zero_copy, Level::shared, Level::not_needed})
    for (const Site& site : plan->report.sites)
      if (site.level == worst) return name(worst);
  return "no_site";
}

std::vector<std::string> lasting_sites(const PortPlan& plan) {
  std::vector<std::string> sites;
  for (const Site& site : plan.report.sites)
    sites.push_back(site.id + " " + name(site.kind) + " " + site.message_type + " " +
                    site.topic.value_or("(no constant)") + " " + name(site.level) + " " + site.code);
  std::sort(sites.begin(), sites.end());
  return sites;
}

std::string describe(const Package& package, const Case& one, const PortPlan& plan) {
  std::string text = describe_sites(package, plan);
  for (const auto& [name, content] : ported(package, one, plan)) {
    if (content == one.files.at(name)) continue;
    text += commented("") + commented("+++ " + name) +
            changed_lines(lines_of(one.files.at(name)), lines_of(content));
  }
  return text;
}

}  // namespace tzc::rewriter::test
