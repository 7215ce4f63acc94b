// SPDX-License-Identifier: BSD-3-Clause
#include "proof/generated_headers.h"

#include <algorithm>
#include <filesystem>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// "demo_msgs" of "tzc/demo_msgs/Cloud.h".
std::string package_of(const std::string& header) {
  return fs::path(header).parent_path().filename();
}

bool includes(const std::string& text, const std::string& header) {
  return text.find("<" + header + ">") != std::string::npos ||
         text.find("\"" + header + "\"") != std::string::npos;
}

}  // namespace

/// Those that make something in the header's folder, which is its package's: CMake's reply names a rule by the first of its outputs.
std::vector<const CmakeTarget*> GeneratedHeaders::makers_of(const std::string& path) const {
  const fs::path folder = fs::path(path).parent_path();
  std::vector<const CmakeTarget*> makers;
  for (const CmakeTarget& target : targets_)
    if (std::any_of(target.sources.begin(), target.sources.end(),
                    [&](const std::string& source) { return fs::path(source).parent_path() == folder; }))
      makers.push_back(&target);
  return makers;
}

std::set<std::string> GeneratedHeaders::made_before(const std::string& target) const {
  std::set<std::string> all, left = {target};
  while (!left.empty()) {
    const std::string next = *left.begin();
    left.erase(left.begin());
    if (!all.insert(next).second) continue;
    for (const CmakeTarget& one : targets_)
      if (one.name == next) left.insert(one.made_before.begin(), one.made_before.end());
  }
  return all;
}

std::optional<GeneratedHeaders::Order> GeneratedHeaders::order_of(const CompileCommand& command,
                                                                  const std::string& header) const {
  for (const std::string& folder : include_folders(command)) {
    const fs::path path = (fs::path(command.directory) / folder / header).lexically_normal();
    if (is_there(path)) return Order{"", true};
    const std::vector<const CmakeTarget*> makers = makers_of(path);
    if (makers.empty()) continue;
    const std::set<std::string> before = made_before(command.target);
    return Order{makers.front()->name, std::any_of(makers.begin(), makers.end(), [&](auto* maker) {
                   return before.count(maker->name) != 0;
                 })};
  }
  return {};
}

std::optional<Lack> GeneratedHeaders::lack_of_header(const CompileCommand& command,
                                                     const std::string& header) const {
  const std::optional<Order> order = order_of(command, header);
  if (!order)
    return Lack{
        "nothing makes <" + header + ">, which it includes",
        "write tzc_generate_messages(" + package_of(header) + ") behind the command that finds catkin"};
  // A build that leaves the order of roscpp's own header to chance is no worse than before.
  const std::optional<Order> stock = order_of(command, header.substr(std::string("tzc/").size()));
  if (order->is_before || (stock && !stock->is_before)) return {};
  return Lack{"nothing says that " + order->maker + " makes <" + header + "> before it",
              "add_dependencies(" + command.target + " " + order->maker + ") says so"};
}

std::optional<Lack> GeneratedHeaders::lack(const CompileCommand& command, const std::string& unit) const {
  if (targets_.empty()) return {};
  for (const std::string& header : headers_)
    for (const auto& [file, text] : contents_) {
      if (!includes(text, header)) continue;
      const std::optional<Lack> lack = lack_of_header(command, header);
      // The compiler is asked last, since it takes a second.
      if (lack && (file == unit || includes_any(command, {{file, text}}, to_user_, MissingHeaders::are_made)))
        return lack;
    }
  return {};
}

}  // namespace tzc::rewriter
