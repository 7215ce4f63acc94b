// SPDX-License-Identifier: BSD-3-Clause
// Base classes and functions of libraries that advertise for the package and return the publisher. The
// library keeps its own copy; shared memory is attached to the topic beside it.
#include <clang/AST/ParentMapContext.h>

#include "facts/advertise_sites.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

llvm::ArrayRef<clang::TemplateArgumentLoc> written_arguments_of(const clang::CallExpr* call) {
  const clang::Expr* callee = call->getCallee()->IgnoreParenImpCasts();
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(callee)) return member->template_arguments();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(callee)) return name->template_arguments();
  return {};
}

/// M of advertise<M>(...), when that is what a library can advertise.
clang::QualType advertised_type(const clang::CallExpr* call) {
  const llvm::ArrayRef<clang::TemplateArgumentLoc> arguments = written_arguments_of(call);
  if (arguments.empty() || arguments[0].getArgument().getKind() != clang::TemplateArgument::Type) return {};
  const clang::QualType type = arguments[0].getArgument().getAsType();
  return message_of(type) || twin_message_of(type) || is_pcl_cloud(type) ? type : clang::QualType();
}

void describe_topic(Unit& unit, const clang::CallExpr* call, Advertise& site) {
  for (unsigned i = 0; i < written_arguments(call) && !site.topic; ++i) {
    site.topic = constant_string(call->getArg(i));
    if (site.topic) site.queue = written_text(unit, call, i + 1);
  }
}

std::string attach_text(Unit& unit, const clang::CallExpr* call, const LibraryAdvertise& rule,
                        const Advertise& site) {
  if (!rule.is_template) return std::string(rule.to) + "(";
  const clang::TemplateArgumentLoc& written = written_arguments_of(call)[0];
  const bool as_written = site.no_twin || is_template_parameter(written.getArgument());
  const std::string type = as_written ? unit.source.text(written.getSourceRange()) : twin_name(site.type);
  return std::string(rule.to) + "<" + type + ">(";
}

void attach(Unit& unit, const clang::CallExpr* call, const LibraryAdvertise& rule, Advertise& site) {
  std::optional<Place> whole = unit.source.place(call->getSourceRange());
  if (!whole) {
    const Obstacle obstacle{codes::TZC1006, "the advertise call comes from a macro", location_of(site.where)};
    site.obstacles.push_back(obstacle);
    unit.facts.entities[site.publisher].obstacles.push_back(obstacle);
    return;
  }
  Place begin = *whole, end = *whole;
  begin.end = begin.begin;
  end.begin = end.end;
  site.changes = {{begin, attach_text(unit, call, rule, site), rule.rule, {rule.header}},
                  {end, rule.is_template ? ", $MEM)" : ")", rule.rule, {}}};
  if (rule.is_template && !site.no_twin) site.changes[0].headers.push_back(twin_header(site.type));
  if (site.pcl) site.changes[0].headers.push_back("tzc/pcl.h");
}

}  // namespace

const LibraryAdvertise* library_advertise_rule(Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || !function->getIdentifier() || !function->getName().starts_with("advertise"))
    return nullptr;
  const clang::CXXRecordDecl* result = function->getReturnType().getCanonicalType()->getAsCXXRecordDecl();
  const LibraryAdvertise* rule = result ? unit.rules.find_advertiser(qualified_name_of(result)) : nullptr;
  if (!rule || call->isTypeDependent() || is_package_function(unit, function)) return nullptr;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && qualified_name_of(method->getParent()) == rule->owner) return nullptr;
  return !rule->is_template || !advertised_type(call).isNull() ? rule : nullptr;
}

const clang::CallExpr* attaching_call(Unit& unit, const clang::CallExpr* call, const LibraryAdvertise& rule) {
  clang::DynTypedNode node = clang::DynTypedNode::create(*call);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    const auto* parent = parents.empty() ? nullptr : parents[0].get<clang::Expr>();
    if (!parent) return nullptr;
    if (const auto* outer = llvm::dyn_cast<clang::CallExpr>(parent)) {
      const clang::FunctionDecl* function = outer->getDirectCallee();
      return function && qualified_name_of(function) == rule.to ? outer : nullptr;
    }
    if (!llvm::isa<clang::ImplicitCastExpr, clang::MaterializeTemporaryExpr, clang::CXXBindTemporaryExpr,
                   clang::FullExpr, clang::ParenExpr>(parent))
      return nullptr;
    node = parents[0];
  }
}

bool attaches_publisher(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return false;
  const std::string name = qualified_name_of(function);
  return llvm::any_of(unit.rules.advertisers, [&](const LibraryAdvertise* rule) { return name == rule->to; });
}

void collect_library_advertise(Unit& unit, const clang::CallExpr* call) {
  const LibraryAdvertise* rule = library_advertise_rule(unit, call);
  if (!rule) return;
  Advertise site = advertise_at(unit, call, rule->rule);
  if (rule->is_template) describe_type(unit, advertised_type(call), site);
  describe_topic(unit, call, site);
  const clang::CallExpr* ported = attaching_call(unit, call, *rule);
  const clang::CallExpr* kept = ported ? ported : call;
  site.publisher = declare_temporary(unit, kept);
  if (ported)
    site.memory = rule->is_template ? written_text(unit, ported, 1) : "0";
  else
    attach(unit, call, *rule, site);
  const Key publisher = site.publisher;
  add_advertise(unit, std::move(site));
  follow_use(unit, kept, publisher);
}

}  // namespace tzc::rewriter
