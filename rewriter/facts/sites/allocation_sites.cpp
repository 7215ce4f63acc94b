// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/allocation_sites.h"

#include <algorithm>

#include "facts/flow/message_copies.h"
#include "facts/sites/containing_object.h"
#include "facts/sites/copied_in.h"
#include "facts/sites/named_elements.h"
#include "facts/sites/object_starts.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

constexpr const char* not_nameable =
    "the expression that names it means something else, or nothing, where allocate would stand";

/// Whether a statement is what another one executes, without a block around it.
bool is_bare_body(const clang::Stmt* part, const clang::Stmt* around) {
  if (const auto* branch = llvm::dyn_cast<clang::IfStmt>(around))
    return part == branch->getThen() || part == branch->getElse();
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(around)) return part == loop->getBody();
  if (const auto* loop = llvm::dyn_cast<clang::WhileStmt>(around)) return part == loop->getBody();
  if (const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(around)) return part == loop->getBody();
  const auto* loop = llvm::dyn_cast<clang::DoStmt>(around);
  return loop && part == loop->getBody();
}

/// The statement that a node belongs to, of a block or alone in place of one; null: it stands in the head of another statement.
template <class Node>
const clang::Stmt* statement_around(const Unit& unit, const Node& of) {
  clang::DynTypedNode part = clang::DynTypedNode::create(of);
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), of)) {
    if (node.get<clang::CompoundStmt>()) return part.get<clang::Stmt>();
    const auto* around = node.get<clang::Stmt>();
    const auto* statement = part.get<clang::Stmt>();
    if (around && statement && is_bare_body(statement, around)) return statement;
    if (around && llvm::isa<clang::IfStmt, clang::ForStmt, clang::WhileStmt, clang::CXXForRangeStmt,
                            clang::DoStmt, clang::LambdaExpr>(around))
      return nullptr;
    part = node;
  }
  return nullptr;
}

/// Where a publisher must be available for the edits of a site; none: it has none.
std::optional<unsigned> offset_of(const AllocationSite& site) {
  if (const auto* inserted = std::get_if<InsertedAllocation>(&site.how))
    return inserted->at ? std::optional(inserted->at->begin) : std::nullopt;
  const auto* adapter = std::get_if<AdapterAllocation>(&site.how);
  const std::vector<Change>& changes =
      adapter ? adapter->changes : std::get<FactoryAllocation>(site.how).changes;
  return changes.empty() ? std::nullopt : std::optional(changes[0].where.begin);
}

/// image.height, image->header.stamp: a field that holds no elements.
bool names_plain_field(clang::ASTContext& ast, const clang::DeclRefExpr* reference) {
  for (const clang::DynTypedNode& node : ancestors(ast, *reference)) {
    if (const auto* member = node.get<clang::MemberExpr>()) {
      const auto* field = llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl());
      const auto* record = field ? field->getType()->getAsCXXRecordDecl() : nullptr;
      if (field)
        return field->getType()->isArithmeticType() ||
               (record && qualified_name_of(record) == "std_msgs::Header_");
    } else if (!node.get<clang::ImplicitCastExpr>() && !node.get<clang::CXXOperatorCallExpr>()) {
      return false;
    }
  }
  return false;
}

/// Whether something names a variable, but for its fields without elements.
class Mention : public AstVisitor {
 public:
  Mention(clang::ASTContext& ast, const clang::VarDecl* variable) : ast_(ast), variable_(variable) {}
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    found = found || (reference->getDecl() == variable_ && !names_plain_field(ast_, reference));
    return !found;
  }
  bool found = false;

 private:
  clang::ASTContext& ast_;
  const clang::VarDecl* const variable_;
};

class Connector {
 public:
  Connector(const Unit& unit, const std::vector<PublisherMention>& mentions)
      : unit_(unit), hoisting_(unit), mentions_(mentions) {}

  /// Finds the site's publishers.
  void connect(AllocationDraft& draft) const {
    AllocationSite& site = draft.site;
    const std::optional<unsigned> at = offset_of(site);
    if (!at || *at == 0) return;
    if (site.is_early && !record_usr_of(draft.function).empty()) return;
    const auto* inserted = std::get_if<InsertedAllocation>(&site.how);
    std::ptrdiff_t own = 0;
    for (const PublisherMention& mention : mentions_) {
      if (mention.function != draft.function || mention.id.empty()) continue;
      const std::optional<EarlyName> name = hoisting_.name_at(mention, *at);
      if (!name) {
        site.unnameable.insert(mention.id);
        continue;
      }
      site.publishers.push_back(
          {mention.id, name->text, mention.pointer, name->guarded, mention.messages, name->callees});
      // The same member of several objects is one entity: a publisher that is given this one comes first.
      if (inserted && mention.published == inserted->object)
        std::rotate(site.publishers.begin() + own++, site.publishers.end() - 1, site.publishers.end());
    }
  }

