// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "verify/unnamed_types.h"

namespace clang {
class DeclContext;
class NamedDecl;
class TemplateArgumentList;
}  // namespace clang

namespace tzc::rewriter {

/// The instantiation of a template that code is part of.
struct Instance {
  std::string
      pattern;  ///< what is instantiated: names and numbers of parameters, from the outermost; empty: no template
  std::string
      arguments;  ///< of all templates around the code, canonical, and which unnamed types are around it
};

/// Names what code is part of so that the name is the same in a unit whose lines have moved: nothing in it tells a place in a file
/// that edits may change. Clang prints no places while this lives (`(lambda)`); what they would tell apart, unnamed types,
/// is named by numbers that edits keep (`UnnamedTypes`), and by the arguments of the templates around it.
class Instances {
 public:
  explicit Instances(const Source& source);
  ~Instances();
  Instances(const Instances&) = delete;
  Instances& operator=(const Instances&) = delete;

  const Instance& of(const clang::DeclContext* context);
  /// With the namespaces, classes and functions around it, inline and anonymous namespaces left out.
  std::string qualified_name_of(const clang::NamedDecl* decl) const;

 private:
  Instance found(const clang::DeclContext* context);
  std::string name_of(const clang::NamedDecl* decl) const;
  std::string text_of(const clang::TemplateArgumentList& arguments);
  std::string name_of_unnamed(const clang::TagDecl* type);

  const Source& source_;
  const bool printed_places_;
  UnnamedTypes unnamed_;
  std::map<const clang::DeclContext*, Instance> known_;
};

}  // namespace tzc::rewriter
