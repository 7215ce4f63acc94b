// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/known_functions.h"

#include <algorithm>
#include <set>
#include <vector>

namespace tzc::rewriter {
namespace {

struct Table {
  std::set<std::string> keeps_nothing, makes_new, views, owners;
  std::vector<std::string> calls_nothing, may_wait, returns, may_throw, quiet, one_at_a_time, threads;
};

const Table& table() {
  static const Table known = [] {
    Table t;
#define KEEPS_NOTHING(name) t.keeps_nothing.insert(name);
#define MAKES_NEW(name) t.makes_new.insert(name);
#define VIEW(name) t.views.insert(name);
#define OWNER(name) t.owners.insert(name);
#define CALLS_NOTHING(name) t.calls_nothing.push_back(name);
#define MAY_WAIT(name) t.may_wait.push_back(name);
#define RETURNS(name) t.returns.push_back(name);
#define MAY_THROW(name) t.may_throw.push_back(name);
#define QUIET(name) t.quiet.push_back(name);
#define ONE_AT_A_TIME(name) t.one_at_a_time.push_back(name);
#define THREAD(name) t.threads.push_back(name);
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
    return t;
  }();
  return known;
}

/// A name of the table that ends in "::" stands for everything below it.
bool matches(const std::string& name, const std::string& entry) {
  if (entry.size() < 2 || entry.compare(entry.size() - 2, 2, "::") != 0) return name == entry;
  return name.rfind(entry, 0) == 0;
}

bool any_matches(const std::vector<std::string>& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const std::string& entry) { return matches(name, entry); });
}

}  // namespace

Keeping keeping_of(const std::string& function) {
  if (table().makes_new.count(function)) return Keeping::nothing_and_result_is_new;
  return table().keeps_nothing.count(function) ? Keeping::nothing : Keeping::unknown;
}

bool is_view_class(const std::string& name) {
  return table().views.count(name) != 0;
}

bool is_owner_class(const std::string& name) {
  return table().owners.count(name) != 0;
}

bool calls_nothing(const std::string& function) {
  return any_matches(table().calls_nothing, function) && !any_matches(table().may_wait, function);
}

bool always_returns(const std::string& function) {
  return any_matches(table().returns, function) && !any_matches(table().may_throw, function);
}

bool is_quiet_function(const std::string& function) {
  return any_matches(table().quiet, function);
}

bool runs_one_at_a_time(const std::string& function) {
  return any_matches(table().one_at_a_time, function);
}

bool makes_thread(const std::string& name) {
  return any_matches(table().threads, name);
}

}  // namespace tzc::rewriter
