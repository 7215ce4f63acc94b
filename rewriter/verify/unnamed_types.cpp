// SPDX-License-Identifier: BSD-3-Clause
#include "verify/unnamed_types.h"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <set>

#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// Walks what a canonical type is spelled with.
class Spelling {
 public:
  std::vector<const clang::TagDecl*> unnamed;

  void read(const clang::TemplateArgument& argument) {
    if (argument.getKind() == clang::TemplateArgument::Type) read(argument.getAsType());
    if (argument.getKind() == clang::TemplateArgument::Integral) read(argument.getIntegralType());
    if (argument.getKind() == clang::TemplateArgument::Pack)
      for (const clang::TemplateArgument& element : argument.pack_elements()) read(element);
  }

 private:
  void read(clang::QualType written) {
    if (written.isNull()) return;
    const clang::Type* type = written.getCanonicalType().getTypePtr();
    if (const auto* tag = type->getAs<clang::TagType>()) return read(tag->getDecl());
    if (const auto* member = type->getAs<clang::MemberPointerType>())
      read(clang::QualType(member->getClass(), 0));
    if (const clang::ArrayType* array = type->getAsArrayTypeUnsafe()) return read(array->getElementType());
    if (const auto* function = type->getAs<clang::FunctionProtoType>()) {
      read(function->getReturnType());
      for (const clang::QualType parameter : function->param_types()) read(parameter);
    }
    read(type->getPointeeType());
  }
  void read(const clang::TagDecl* tag) {
    if (is_unnamed(tag)) return unnamed.push_back(tag);
    if (const auto* around = llvm::dyn_cast<clang::TagDecl>(tag->getDeclContext())) read(around);
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(tag))
      for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray()) read(argument);
  }
};

UnnamedTypes::Where where_of(const Source& source, const clang::TagDecl* type) {
  const clang::SourceLocation location = type->getLocation();
  return {source.where(location).begin, source.offsets_in_macros(location)};
}

/// Instances of templates stand where their pattern does.
class Collector : public AstVisitor {
 public:
  explicit Collector(const Source& source) : source_(source) {}
  std::map<std::string, std::set<UnnamedTypes::Where>> found;

  bool VisitNamedDecl(clang::NamedDecl* decl) override {
    const auto* type = llvm::dyn_cast<clang::TagDecl>(decl);
    return !type || !is_unnamed(type) || note(type);
  }
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override { return note(lambda->getLambdaClass()); }

 private:
  bool note(const clang::TagDecl* type) {
    if (source_.in_package(type->getLocation()))
      found[source_.where(type->getLocation()).file].insert(where_of(source_, type));
    return true;
  }
  const Source& source_;
};

}  // namespace

bool is_unnamed(const clang::TagDecl* type) {
  return type->getParentFunctionOrMethod() || (!type->getIdentifier() && !type->getTypedefNameForAnonDecl());
}

std::vector<const clang::TagDecl*> unnamed_types_in(llvm::ArrayRef<clang::TemplateArgument> arguments) {
  Spelling spelling;
  for (const clang::TemplateArgument& argument : arguments) spelling.read(argument);
  return std::move(spelling.unnamed);
}

std::string UnnamedTypes::number_of(const clang::TagDecl* type) {
  if (!are_collected_) {
    Collector collector(source_);
    for (clang::Decl* decl : source_.ast().getTranslationUnitDecl()->decls())
      if (source_.in_package(decl->getLocation())) collector.TraverseDecl(decl);
    for (auto& [file, places] : collector.found) by_file_[file].assign(places.begin(), places.end());
    are_collected_ = true;
  }
  const std::string& file = source_.file_of(type->getLocation());
  const std::vector<Where>& places = by_file_[file];
  const Where where = where_of(source_, type);
  const auto at = std::lower_bound(places.begin(), places.end(), where);
  return at != places.end() && *at == where ? file + "#" + std::to_string(at - places.begin())
                                            : file + "@" + std::to_string(where.first);
}

}  // namespace tzc::rewriter
