// SPDX-License-Identifier: BSD-3-Clause
#include <clang/AST/ParentMapContext.h>

#include "facts/advertise_sites.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

bool is_single_subscriber(const std::string& name) {
  return name == "ros::SingleSubscriberPublisher" || name == "image_transport::SingleSubscriberPublisher";
}

std::string id_of(const Place& where, const std::string& type) {
  return where.file + ":" + std::to_string(where.begin) + "<" + type;
}

/// Notes the statement that is nothing but this call.
void describe_statement(Unit& unit, const clang::Expr* call, Publish& site) {
  const clang::FunctionDecl* function = function_around(unit, *call);
  site.in_void_function = function && function->getReturnType()->isVoidType();
  clang::DynTypedNode node = clang::DynTypedNode::create(*call);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty()) return;
    node = parents[0];
    if (node.get<clang::ExprWithCleanups>()) continue;
    site.in_block = node.get<clang::CompoundStmt>() != nullptr;
    if (site.in_block || node.get<clang::IfStmt>() || node.get<clang::ForStmt>())
      site.statement = unit.source.before(call->getBeginLoc()).value_or(Place());
    site.statement_end = unit.source.behind(call->getSourceRange()).value_or(Place());
    if (site.statement_end.file.empty()) site.statement = Place();
    return;
  }
}

/// The written argument, without the conversions that the call implies.
const clang::Expr* written(const clang::Expr* expr) {
  for (;;) {
    const clang::Expr* next = expr->IgnoreImplicit();
    const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(next);
    if (construct && !llvm::isa<clang::CXXTemporaryObjectExpr>(construct) && construct->getNumArgs() >= 1 &&
        !construct->isListInitialization())
      next = construct->getArg(0);
    if (next == expr) return expr;
    expr = next;
  }
}

void describe_message(Unit& unit, const clang::Expr* argument, Publish& site) {
  const clang::QualType type = argument->getType();
  const clang::QualType pointee = pointee_of(type);
  const std::optional<MessageType> message = message_of(pointee.isNull() ? type : pointee);
  if (const auto twin = twin_message_of(pointee.isNull() ? type : pointee)) {
    site.type = twin->name;
    site.twin = true;
    return;
  }
  if (message) {
    site.type = message->name;
    site.heavy = message->has_data;
    site.nested_only = message->has_data && !message->direct_data;
  } else if (is_pcl_cloud(type)) {
    site.type = "sensor_msgs/PointCloud2";
    site.pcl = true;
  } else if (is_cv_image(type)) {
    site.type = "sensor_msgs/Image";
    site.pcl = true;
  } else {
    site.type = type.getAsString();
    site.obstacles.push_back({codes::TZC1012, "the type of what is published is '" + site.type + "'",
                              location_of(unit.source.where(argument->getBeginLoc()))});
  }
  const Sources sources = sources_of(unit, argument);
  site.messages = sources.keys;
  if (sources.foreign && message && message->has_data)
    site.obstacles.push_back({codes::TZC1013, "code outside the package builds the message",
                              location_of(unit.source.where(argument->getBeginLoc()))});
}

std::string object_text(Unit& unit, const clang::Expr* argument) {
  if (!argument->isLValue() ||
      llvm::isa<clang::CallExpr>(argument) != llvm::isa<clang::CXXOperatorCallExpr>(argument))
    return "";
  const std::string text = unit.source.text(argument->getSourceRange());
  return pointee_of(argument->getType()).isNull() ? text : "*" + text;
}

void describe_publisher(Unit& unit, const clang::CXXMemberCallExpr* call, Publish& site) {
  const Receiver receiver = receiver_of(call);
  if (!receiver.expr) return;
  const Sources sources = sources_of(unit, receiver.expr);
  if (!sources.keys.empty()) site.publisher = sources.keys[0];
  site.publisher_text = unit.source.text(receiver.expr->getSourceRange()) + (receiver.pointer ? "->" : ".");
  unit.publishers.push_back({receiver.expr, receiver.pointer, site.publisher, site.messages,
                             function_around(unit, *call), site.where.begin});
}

/// What is advertised: advertise<M>(...), or the options' type.
clang::QualType advertised_type(Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method->getTemplateSpecializationArgs() && written_arguments(call) == 1)
    return options_message(unit, call->getArg(0)).value_or(clang::QualType());
  const clang::TemplateArgumentList* arguments = method->getTemplateSpecializationArgs();
  if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
    return {};
  return (*arguments)[0].getAsType();
}

std::optional<Place> behind_argument(Unit& unit, const clang::CallExpr* call, unsigned index) {
  if (written_arguments(call) <= index) return {};
  std::optional<Place> place = unit.source.place(call->getArg(index)->getSourceRange());
  if (place) place->begin = place->end;
  return place;
}

bool takes_template_parameter(const clang::CXXMemberCallExpr* call) {
  const auto* callee = llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
  return callee && callee->getNumTemplateArgs() != 0 &&
         is_template_parameter(callee->getTemplateArgs()[0].getArgument());
}

