// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/known_functions.h"

#include <algorithm>
#include <map>
#include <set>

namespace tzc::rewriter {
namespace {

enum class Kind {
  keeps_nothing,
  makes_new,
  view,
  owner,
  calls_nothing,
  may_wait,
  returns,
  may_throw,
  quiet,
  one_at_a_time,
  thread
};

struct Row {
  Kind kind;
  const char* name;
};

constexpr Row rows[] = {
#define KEEPS_NOTHING(name) {Kind::keeps_nothing, name},
#define MAKES_NEW(name) {Kind::makes_new, name},
#define VIEW(name) {Kind::view, name},
#define OWNER(name) {Kind::owner, name},
#define CALLS_NOTHING(name) {Kind::calls_nothing, name},
#define MAY_WAIT(name) {Kind::may_wait, name},
#define RETURNS(name) {Kind::returns, name},
#define MAY_THROW(name) {Kind::may_throw, name},
#define QUIET(name) {Kind::quiet, name},
#define ONE_AT_A_TIME(name) {Kind::one_at_a_time, name},
#define THREAD(name) {Kind::thread, name},
#include "facts/syntax/known_functions.def"
#undef KEEPS_NOTHING
#undef MAKES_NEW
#undef VIEW
#undef OWNER
#undef CALLS_NOTHING
#undef MAY_WAIT
#undef RETURNS
#undef MAY_THROW
#undef QUIET
#undef ONE_AT_A_TIME
#undef THREAD
};

const std::set<std::string>& names(Kind kind) {
  static const auto known = [] {
    std::map<Kind, std::set<std::string>> all;
    for (const Row& row : rows) all[row.kind].insert(row.name);
    return all;
  }();
  return known.at(kind);
}

/// A name of the table that ends in "::" stands for everything below it.
bool matches(const std::string& name, const std::string& entry) {
  if (entry.size() < 2 || entry.compare(entry.size() - 2, 2, "::") != 0) return name == entry;
  return name.rfind(entry, 0) == 0;
}

bool any_matches(Kind kind, const std::string& name) {
  const std::set<std::string>& entries = names(kind);
  return std::any_of(entries.begin(), entries.end(),
                     [&](const std::string& entry) { return matches(name, entry); });
}

}  // namespace

Keeping keeping_of(const std::string& function) {
  if (names(Kind::makes_new).count(function)) return Keeping::nothing_and_result_is_new;
  return names(Kind::keeps_nothing).count(function) ? Keeping::nothing : Keeping::unknown;
}

bool is_view_class(const std::string& name) {
  return names(Kind::view).count(name) != 0;
}

bool is_owner_class(const std::string& name) {
  return names(Kind::owner).count(name) != 0;
}

bool calls_nothing(const std::string& function) {
  return any_matches(Kind::calls_nothing, function) && !any_matches(Kind::may_wait, function);
}

bool always_returns(const std::string& function) {
  return any_matches(Kind::returns, function) && !any_matches(Kind::may_throw, function);
}

bool is_quiet_function(const std::string& function) {
  return any_matches(Kind::quiet, function);
}

bool runs_one_at_a_time(const std::string& function) {
  return any_matches(Kind::one_at_a_time, function);
}

bool makes_thread(const std::string& name) {
  return any_matches(Kind::thread, name);
}

}  // namespace tzc::rewriter
