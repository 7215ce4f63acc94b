// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/message_type.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>

#include "facts/syntax/light_types.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

const clang::CXXRecordDecl* record_of(clang::QualType type) {
  if (type.isNull()) return nullptr;
  return type.getNonReferenceType().getCanonicalType().getUnqualifiedType()->getAsCXXRecordDecl();
}

const clang::ClassTemplateSpecializationDecl* specialization_of(clang::QualType type) {
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record_of(type));
}

bool is_std_template(const clang::ClassTemplateSpecializationDecl* decl, llvm::StringRef name) {
  return decl && decl->getName() == name && decl->isInStdNamespace();
}

/// The definition may stand behind a declaration (ROS_DECLARE_MESSAGE), of which instances are then seen to be.
const clang::CXXRecordDecl* pattern_of(const clang::ClassTemplateDecl* decl) {
  const clang::CXXRecordDecl* pattern = decl->getTemplatedDecl();
  const clang::CXXRecordDecl* definition = pattern->getDefinition();
  return definition ? definition : pattern;
}

/// A message that is only used by pointer is not instantiated; its template, whose types are dependent, is examined.
const clang::CXXRecordDecl* fields_of(const clang::ClassTemplateSpecializationDecl* message) {
  return message->hasDefinition() ? message->getDefinition() : pattern_of(message->getSpecializedTemplate());
}

bool has_message_shape(const clang::ClassTemplateSpecializationDecl* decl) {
  if (!decl || !decl->getName().ends_with("_") || decl->getTemplateArgs().size() != 1) return false;
  if (!llvm::isa_and_nonnull<clang::NamespaceDecl>(decl->getDeclContext())) return false;
  return llvm::any_of(pattern_of(decl->getSpecializedTemplate())->decls(), [](const clang::Decl* member) {
    const auto* name = llvm::dyn_cast<clang::TypedefNameDecl>(member);
    return name && name->getName() == "ConstPtr";
  });
}

bool is_fixed_length(clang::QualType type);
bool is_fixed_pattern(clang::QualType type, unsigned depth);

bool all_fields_fixed(const clang::CXXRecordDecl* record) {
  return llvm::all_of(record->fields(),
                      [](const clang::FieldDecl* f) { return is_fixed_pattern(f->getType(), 0); });
}

bool is_fixed_length(clang::QualType type) {
  if (type->isArithmeticType()) return true;
  const clang::CXXRecordDecl* record = record_of(type);
  if (!record) return false;
  const auto* templated = specialization_of(type);
  if (templated && templated->getName() == "array") return is_fixed_length(first_argument(templated));
  const std::string name = qualified_name_of(record);
  if (name == "ros::Time" || name == "ros::Duration") return true;
  return has_message_shape(templated) && all_fields_fixed(fields_of(templated));
}

void look_into_pattern(clang::QualType type, bool nested, MessageType& message, unsigned depth);

/// "sensor_msgs/Image" of sensor_msgs::Image_.
std::string message_name(const clang::NamedDecl* record) {
  const auto* space = llvm::dyn_cast<clang::NamedDecl>(record->getDeclContext());
  return (space ? qualified_name_of(space) : "") + "/" + record->getName().drop_back().str();
}

void note_data_array(clang::QualType element, bool nested, MessageType& message) {
  message.elements.insert(element_name(element));
  message.has_data_part = true;
  if (!nested) message.has_direct_data_part = true;
  message.most_bytes.reset();
}

/// What the fields of `record` added to the bound of the message around it, unless its type says better.
void bound_by_type(const clang::NamedDecl* record, std::optional<std::uint64_t> before,
                   MessageType& message) {
  if (message.most_bytes) return;
  if (const auto bytes = light_type_bytes(message_name(record)); bytes && before)
    message.most_bytes = *before + *bytes;
}

/// CameraInfo[100]: the bound was that of one element.
void note_repeated(std::optional<std::uint64_t> before, MessageType& message) {
  if (message.most_bytes != before) message.most_bytes.reset();
}

void look_into_fields(const clang::CXXRecordDecl* fields, bool nested, MessageType& message, unsigned depth) {
  const std::optional<std::uint64_t> before = message.most_bytes;
  for (const clang::FieldDecl* field : fields->fields())
    look_into_pattern(field->getType(), nested, message, depth);
  if (!nested) bound_by_type(fields, before, message);
}