void change_advertise(Unit& unit, const clang::CXXMemberCallExpr* call, const MethodCall& rule,
                      Advertise& site) {
  std::string to = rule.to;
  if (rule.role == MethodCall::Role::advertise) {
    const std::string written = written_template_arguments(unit, call);
    const std::string stock = written.empty() ? stock_name(site.type) : written;
    const bool as_written = site.no_twin || takes_template_parameter(call);
    to += "<" + (as_written ? stock : twin_name(site.type)) + ">";
  }
  site.changes = receiver_first(unit, call, to, rule.rule, rule.header);
  if (site.changes.empty()) {
    site.obstacles.push_back(
        {codes::TZC1006, "the advertise call comes from a macro", location_of(site.where)});
    return;
  }
  if (!site.no_twin && rule.role == MethodCall::Role::advertise)
    site.changes[0].headers.push_back(twin_header(site.type));
  const clang::QualType type = advertised_type(unit, call);
  if (!type.isNull() && is_pcl_cloud(type)) site.changes[0].headers.push_back("tzc/pcl.h");
  if (rule.role != MethodCall::Role::advertise) return;
  const unsigned last = written_arguments(call) == 1 ? 0 : 1;
  if (const auto memory = behind_argument(unit, call, last))
    site.changes.push_back({*memory, ", $MEM", rule.rule, {}});
  else
    site.obstacles.push_back({codes::TZC1006, "an argument comes from a macro", location_of(site.where)});
}

}  // namespace

bool is_publisher_class(const std::string& name) {
  static const std::set<std::string> names = {"Publisher", "CameraPublisher"};
  static const std::set<std::string> spaces = {
      "ros::", "image_transport::", "tzc::", "tzc::image_transport::"};
  const std::size_t colons = name.rfind("::");
  if (colons == std::string::npos) return false;
  return is_single_subscriber(name) ||
         (names.count(name.substr(colons + 2)) && spaces.count(name.substr(0, colons + 2)));
}

void collect_publish(Unit& unit, const clang::CXXMemberCallExpr* call) {
  if (call->getNumArgs() == 0 || call->isTypeDependent()) return;
  Publish site;
  site.where = unit.source.where(call->getExprLoc());
  site.function = function_name_around(unit, *call);
  describe_statement(unit, call, site);
  const clang::Expr* argument = written(call->getArg(0));
  if (argument->isTypeDependent()) return;
  describe_message(unit, argument, site);
  site.object = object_text(unit, argument);
  describe_publisher(unit, call, site);
  if (is_single_subscriber(qualified_name_of(call->getRecordDecl())))
    site.obstacles.push_back(
        {codes::TZC1014, "the message is sent to one subscriber only", location_of(site.where)});
  else if (site.publisher.empty())
    site.obstacles.push_back(
        {codes::TZC1017, "the publisher is not one of the package", location_of(site.where)});
  unit.facts.publishes.emplace(id_of(site.where, site.type), site);
}

Advertise advertise_at(Unit& unit, const clang::CallExpr* call, const char* rule) {
  Advertise site;
  site.where = unit.source.where(call->getExprLoc());
  site.function = function_name_around(unit, *call);
  site.rule = rule;
  site.type = "sensor_msgs/Image";
  return site;
}

void describe_type(const Unit& unit, clang::QualType type, Advertise& site) {
  const std::optional<MessageType> twin = twin_message_of(type);
  if (const auto message = twin ? twin : message_of(type)) {
    site.type = message->name;
    site.heavy = message->has_data;
    site.no_twin = !message->has_data || message->service || !has_twin(unit, site.type);
  } else if (is_pcl_cloud(type)) {
    site.type = "sensor_msgs/PointCloud2";
    site.no_twin = site.pcl = true;
  } else {
    site.type = type.getAsString();
    site.no_twin = true;
    site.heavy = false;
  }
}

void add_advertise(Unit& unit, Advertise site) {
  const std::string id = id_of(site.where, site.type);
  unit.facts.advertises.emplace(id, std::move(site));
}

std::optional<std::string> written_text(Unit& unit, const clang::CallExpr* call, unsigned index) {
  if (written_arguments(call) <= index) return {};
  return unit.source.text(call->getArg(index)->getSourceRange());
}

bool is_template_parameter(const clang::TemplateArgument& argument) {
  return argument.getKind() == clang::TemplateArgument::Type &&
         argument.getAsType()->getAs<clang::SubstTemplateTypeParmType>() != nullptr;
}

void collect_advertise(Unit& unit, const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  Advertise site = advertise_at(unit, call, rule.rule);
  if (rule.role == MethodCall::Role::advertise) {
    const clang::QualType type = advertised_type(unit, call);
    if (!type.isNull())
      describe_type(unit, type, site);
    else
      site.obstacles.push_back(
          {codes::TZC1012, "the options of this call say what is advertised", location_of(site.where)});
  }
  if (written_arguments(call) > 0) site.topic = constant_string(call->getArg(0));
  site.queue = written_text(unit, call, 1);
  site.publisher = declare_temporary(unit, call);
  change_advertise(unit, call, rule, site);
  for (const Obstacle& obstacle : site.obstacles)
    unit.facts.entities[site.publisher].obstacles.push_back(obstacle);
  add_advertise(unit, std::move(site));
}

void collect_ported_advertise(Unit& unit, const clang::CallExpr* call, const MethodCall& rule) {
  Advertise site = advertise_at(unit, call, rule.rule);
  const clang::TemplateArgumentList* arguments = call->getDirectCallee()->getTemplateSpecializationArgs();
  if (rule.role == MethodCall::Role::advertise && arguments)
    describe_type(unit, (*arguments)[0].getAsType(), site);
  if (written_arguments(call) > 1) site.topic = constant_string(call->getArg(1));
  site.memory = rule.role == MethodCall::Role::advertise ? written_text(unit, call, site.topic ? 3 : 2) : "0";
  site.publisher = declare_temporary(unit, call);
  add_advertise(unit, std::move(site));
}

}  // namespace tzc::rewriter