  /// For a local message before the publisher that is declared later in the same block. Whoever has filled the message, or has a
  /// pointer to its elements, has named it. What a copy is made of may change meanwhile.
  std::optional<InsertedAllocation> behind_publisher(const AllocationDraft& draft) const {
    const auto* how = std::get_if<InsertedAllocation>(&draft.site.how);
    if (!how || !how->at || how->copy || !draft.variable) return {};
    for (const PublisherMention& mention : mentions_) {
      if (mention.function != draft.function) continue;
      const clang::Stmt* declaration = declaration_of(mention);
      const std::optional<Place> at = line_behind(declaration);
      if (!at || at->begin < how->at->begin || at->begin > mention.begin ||
          !is_untouched_until(*draft.variable, declaration))
        continue;
      InsertedAllocation moved = *how;
      moved.at = at;
      moved.indent = unit_.source.indent(*at);
      moved.own_line = true;
      return moved;
    }
    return {};
  }

 private:
  /// The statement that declares a local publisher; null: it is no such one.
  const clang::Stmt* declaration_of(const PublisherMention& mention) const {
    const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(mention.object->IgnoreParenImpCasts());
    const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
    return variable && variable->isLocalVarDecl() ? statement_around(unit_, *variable) : nullptr;
  }
  std::optional<Place> line_behind(const clang::Stmt* statement) const {
    const auto behind = statement ? unit_.source.behind(statement->getSourceRange()) : std::nullopt;
    return behind ? unit_.source.line_end(*behind) : std::nullopt;
  }
  /// Whether a later statement of the same block is reached without a use of the message but for fields that are no arrays.
  bool is_untouched_until(const clang::VarDecl& message, const clang::Stmt* later) const {
    const clang::Stmt* const first = statement_around(unit_, message);
    const auto* block = first ? parent_as<clang::CompoundStmt>(unit_.ast(), *first) : nullptr;
    if (!block || block != parent_as<clang::CompoundStmt>(unit_.ast(), *later)) return false;
    Mention mention(unit_.ast(), &message);
    const auto begin = std::find(block->body_begin(), block->body_end(), first);
    const auto end = std::find(begin, block->body_end(), later);
    for (auto statement = begin; statement != end; ++statement)
      if (statement != begin) mention.TraverseStmt(*statement);
    mention.TraverseStmt(const_cast<clang::Stmt*>(later));
    return end != block->body_end() && !mention.found;
  }

  const Unit& unit_;
  Hoisting hoisting_;
  const std::vector<PublisherMention>& mentions_;
};

}  // namespace

namespace {

/// A constructor's initializers and default arguments: members may not exist yet.
bool is_before_body(const Unit& unit, const clang::FunctionDecl* function, clang::SourceLocation at) {
  const clang::Stmt* body = function->getBody();
  if (!body || unit.source.manager().isBeforeInTranslationUnit(at, body->getBeginLoc())) return true;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method || !method->getParent()->isLambda()) return false;
  const auto* outer = llvm::dyn_cast<clang::FunctionDecl>(method->getParent()->getDeclContext());
  return !outer || is_before_body(unit, outer, method->getParent()->getLocation());
}

}  // namespace

AllocationDraft draft_at(const Unit& unit, const EntityTable& entities, const EntityId& id,
                         const clang::Stmt& where) {
  AllocationDraft draft{{}, enclosing_function(unit.ast(), where)};
  draft.site.entity = id;
  draft.site.where = unit.location(where.getBeginLoc());
  if (draft.function) {
    draft.site.is_early = is_before_body(unit, draft.function, where.getBeginLoc());
    if (!draft.site.is_early) draft.site.record = record_usr_of(draft.function);
    draft.site.scope = namespaces_around(draft.function);
    draft.site.function = entities.result_id(draft.function);
  }
  return draft;
}

