// SPDX-License-Identifier: BSD-3-Clause
#include "verify/changed_calls.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace tzc::rewriter {
namespace {

using Calls = std::vector<const PackageCall*>;

/// Code that is written once: that of a file outside of instantiations, or a template's.
struct Code {
  std::string file, pattern;
  friend bool operator<(const Code& a, const Code& b) {
    return std::tie(a.file, a.pattern) < std::tie(b.file, b.pattern);
  }
};
/// Its calls, by the arguments of the instantiation.
using CallsOfCode = std::map<Code, std::map<std::string, Calls>>;

CallsOfCode by_code(const std::vector<PackageCall>& calls) {
  CallsOfCode found;
  for (const PackageCall& call : calls)
    found[{call.file, call.instance.pattern}][call.instance.arguments].push_back(&call);
  return found;
}

/// "sensor_msgs::Image" of "tzc::sensor_msgs::Image" and of "sensor_msgs::Image_<std::allocator<void>>".
std::string stock_arguments(std::string text) {
  for (const std::string hidden : {"tzc::", "_<std::allocator<void>>"})
    for (std::size_t at = text.find(hidden); at != std::string::npos; at = text.find(hidden, at))
      text.erase(at, hidden.size());
  return text;
}

/// What the original did where the edited unit has this instantiation.
std::vector<Calls> counterparts(const std::map<std::string, Calls>& before, const std::string& arguments) {
  if (const auto same = before.find(arguments); same != before.end()) return {same->second};
  std::vector<Calls> twins, all;
  for (const auto& [others, calls] : before) {
    all.push_back(calls);
    if (stock_arguments(others) == stock_arguments(arguments)) twins.push_back(calls);
  }
  return twins.empty() ? all : twins;
}

class Comparison {
 public:
  explicit Comparison(const OriginalUnit& original) : original_(original) {}

  std::optional<PackageCall> first_change(const Calls& before, const Calls& now) const {
    auto then = before.begin();
    auto call = now.begin();
    while (then != before.end() || call != now.end()) {
      if (then != before.end() && call != now.end() && is_same(**then, **call))
        ++then, ++call;
      else if (then != before.end() && original_.is_replaced(**then))
        ++then;
      else
        return call != now.end() ? **call : **then;
    }
    return {};
  }

 private:
  bool is_same(const PackageCall& before, const PackageCall& now) const {
    return before.callee == now.callee && before.callee_file == now.callee_file &&
           before.callee_number == now.callee_number &&
           original_.is_line(now.callee_file, now.callee_line, before.callee_line);
  }
  const OriginalUnit& original_;
};

}  // namespace

std::optional<PackageCall> changed_call(const OriginalUnit& original, const std::vector<PackageCall>& now) {
  const CallsOfCode code_before = by_code(original.calls);
  CallsOfCode code_now = by_code(now);
  for (const auto& item : code_before)
    if (item.first.pattern.empty()) code_now.try_emplace(item.first, std::map<std::string, Calls>{{"", {}}});
  const Comparison comparison(original);
  for (const auto& [code, instances] : code_now) {
    const auto known = code_before.find(code);
    if (known == code_before.end() && (!code.pattern.empty() || !original.has(code.file))) continue;
    const std::map<std::string, Calls> none = {{"", {}}};
    for (const auto& [arguments, calls] : instances)
      for (const Calls& before : counterparts(known == code_before.end() ? none : known->second, arguments))
        if (const auto change = comparison.first_change(before, calls)) return change;
  }
  return {};
}

std::string picked_by(const PackageCall& call) {
  const std::string lambda = "(lambda)", called = lambda + "::operator()";
  const std::size_t length = call.callee.size();
  if (length < called.size() || call.callee.compare(length - called.size(), called.size(), called) != 0)
    return "'" + call.callee + "'";
  const std::size_t outermost = call.callee.find(lambda);
  return outermost == 0 ? "lambda" : "lambda in '" + call.callee.substr(0, outermost - 2) + "'";
}

}  // namespace tzc::rewriter
