// SPDX-License-Identifier: BSD-3-Clause
// Where messages come into being, and which publishers can be named there.
#include <clang/AST/ParentMapContext.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include "facts/unit.h"

namespace tzc::rewriter {
namespace {

const clang::Stmt* statement_around(Unit& unit, clang::DynTypedNode node) {
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty()) return nullptr;
    if (parents[0].get<clang::CompoundStmt>()) return node.get<clang::Stmt>();
    const auto* parent = parents[0].get<clang::Stmt>();
    if (parent && llvm::isa<clang::IfStmt, clang::ForStmt, clang::WhileStmt, clang::CXXForRangeStmt,
                            clang::DoStmt, clang::SwitchCase, clang::LambdaExpr>(parent))
      return nullptr;
    node = parents[0];
  }
}

Birth birth_of(Unit& unit, const Key& key, const clang::FunctionDecl* function, clang::SourceLocation where) {
  Birth birth;
  birth.entity = key;
  birth.where = location_of(unit.source.where(where));
  if (function) {
    birth.record = record_usr_of(function);
    birth.function = usr_of(function);
  }
  return birth;
}

void place_behind(Unit& unit, const clang::Stmt* statement, Birth& birth) {
  if (!statement) return;
  birth.at = unit.source.behind(statement->getSourceRange());
  if (!birth.at) return;
  birth.indent = unit.source.indent(*birth.at);
  const std::optional<Place> end = unit.source.line_end(*birth.at);
  birth.own_line = end.has_value();
  if (end) birth.at = end;
}

bool is_fresh(Unit& unit, const Sources& sources) {
  for (const Key& key : sources.keys)
    if (unit.facts.entities[key].home != Home::temporary) return false;
  return !sources.foreign;
}

bool from_result(Unit& unit, const Sources& sources) {
  return llvm::any_of(sources.keys,
                      [&](const Key& k) { return unit.facts.entities[k].home == Home::result; });
}

unsigned offset_of(Unit& unit, clang::SourceLocation location) {
  return unit.source.where(location).begin;
}

void name_publishers(Unit& unit, SeenBirth& seen) {
  const unsigned at = seen.birth.at                ? seen.birth.at->begin
                      : seen.birth.changes.empty() ? 0
                                                   : seen.birth.changes[0].where.begin;
  if (at == 0) return;
  for (const SeenPublisher& publisher : unit.publishers) {
    if (publisher.function != seen.function || publisher.key.empty()) continue;
    const Naming naming = naming_at(unit, publisher, at);
    if (naming == Naming::none) continue;
    PublisherName name{publisher.key, name_text(unit, publisher), publisher.pointer,
                       naming == Naming::guarded, publisher.messages};
    seen.birth.publishers.push_back(std::move(name));
  }
}

/// A local message before the publisher that is declared later in the same block.
void place_behind_publisher(Unit& unit, SeenBirth& seen) {
  if (!seen.birth.publishers.empty() || !seen.birth.at || seen.birth.before) return;
  for (const SeenPublisher& publisher : unit.publishers) {
    if (publisher.function != seen.function) continue;
    const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(publisher.object->IgnoreParenImpCasts());
    const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
    if (!variable || !variable->isLocalVarDecl()) continue;
    const clang::Stmt* statement = statement_around(unit, clang::DynTypedNode::create(*variable));
    const auto behind = statement ? unit.source.behind(statement->getSourceRange()) : std::nullopt;
    const auto at = behind ? unit.source.line_end(*behind) : std::nullopt;
    if (!at || at->begin < seen.birth.at->begin || at->begin > publisher.begin) continue;
    for (const DataUse& use : unit.facts.data_uses)
      if (use.entity == seen.birth.entity && use.where.line < at->line) return;
    seen.birth.at = at;
    seen.birth.indent = unit.source.indent(*at);
    seen.birth.own_line = true;
    name_publishers(unit, seen);
    return;
  }
}

/// The innermost statement of a block in which all mentions of the member lie, first of them in it.
const clang::Stmt* first_mention(Unit& unit, const SeenMember& member, unsigned first, unsigned last) {
  clang::DynTypedNode node = clang::DynTypedNode::create(*member.expr);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty() || parents[0].get<clang::FunctionDecl>()) return nullptr;
    const auto* block = parents[0].get<clang::CompoundStmt>();
    if (block && offset_of(unit, block->getLBracLoc()) < first &&
        offset_of(unit, block->getRBracLoc()) > last)
      for (const clang::Stmt* statement : block->body())
        if (offset_of(unit, statement->getEndLoc()) >= first)
          return llvm::isa<clang::SwitchCase, clang::LabelStmt>(statement) ? nullptr : statement;
    node = parents[0];
  }
}