/// `nested`: the field lies in an array of messages.
void look_into(clang::QualType type, bool nested, MessageType& message) {
  const auto* templated = specialization_of(type);
  if (is_std_template(templated, "vector")) {
    const clang::QualType element = first_argument(templated);
    if (!is_fixed_length(element)) {
      message.has_varied_elements = true;
      return look_into(element, true, message);
    }
    note_data_array(element, nested, message);
  } else if (templated && templated->getName() == "array") {
    const std::optional<std::uint64_t> before = message.most_bytes;
    look_into(first_argument(templated), nested, message);
    note_repeated(before, message);
  } else if (has_message_shape(templated)) {
    look_into_fields(fields_of(templated), nested, message, 0);
  }
}

const clang::ClassTemplateDecl* template_decl_of(const clang::TemplateSpecializationType* type) {
  return type ? llvm::dyn_cast_or_null<clang::ClassTemplateDecl>(type->getTemplateName().getAsTemplateDecl())
              : nullptr;
}

bool is_fixed_pattern(clang::QualType type, unsigned depth) {
  if (!type->isDependentType()) return is_fixed_length(type);
  const auto* written = type->getAs<clang::TemplateSpecializationType>();
  const clang::ClassTemplateDecl* decl = template_decl_of(written);
  if (!decl || depth > 8) return false;
  if (decl->getName() == "array")
    return is_fixed_pattern(written->template_arguments()[0].getAsType(), depth + 1);
  if (!decl->getName().ends_with("_")) return false;
  return llvm::all_of(pattern_of(decl)->fields(), [&](const clang::FieldDecl* field) {
    return is_fixed_pattern(field->getType(), depth + 1);
  });
}

void look_into_pattern(clang::QualType type, bool nested, MessageType& message, unsigned depth) {
  if (!type->isDependentType()) return look_into(type, nested, message);
  const auto* written = type->getAs<clang::TemplateSpecializationType>();
  const clang::ClassTemplateDecl* decl = template_decl_of(written);
  if (!decl || depth > 8) return;
  if (decl->getName() == "vector") {
    const clang::QualType element = written->template_arguments()[0].getAsType();
    if (!is_fixed_pattern(element, 0)) {
      message.has_varied_elements = true;
      return look_into_pattern(element, true, message, depth + 1);
    }
    note_data_array(element, nested, message);
  } else if (decl->getName() == "array") {
    const std::optional<std::uint64_t> before = message.most_bytes;
    look_into_pattern(written->template_arguments()[0].getAsType(), nested, message, depth + 1);
    note_repeated(before, message);
  } else if (decl->getName().ends_with("_")) {
    look_into_fields(pattern_of(decl), nested, message, depth + 1);
  }
}

bool is_known_wrapper(const clang::CXXRecordDecl* record) {
  static const std::set<std::string> own = {"ros::MessageEvent"};
  const std::string name = qualified_name_of(record);
  return name.rfind("std::", 0) == 0 || name.rfind("boost::", 0) == 0 || name.rfind("__gnu_cxx::", 0) == 0 ||
         own.count(name);
}

std::optional<Carried> carried_by_template(const clang::ClassTemplateSpecializationDecl* decl,
                                           const RuleSet& rules, unsigned depth);

std::optional<Carried> carried_at(clang::QualType type, const RuleSet& rules, unsigned depth) {
  if (type.isNull() || depth > 6) return {};
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isPointerType()) return carried_at(type->getPointeeType(), rules, depth + 1);
  if (const auto* array = type->getAsArrayTypeUnsafe())
    return carried_at(array->getElementType(), rules, depth + 1);
  const clang::CXXRecordDecl* record = record_of(type);
  if (!record) return {};
  const std::string name = qualified_name_of(record);
  if (const ClassRename* rename = rules.find_class_or_ported(name)) {
    return Carried{role_of(*rename), {}, rename, name != rename->from};
  }
  if (std::optional<MessageType> message = message_of(record)) {
    if (!message->has_data_part) return {};
    return Carried{EntityRole::message, message, nullptr, false};
  }
  return carried_by_template(llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record), rules, depth);
}

