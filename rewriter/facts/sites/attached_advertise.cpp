// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/attached_advertise.h"

#include <algorithm>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/library_advertise.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

const AttachedAdvertise* rule_for(const Unit& unit, const clang::CallExpr* call) {
  const clang::CXXRecordDecl* publisher = call->getType().getCanonicalType()->getAsCXXRecordDecl();
  return publisher ? unit.rules.find_attached(qualified_name_of(publisher)) : nullptr;
}

/// #if between the arguments: what stands behind the expression may be left out where it is compiled in another way.
bool has_directive(llvm::StringRef text) {
  while (!text.empty()) {
    const auto [line, rest] = text.split('\n');
    if (line.ltrim().starts_with("#")) return true;
    text = rest;
  }
  return false;
}

std::vector<Change> take_away(const Unit& unit, const clang::CallExpr* outer, const clang::CallExpr* inner,
                              const char* rule) {
  const auto whole = unit.source.place(outer->getSourceRange()),
             kept = unit.source.place(inner->getSourceRange());
  if (!whole || !kept) return {};
  Place before = *whole, behind = *whole;
  before.end = kept->begin;
  behind.begin = kept->end;
  return {{before, "", rule, {}}, {behind, "", rule, {}}};
}

}  // namespace

std::vector<Change> put_around(const Unit& unit, const clang::Expr* expr, const Change& before,
                               const std::string& behind) {
  const std::optional<Place> whole = unit.source.place(expr->getSourceRange());
  if (!whole || has_directive(unit.source.text(*whole))) return {};
  Change first = before;
  first.where = *whole;
  first.where.end = whole->begin;
  Place end = *whole;
  end.begin = whole->end;
  return {first, {end, behind, before.rule, {}}};
}

void describe_keeping(Advertise& site, const Unit& unit, const clang::CallExpr* call) {
  const AttachedAdvertise* rule = rule_for(unit, call);
  if (!rule || !site.has_data_part || site.around == Advertise::Around::function_for_callers) return;
  if (const clang::CallExpr* outer = attaching_call(unit, call, rule->to)) {
    site.attaching.is_done = true;
    const std::vector<Change> away = take_away(unit, outer, call, rule->rule);
    site.changes.insert(site.changes.end(), away.begin(), away.end());
    return;
  }
  const bool is_unknown = std::any_of(site.obstacles.begin(), site.obstacles.end(),
                                      [](const Obstacle& one) { return one.code == codes::TZC1012; });
  // The type of one instance would be written for all of them.
  const bool is_of_instance =
      site.around == Advertise::Around::template_instance && written_arguments_of(call).empty();
  if (rule->is_template && (site.written.stock.empty() || is_unknown || is_of_instance)) return;
  std::string text = rule->to;
  if (rule->is_template) text += "<" + site.written.stock + ">";
  Change before{{}, text + "(", rule->rule, {rule->header}};
  if (site.pcl) before.headers.push_back("tzc/pcl.h");
  site.attaching.changes = put_around(unit, call, before, ")");
}

}  // namespace tzc::rewriter