class Mentions : public clang::RecursiveASTVisitor<Mentions> {
 public:
  Mentions(Unit& unit, const Key& key) : unit_(unit), key_(key) {}
  unsigned first = ~0U, last = 0;

  bool VisitMemberExpr(clang::MemberExpr* member) { return note(member, member->getMemberDecl()); }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) { return note(reference, reference->getDecl()); }

 private:
  bool note(const clang::Expr* expr, const clang::ValueDecl* decl) {
    if (!llvm::isa<clang::FieldDecl, clang::VarDecl>(decl) || declare(unit_, decl) != key_) return true;
    const unsigned here = offset_of(unit_, expr->getBeginLoc());
    first = std::min(first, here);
    last = std::max(last, here);
    return true;
  }
  Unit& unit_;
  const Key& key_;
};

/// A member that is reused: allocated for in front of its first mention in a function that publishes it.
void add_member_birth(Unit& unit, const SeenMember& member) {
  if (!member.function || !member.function->getBody()) return;
  Mentions mentions(unit, member.key);
  mentions.TraverseStmt(member.function->getBody());
  const clang::Stmt* statement = first_mention(unit, member, mentions.first, mentions.last);
  Birth birth = birth_of(unit, member.key, member.function, member.expr->getBeginLoc());
  birth.before = true;
  birth.object = unit.source.text(member.expr->getSourceRange());
  if (statement) birth.at = unit.source.before(statement->getBeginLoc());
  if (birth.at) {
    birth.indent = unit.source.indent(*birth.at);
    birth.own_line = unit.source.starts_line(*birth.at);
  }
  unit.births.push_back({birth, member.function});
}

}  // namespace

void collect_declaration_birth(Unit& unit, const clang::VarDecl* variable) {
  const auto message = message_of(variable->getType());
  if (!variable->isLocalVarDecl() || variable->getType()->isReferenceType() || !message || !message->has_data)
    return;
  if (variable->isCXXForRangeDecl() || variable->isImplicit()) return;
  const Key key = declare(unit, variable);
  const auto parents = unit.ast().getParents(*variable);
  const auto* statement = parents.empty() ? nullptr : parents[0].get<clang::Stmt>();
  if (key.empty() || !statement) return;
  const clang::FunctionDecl* function = function_around(unit, *statement);
  Birth birth = birth_of(unit, key, function, variable->getLocation());
  birth.object = variable->getNameAsString();
  if (const clang::Expr* value = variable->getInit()) {
    const Sources sources = sources_of(unit, value);
    if (from_result(unit, sources)) return;
    birth.filled = !is_fresh(unit, sources);
  }
  place_behind(unit, statement_around(unit, clang::DynTypedNode::create(*variable)), birth);
  unit.births.push_back({birth, function});
}

void collect_object_birth(Unit& unit, const clang::Expr* expr, const Key& key, const Sink& sink) {
  const clang::FunctionDecl* function = function_around(unit, *expr);
  const bool is_value = message_of(expr->getType()).has_value();
  if (is_value && !sink.target) return;  // its variable is born, or it is a temporary without arrays
  Birth birth = birth_of(unit, key, function, expr->getBeginLoc());
  const std::string star = is_value ? "" : "*";
  if (sink.variable && !llvm::isa<clang::ParmVarDecl>(sink.variable)) {
    birth.object = star + sink.variable->getNameAsString();
    place_behind(unit, statement_around(unit, clang::DynTypedNode::create(*sink.variable)), birth);
  } else if (sink.target && sink.statement) {
    birth.object = star + unit.source.text(sink.target->IgnoreImpCasts()->getSourceRange());
    place_behind(unit, statement_around(unit, clang::DynTypedNode::create(*sink.statement)), birth);
  }
  unit.births.push_back({birth, function});
}

void connect_births(Unit& unit) {
  std::set<std::string> seen_members;
  for (const SeenMember& member : unit.members)
    if (member.function && seen_members.insert(member.key + usr_of(member.function)).second)
      add_member_birth(unit, member);
  for (SeenBirth& seen : unit.births) {
    name_publishers(unit, seen);
    place_behind_publisher(unit, seen);
    unit.facts.births.push_back(std::move(seen.birth));
  }
}

}  // namespace tzc::rewriter
