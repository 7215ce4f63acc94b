// SPDX-License-Identifier: BSD-3-Clause
#include "engine/api_calls.h"

#include "parse/ast_visitor.h"
#include "parse/source.h"

namespace tzc::rewriter {
namespace {

std::string space_of(const clang::DeclContext* context) {
  std::string space;
  for (; context && !context->isTranslationUnit(); context = context->getParent())
    if (const auto* named = llvm::dyn_cast<clang::NamedDecl>(context))
      if (!context->isInlineNamespace()) space = named->getNameAsString() + "::" + space;
  return space;
}

/// Functions by name; the classes or namespaces that have them.
const std::map<std::string, SiteKind> kinds = {{"advertise", SiteKind::advertise},
                                               {"advertiseCamera", SiteKind::advertise},
                                               {"publish", SiteKind::publish},
                                               {"subscribe", SiteKind::subscribe},
                                               {"subscribeCamera", SiteKind::subscribe}};

const std::set<std::string> filters = {
    "message_filters::Subscriber::", "image_transport::SubscriberFilter::",
    "tzc::message_filters::Subscriber::", "tzc::image_transport::SubscriberFilter::"};

const std::set<std::string> owners = {"ros::NodeHandle::",
                                      "ros::Publisher::",
                                      "ros::SingleSubscriberPublisher::",
                                      "image_transport::ImageTransport::",
                                      "image_transport::Publisher::",
                                      "image_transport::CameraPublisher::",
                                      "image_transport::SingleSubscriberPublisher::",
                                      "tzc::",
                                      "tzc::Publisher::",
                                      "tzc::message_filters::",
                                      "tzc::image_transport::",
                                      "tzc::image_transport::Publisher::",
                                      "tzc::image_transport::CameraPublisher::"};

/// Functions of libraries that advertise, publish or subscribe for the package: whole names.
const std::map<std::string, SiteKind> on_behalf = {
    {"ros::topic::waitForMessage", SiteKind::subscribe},
    {"realtime_tools::RealtimePublisher::init", SiteKind::advertise},
    {"realtime_tools::RealtimePublisher::unlockAndPublish", SiteKind::publish}};

const clang::TemplateArgumentList* template_arguments(const clang::FunctionDecl* function) {
  return function->getTemplateSpecializationArgs();
}

/// What gencpp makes, and no cv::Rect_.
bool is_generated(const clang::ClassTemplateSpecializationDecl* record) {
  const clang::CXXRecordDecl* pattern = record->getSpecializedTemplate()->getTemplatedDecl()->getDefinition();
  return pattern && llvm::any_of(pattern->decls(), [](const clang::Decl* member) {
           const auto* name = llvm::dyn_cast<clang::TypedefNameDecl>(member);
           return name && name->getName() == "ConstPtr";
         });
}

/// sensor_msgs::Image_<A> and tzc::sensor_msgs::Image are "sensor_msgs/Image", by pointer as well.
std::string message_name(clang::QualType type) {
  if (type.isNull()) return "";
  const clang::CXXRecordDecl* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  if (!record) return "";
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  if (made && record->getName() == "shared_ptr") return message_name(made->getTemplateArgs()[0].getAsType());
  std::string space = space_of(record->getDeclContext()), name = record->getNameAsString();
  if (space.rfind("tzc::", 0) == 0)
    space.erase(0, 5);
  else if (made && name.back() == '_' && is_generated(made))
    name.pop_back();
  else
    return "";
  const std::size_t colons = space.find("::");
  return colons + 2 == space.size() ? space.substr(0, colons) + "/" + name : "";
}

/// The message that a function or the class that has it is a template of.
std::string first_message(const clang::TemplateArgumentList* arguments) {
  const bool named =
      arguments && arguments->size() > 0 && (*arguments)[0].getKind() == clang::TemplateArgument::Type;
  return named ? message_name((*arguments)[0].getAsType()) : "";
}

std::string message_of_template(const clang::FunctionDecl* function) {
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(function->getDeclContext());
  return first_message(made ? &made->getTemplateArgs() : template_arguments(function));
}

/// subscribe(options) as a template has it, with a variable or member of its own: not the one of an instance.
bool is_of_template(const clang::Expr* options) {
  const clang::Expr* written = options->IgnoreParenImpCasts();
  const clang::DeclContext* context = nullptr;
  if (const auto* variable = llvm::dyn_cast<clang::DeclRefExpr>(written))
    context = variable->getDecl()->getDeclContext();
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(written))
    context = member->getMemberDecl()->getDeclContext();
  return context && context->isDependentContext();
}

class ApiCalls : public AstVisitor {
 public:
  ApiCalls(const Source& source, const std::set<std::string>& exported)
      : source_(source), exported_(exported) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }
  std::set<ApiCall> calls;

  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (!function || !function->getIdentifier() || call->isTypeDependent()) return true;
    if (function->getName().starts_with("make_")) return note_made(call, function);
    if (function->getName().starts_with("emplace") || function->getName() == "try_emplace")
      return note_emplaced_filter(call, function);
    const std::string owner = space_of(function->getDeclContext());
    const auto behalf = on_behalf.find(owner + function->getNameAsString());
    if (behalf != on_behalf.end()) note_behalf(behalf->second, call, function);
    note_library_advertise(call, function);
    if (owners.count(owner) == 0) note_library_publish(call, function);
    const auto kind = kinds.find(function->getNameAsString());
    if (kind == kinds.end() || written(call) == 0) return true;
    if (kind->second == SiteKind::subscribe && written(call) == 1 && is_of_template(call->getArg(0)))
      return true;
    const bool is_ours =
        owner == "tzc::" || owner == "tzc::image_transport::";  // the publisher is the first argument
    if (is_ours && kind->second == SiteKind::publish)
      note(kind->second, call, message_name(call->getArg(1)->IgnoreImplicit()->getType()));
    else if (owners.count(owner) != 0)
      note(kind->second, call, type_at(kind->second, call, function));
    if (filters.count(owner) != 0 && written(call) >= 2) note(SiteKind::subscribe, call, "");
    return true;
  }

  /// The instances of generic lambdas, which no other declaration leads to.
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    clang::FunctionTemplateDecl* pattern = lambda->getLambdaClass()->getDependentLambdaCallOperator();
    if (!pattern || !lambda->isGenericLambda()) return true;
    for (clang::FunctionDecl* instance : pattern->specializations())
      if (instance->hasBody() && instances_.insert(instance).second) TraverseDecl(instance);
    return true;
  }

  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construct) override {
    const clang::CXXConstructorDecl* inherited =
        construct->getConstructor()->getInheritedConstructor().getConstructor();
    const clang::CXXRecordDecl* record = (inherited ? inherited : construct->getConstructor())->getParent();
    if (construct->getNumArgs() >= 2 && is_filter(record)) note(SiteKind::subscribe, construct, "");
    if (construct->getNumArgs() >= 3 && is_realtime_publisher(record))
      note_behalf(SiteKind::advertise, construct, construct->getConstructor());
    return true;
  }

 private:
  static unsigned written(const clang::CallExpr* call) {
    return static_cast<unsigned>(llvm::count_if(
        call->arguments(), [](const clang::Expr* e) { return !llvm::isa<clang::CXXDefaultArgExpr>(e); }));
  }
  static bool is_filter(const clang::CXXRecordDecl* record) {
    return record &&
           filters.count(space_of(record->getDeclContext()) + record->getNameAsString() + "::") != 0;
  }
  static bool is_realtime_publisher(const clang::CXXRecordDecl* record) {
    return record && space_of(record) == "realtime_tools::RealtimePublisher::";
  }
  static std::string type_at(SiteKind kind, const clang::CallExpr* call,
                             const clang::FunctionDecl* function) {
    if (kind == SiteKind::publish) return message_name(call->getArg(0)->IgnoreImplicit()->getType());
    const clang::TemplateArgumentList* arguments = template_arguments(function);
    const bool named = kind == SiteKind::advertise && arguments && arguments->size() > 0 &&
                       (*arguments)[0].getKind() == clang::TemplateArgument::Type;
    return named ? message_name((*arguments)[0].getAsType()) : "";
  }

  static bool is_twin(clang::QualType type) {
    const clang::CXXRecordDecl* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
    const auto* made = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
    if (made && record->getName() == "shared_ptr") return is_twin(made->getTemplateArgs()[0].getAsType());
    return record && space_of(record->getDeclContext()).rfind("tzc::", 0) == 0;
  }

  /// A member function publish...(M) of a class outside the package. One that takes a tzc:: message is ported: it is a site of
  /// its own package.
  void note_library_publish(const clang::CallExpr* call, const clang::FunctionDecl* function) {
    if (!llvm::isa<clang::CXXMemberCallExpr>(call) || !function->getName().starts_with("publish")) return;
    const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern();
    if (source_.in_package((pattern ? pattern : function)->getLocation())) return;
    for (const clang::ParmVarDecl* parameter : function->parameters())
      if (const std::string message = message_name(parameter->getType());
          !message.empty() && !is_twin(parameter->getType()))
        return note(SiteKind::publish, call, message);
  }

  /// make_shared<T>(...) and its likes
  bool note_made(const clang::CallExpr* call, const clang::FunctionDecl* function) {
    const clang::TemplateArgumentList* arguments = template_arguments(function);
    if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
      return true;
    const clang::CXXRecordDecl* made = (*arguments)[0].getAsType()->getAsCXXRecordDecl();
    if (call->getNumArgs() >= 2 && is_filter(made)) note(SiteKind::subscribe, call, "");
    const auto* instance = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(made);
    if (instance && call->getNumArgs() >= 3 && is_realtime_publisher(made))
      if (const std::string message = first_message(&instance->getTemplateArgs()); !message.empty())
        note(SiteKind::advertise, call, message);
    return true;
  }

  /// subscribers.emplace_back(nh, "topic", 1), by_name.try_emplace("name", nh, "topic", 1),
  /// by_name.emplace(std::piecewise_construct, ..., std::forward_as_tuple(nh, "topic", 1))
  bool note_emplaced_filter(const clang::CallExpr* call, const clang::FunctionDecl* function) {
    const auto* container =
        llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(function->getDeclContext());
    if (!container || call->getNumArgs() < 2) return true;
    const bool tries = function->getName() == "try_emplace";
    if (holds_filter(container, 0) && !tries) note(SiteKind::subscribe, call, "");
    const auto* tuple =
        llvm::dyn_cast<clang::CallExpr>(call->getArg(call->getNumArgs() - 1)->IgnoreImplicit());
    const clang::FunctionDecl* made_by = tuple ? tuple->getDirectCallee() : nullptr;
    const bool is_tuple =
        made_by && made_by->getNameAsString() == "forward_as_tuple" && tuple->getNumArgs() >= 2;
    if (holds_filter(container, 1) && (tries ? call->getNumArgs() >= 3 : is_tuple))
      note(SiteKind::subscribe, call, "");
    return true;
  }

  static bool holds_filter(const clang::ClassTemplateSpecializationDecl* container, unsigned index) {
    if (container->getTemplateArgs().size() <= index) return false;
    const clang::TemplateArgument& held = container->getTemplateArgs()[index];
    return held.getKind() == clang::TemplateArgument::Type &&
           is_filter(held.getAsType()->getAsCXXRecordDecl());
  }

  /// A function of the package itself that no other package may call.
  bool is_inner(const clang::FunctionDecl* function) const {
    if (!source_.in_package(function->getLocation())) return false;
    const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern();
    const clang::FunctionDecl* first = (pattern ? pattern : function)->getFirstDecl();
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(first);
    if (first->getAccess() == clang::AS_private && !(method && method->isVirtual())) return true;
    const std::string& file = source_.file_of(first->getLocation());
    return llvm::none_of(exported_, [&](const std::string& path) {
      return file == path || llvm::StringRef(file).starts_with(path + "/");
    });
  }

  /// pub = advertise<M>(...), a library's own: what it returns is a publisher of the package.
  void note_library_advertise(const clang::CallExpr* call, const clang::FunctionDecl* function) {
    const std::string name = space_of(function->getDeclContext());
    if (!function->getName().starts_with("advertise") || owners.count(name) != 0) return;
    const clang::CXXRecordDecl* result = function->getReturnType().getCanonicalType()->getAsCXXRecordDecl();
    if (!result || is_inner(function)) return;
    const std::string publisher = space_of(result->getDeclContext()) + result->getNameAsString();
    if (publisher == "image_transport::Publisher" || publisher == "image_transport::CameraPublisher")
      return note(SiteKind::advertise, call, "sensor_msgs/Image");
    if (publisher == "laser_proc::LaserPublisher" && !source_.in_package(function->getLocation()))
      return note(SiteKind::advertise, call, "sensor_msgs/MultiEchoLaserScan");
    const std::string message = type_at(SiteKind::advertise, call, function);
    if (publisher == "ros::Publisher" && (!message.empty() || names_cloud(function)))
      note(SiteKind::advertise, call, message);
  }

  static bool names_cloud(const clang::FunctionDecl* function) {
    const clang::TemplateArgumentList* arguments = template_arguments(function);
    if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
      return false;
    const clang::CXXRecordDecl* record = (*arguments)[0].getAsType().getCanonicalType()->getAsCXXRecordDecl();
    return record && space_of(record->getDeclContext()) + record->getNameAsString() == "pcl::PointCloud";
  }

  void note_behalf(SiteKind kind, const clang::Expr* call, const clang::FunctionDecl* function) {
    const std::string message = message_of_template(function);
    if (!message.empty()) note(kind, call, message);
  }

  void note(SiteKind kind, const clang::Expr* call, const std::string& type) {
    const Place where = source_.where(call->getExprLoc());
    if (source_.in_package(call->getExprLoc()))
      calls.insert({kind, location_of(where), type, source_.offsets_in_macros(call->getExprLoc())});
  }

  const Source& source_;
  const std::set<std::string>& exported_;
  std::set<const clang::FunctionDecl*> instances_;
};

}  // namespace

std::set<ApiCall> api_calls(clang::ASTContext& ast, const FolderSet& packages,
                            const std::set<std::string>& exported) {
  const Source source(ast, packages);
  ApiCalls visitor(source, exported);
  for (clang::Decl* decl : ast.getTranslationUnitDecl()->decls())
    if (source.in_package(decl->getLocation())) visitor.TraverseDecl(decl);
  return std::move(visitor.calls);
}

}  // namespace tzc::rewriter