std::optional<Carried> carried_by_template(const clang::ClassTemplateSpecializationDecl* decl,
                                           const RuleSet& rules, unsigned depth) {
  if (!decl || !is_known_wrapper(decl) || decl->getName() == "function") return {};
  for (const clang::TemplateArgument& argument : decl->getTemplateArgs().asArray()) {
    if (argument.getKind() == clang::TemplateArgument::Type)
      if (auto carried = carried_at(argument.getAsType(), rules, depth + 1)) return carried;
    if (argument.getKind() == clang::TemplateArgument::Pack && decl->getName() == "tuple")
      for (const clang::TemplateArgument& part : argument.pack_elements())
        if (part.getKind() == clang::TemplateArgument::Type)
          if (auto carried = carried_at(part.getAsType(), rules, depth + 1)) return carried;
  }
  return {};
}

/// Whether the unit sees the service: Ask, which has the type Request, of AskRequest. A topic's message may be called so, too.
bool is_part_of_service(const clang::ClassTemplateSpecializationDecl* message) {
  const llvm::StringRef name = message->getName().drop_back();
  for (const llvm::StringRef part : {llvm::StringRef("Request"), llvm::StringRef("Response")}) {
    if (!name.ends_with(part) || name == part) continue;
    clang::IdentifierTable& names = message->getASTContext().Idents;
    const clang::DeclarationName service(&names.get(name.drop_back(part.size())));
    for (const clang::NamedDecl* found : message->getDeclContext()->getRedeclContext()->lookup(service)) {
      const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(found);
      if (record && !record->lookup(clang::DeclarationName(&names.get(part))).empty()) return true;
    }
  }
  return false;
}

}  // namespace

EntityRole role_of(const ClassRename& rename) {
  if (rename.role == ClassRename::Role::publisher) return EntityRole::publisher;
  return rename.role == ClassRename::Role::filter ? EntityRole::filter : EntityRole::message;
}

std::optional<MessageType> message_of(const clang::CXXRecordDecl* record) {
  const auto* templated = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
  if (!has_message_shape(templated)) return {};
  MessageType message;
  message.record = record;
  message.name = message_name(templated);
  message.service = is_part_of_service(templated);
  look_into_fields(fields_of(templated), false, message, 0);
  return message;
}

/// Large by what it is for, a pose for each step of a plan or of all that was driven so far, though shared memory can hold none of its
/// arrays in place: the elements have strings.
static bool is_gathered(const MessageType& message) {
  return !message.has_data_part && message.name == "nav_msgs/Path";
}

void set_message(SiteFact& site, const MessageType& message) {
  site.type = message.name;
  site.is_gathered = is_gathered(message);
  site.has_data_part = message.has_data_part || site.is_gathered;
  site.has_varied_elements = message.has_varied_elements;
  site.elements = message.elements;
  site.most_bytes = site.is_gathered ? std::nullopt : message.most_bytes;
}

std::optional<MessageType> message_of(clang::QualType type) {
  return message_of(record_of(type));
}

std::optional<MessageType> twin_message_of(clang::QualType type) {
  const clang::CXXRecordDecl* record = record_of(type);
  if (!record || !record->hasDefinition() || qualified_name_of(record).rfind("tzc::", 0) != 0) return {};
  for (const clang::Decl* member : record->getDefinition()->decls())
    if (const auto* name = llvm::dyn_cast<clang::TypedefNameDecl>(member))
      if (name->getName() == "Stock") return message_of(name->getUnderlyingType());
  return {};
}

bool is_data_array(clang::QualType type) {
  const auto* templated = specialization_of(type);
  return is_std_template(templated, "vector") && is_fixed_length(first_argument(templated));
}

std::string element_name(clang::QualType element) {
  if (const clang::CXXRecordDecl* record = record_of(element)) return qualified_name_of(record);
  if (const clang::ClassTemplateDecl* decl =
          template_decl_of(element->getAs<clang::TemplateSpecializationType>()))
    return qualified_name_of(decl);
  return element.getCanonicalType().getUnqualifiedType().getAsString();
}

std::optional<Carried> carried_by(clang::QualType type, const RuleSet& rules) {
  return carried_at(type, rules, 0);
}

clang::QualType pointee_of(clang::QualType type) {
  if (type.isNull()) return {};
  type = type.getNonReferenceType();
  if (type->isPointerType()) return type->getPointeeType();
  const auto* templated = specialization_of(type);
  if (!templated) return {};
  const llvm::StringRef name = templated->getName();
  if (name != "shared_ptr" && name != "unique_ptr" && name != "scoped_ptr") return {};
  return first_argument(templated);
}