void AllocationCollector::place_behind(InsertedAllocation& how, const clang::Stmt* statement) const {
  if (!statement) return;
  how.at = unit_.source.behind(statement->getSourceRange());
  if (!how.at) return;
  const auto* around = parent_as<clang::Stmt>(unit_.ast(), *statement);
  if (around && is_bare_body(statement, around)) {
    how.opening = unit_.source.before(statement->getBeginLoc());
    if (!how.opening) how.at.reset();
    how.own_line = false;
    return;
  }
  const clang::Stmt* labelled = statement;
  while (const auto* label = llvm::dyn_cast<clang::SwitchCase>(labelled)) labelled = label->getSubStmt();
  how.indent = unit_.source.indent(unit_.source.before(labelled->getBeginLoc()).value_or(*how.at));
  const std::optional<Place> end = unit_.source.line_end(*how.at);
  how.own_line = end.has_value();
  if (end) how.at = end;
}

bool AllocationCollector::is_fresh(const FlowSources& sources) const {
  return !sources.foreign && llvm::all_of(sources.entities, [&](const EntityId& id) {
    return entities_[id].storage == Storage::temporary;
  });
}

bool AllocationCollector::is_result(const FlowSources& sources) const {
  return llvm::any_of(sources.entities,
                      [&](const EntityId& id) { return entities_[id].storage == Storage::result; });
}

namespace {

/// Image image = std::move(other): the elements are the other's, with the memory that they have there.
bool is_move(const clang::Expr* value) {
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(value->IgnoreImplicit());
  return construct && construct->getConstructor()->isCopyOrMoveConstructor() && construct->getNumArgs() > 0 &&
         construct->getArg(0)->isXValue();
}

bool has_own_arrays(clang::QualType of_pointer_or_part) {
  const auto message = message_reached(of_pointer_or_part);
  return !message || message->has_direct_data_part;
}

/// No publisher of the function or of its object is named: `allocate` stands in front of code that may make or change it.
void leave_to_node(AllocationDraft& draft) {
  draft.function = nullptr;
  draft.site.is_early = false;
  draft.site.record.clear();
}

}  // namespace

std::optional<AllocationDraft> AllocationCollector::of_declaration(const clang::VarDecl* variable) {
  const auto message = message_declared_by(variable);
  if (!variable->hasLocalStorage() || llvm::isa<clang::ParmVarDecl>(variable) ||
      variable->getType()->isReferenceType() || !message || !message->has_data_part)
    return {};
  if (variable->isCXXForRangeDecl() || variable->isImplicit()) return {};
  const EntityId id = entities_.declare(variable);
  const auto* statement = parent_as<clang::Stmt>(unit_.ast(), *variable);
  if (id.empty() || !statement) return {};
  AllocationDraft draft = draft_at(unit_, entities_, id, *statement);
  draft.site.where = unit_.location(variable->getLocation());
  draft.variable = variable;
  InsertedAllocation how;
  how.object = variable->getNameAsString();
  how.is_needed = message->has_direct_data_part && !is_only_copied_in(variable);
  if (const clang::Expr* value = variable->getInit()) {
    draft.is_of_template = value->isTypeDependent();
    if (const std::vector<Change> moved = move_out_of_result(unit_, value); !moved.empty()) {
      for (const Change& change : moved) entities_.add_use(id, change);
      return {};
    }
    const FlowSources sources = flow_.sources_of(value);
    if (is_result(sources) || (is_move(value) && !is_fresh(sources))) return {};
    how.filled = !is_fresh(sources) || copied_by(value);
    if (how.filled) how.copy = later_copy(unit_, variable);
    if (how.filled && !sources.foreign) draft.site.copied_from = sources.entities;
  }
  place_behind(how, statement_around(unit_, *variable));
  if (how.copy && how.copy->runs_code) leave_to_node(draft);
  draft.site.how = how;
  return draft;
}

namespace {

/// auto image = make_shared<Image>(), other = std::move(image);
bool is_used_behind(const Unit& unit, const clang::VarDecl* variable) {
  const auto* statement = parent_as<clang::DeclStmt>(unit.ast(), *variable);
  if (!statement) return false;
  Mention mention(unit.ast(), variable);
  for (auto at = std::find(statement->decl_begin(), statement->decl_end(), variable);
       at != statement->decl_end(); ++at)
    if (*at != variable) mention.TraverseDecl(*at);
  return mention.found;
}

}  // namespace

/// Whether the object gets another message's elements, to which the program may have pointers; they stay where they lie. A copy has
/// elements of its own, which nobody else knows.
bool AllocationCollector::takes_over(const clang::Expr* expr) const {
  const clang::Expr* source = made_from(expr);
  return source && !source->isLValue() && !is_fresh(flow_.sources_of(source));
}