namespace {

std::vector<clang::QualType> types_in(const clang::TemplateArgument& argument) {
  std::vector<clang::QualType> types;
  if (argument.getKind() == clang::TemplateArgument::Type) types.push_back(argument.getAsType());
  if (argument.getKind() == clang::TemplateArgument::Pack)
    for (const clang::TemplateArgument& part : argument.pack_elements())
      if (part.getKind() == clang::TemplateArgument::Type) types.push_back(part.getAsType());
  return types;
}

bool reaches_messages(clang::QualType type, bool through_pointers) {
  static const std::set<std::string> containers = {
      "vector",   "deque", "list",  "forward_list", "array", "map",      "unordered_map",
      "multimap", "queue", "stack", "pair",         "tuple", "optional", "circular_buffer"};
  if (type->isReferenceType()) return through_pointers && reaches_messages(type.getNonReferenceType(), true);
  if (const auto* array = type->getAsArrayTypeUnsafe())
    return reaches_messages(array->getElementType(), through_pointers);
  if (const clang::QualType pointee = pointee_of(type); !pointee.isNull())
    return through_pointers && reaches_messages(pointee, true);
  if (message_of(type) || twin_message_of(type)) return true;
  const auto* templated = specialization_of(type);
  if (!templated || !is_known_wrapper(templated)) return false;
  const std::string name = qualified_name_of(templated);
  if (containers.count(name.substr(name.rfind(':') + 1)) == 0) return false;
  return llvm::any_of(templated->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& argument) {
    return llvm::any_of(types_in(argument),
                        [&](clang::QualType part) { return reaches_messages(part, through_pointers); });
  });
}

}  // namespace

bool holds_messages(clang::QualType type) {
  return reaches_messages(type, false);
}

bool leads_to_messages(clang::QualType type) {
  return reaches_messages(type.getNonReferenceType(), true);
}

namespace {

std::optional<MessageType> message_reached_at(clang::QualType type, unsigned depth) {
  if (type.isNull() || depth > 6) return {};
  type = type.getNonReferenceType();
  if (const auto* array = type->getAsArrayTypeUnsafe())
    return message_reached_at(array->getElementType(), depth + 1);
  if (const clang::QualType pointee = pointee_of(type); !pointee.isNull())
    return message_reached_at(pointee, depth + 1);
  std::optional<MessageType> message = message_of(type);
  if (!message) message = twin_message_of(type);
  if (message) return message->has_data_part ? message : std::nullopt;
  const auto* templated = specialization_of(type);
  if (!templated || !is_known_wrapper(templated) || templated->getName() == "function") return {};
  for (const clang::TemplateArgument& argument : templated->getTemplateArgs().asArray())
    for (const clang::QualType part : types_in(argument))
      if (std::optional<MessageType> message = message_reached_at(part, depth + 1)) return message;
  return {};
}

}  // namespace

std::optional<MessageType> message_reached(clang::QualType type) {
  return message_reached_at(type.getNonReferenceType().getCanonicalType(), 0);
}

namespace {

bool is_or_points_to(clang::QualType type, const char* name) {
  const clang::QualType pointee = pointee_of(type);
  const clang::CXXRecordDecl* record = record_of(pointee.isNull() ? type : pointee);
  return record && qualified_name_of(record) == name;
}

}  // namespace

clang::QualType first_argument(const clang::ClassTemplateSpecializationDecl* decl) {
  if (!decl || decl->getTemplateArgs().size() == 0) return {};
  const clang::TemplateArgument& argument = decl->getTemplateArgs()[0];
  return argument.getKind() == clang::TemplateArgument::Type ? argument.getAsType() : clang::QualType();
}

clang::QualType first_argument(clang::QualType type) {
  return first_argument(specialization_of(type));
}

bool is_pcl_cloud(clang::QualType type) {
  return is_or_points_to(type, "pcl::PointCloud") || is_or_points_to(type, "pcl::PCLPointCloud2");
}

bool is_cv_image(clang::QualType type) {
  return is_or_points_to(type, "cv_bridge::CvImage");
}

std::string stock_name(const std::string& message) {
  const std::size_t slash = message.find('/');
  return message.substr(0, slash) + "::" + message.substr(slash + 1);
}

std::string twin_name(const std::string& message) {
  return "tzc::" + stock_name(message);
}

std::string twin_header(const std::string& message) {
  return "tzc/" + message + ".h";
}

}  // namespace tzc::rewriter