std::optional<AllocationDraft> AllocationCollector::of_object(const clang::Expr* expr, const EntityId& id,
                                                              const FlowEnd& end) {
  const bool is_value = message_of(expr->getType()).has_value();
  if (is_value || takes_over(expr))
    return {};  // its variable is the site, what it is assigned to keeps its memory, or it has no arrays
  AllocationDraft draft = draft_at(unit_, entities_, id, *expr);
  InsertedAllocation how;
  how.is_needed = has_own_arrays(expr->getType());
  const clang::Expr* source = made_from(expr);
  how.filled = source && source->isLValue();
  if (how.filled)
    if (FlowSources sources = flow_.sources_of(source); !sources.foreign)
      draft.site.copied_from = std::move(sources.entities);
  draft.site.start = lasting_start(end);
  if (draft.site.start) {
    draft.site.how = how;
    return draft;
  }
  const std::string made = end.variable ? name_of_made(end.variable, expr) : "";
  if (how.filled && end.variable && made == "*" + end.variable->getNameAsString())
    how.copy = later_copy(unit_, end.variable, expr);
  if (end.variable && !llvm::isa<clang::ParmVarDecl>(end.variable)) {
    how.object = made;
    if (made.empty()) draft.site.refusal = "it has no name where it is built";
    draft.variable = end.variable;
    place_behind(how, statement_around(unit_, *end.variable));
  } else if (end.target && end.statement) {
    how.object = "*" + unit_.text(end.target->IgnoreImpCasts());
    place_behind(how, statement_around(unit_, *end.statement));
    if (how.at && !Hoisting(unit_).names_the_same(end.target, draft.function, how.at->begin))
      draft.site.refusal = not_nameable;
  }
  if (is_in_initializer_list(unit_, expr))
    draft.site.refusal = "a constructor's initializer list makes it, where no statement can stand";
  if (makes_several(expr)) draft.site.refusal = "it is one of several that are made at once";
  if (!is_always_made(unit_, expr)) draft.site.refusal = "it is made under a condition only";
  if (end.variable && is_used_behind(unit_, end.variable))
    draft.site.refusal = "a variable that is declared behind it in the same statement is made from it";
  if (end.variable && !end.variable->hasLocalStorage())
    draft.site.refusal = "each thread makes one, where it is declared";
  if (how.copy && how.copy->runs_code) leave_to_node(draft);
  draft.site.how = how;
  return draft;
}

std::optional<AllocationDraft> AllocationCollector::of_adapter(const clang::CXXMemberCallExpr* call,
                                                               const EntityId& id, const MethodCall& rule) {
  AdapterAllocation how{receiver_first(unit_, call, {rule.to, rule.rule, rule.header}, "$PUB")};
  if (how.changes.empty()) {
    entities_.add_obstacle(id, codes::TZC1006, macro_reason(unit_, call, "the call"), call->getBeginLoc());
    return {};
  }
  AllocationDraft draft = draft_at(unit_, entities_, id, *call);
  draft.site.where = unit_.location(call->getExprLoc());
  draft.site.how = std::move(how);
  entities_.add_data_use(id, call->getExprLoc());
  return draft;
}

std::optional<AllocationDraft> AllocationCollector::of_part(const clang::Expr* part, const EntityId& id) {
  const clang::VarDecl* object = object_that_ends(part);
  const clang::Stmt* statement =
      object && is_made_empty(object) ? parent_as<clang::Stmt>(unit_.ast(), *object) : nullptr;
  if (!statement) return {};
  AllocationDraft draft = draft_at(unit_, entities_, id, *statement);
  InsertedAllocation how;
  how.object = unit_.text(part);
  how.is_needed = has_own_arrays(part->getType());
  place_behind(how, statement_around(unit_, *object));
  if (how.at && !Hoisting(unit_).names_the_same(part, draft.function, how.at->begin))
    draft.site.refusal = not_nameable;
  draft.site.how = how;
  return draft;
}

AllocationSite connected(const Unit& unit, AllocationDraft draft,
                         const std::vector<PublisherMention>& mentions) {
  const Connector connector(unit, mentions);
  connector.connect(draft);
  if (!draft.site.publishers.empty()) return std::move(draft.site);
  if (const std::optional<InsertedAllocation> moved = connector.behind_publisher(draft)) {
    AllocationDraft later = draft;
    later.site.how = *moved;
    later.site.unnameable.clear();
    connector.connect(later);
    if (!later.site.publishers.empty()) return std::move(later.site);
  }
  return std::move(draft.site);
}

}  // namespace tzc::rewriter
