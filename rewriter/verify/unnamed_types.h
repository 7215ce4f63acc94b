// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <llvm/ADT/ArrayRef.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parse/source.h"

namespace clang {
class TagDecl;
class TemplateArgument;
}  // namespace clang

namespace tzc::rewriter {

/// Whether a type has no name that others could spell: a closure's, an unnamed one, a local class or enumeration.
bool is_unnamed(const clang::TagDecl* type);

/// The unnamed types that template arguments are made of, in the order in which Clang prints them.
std::vector<const clang::TagDecl*> unnamed_types_in(llvm::ArrayRef<clang::TemplateArgument> arguments);

/// Numbers the unnamed types of a unit's packages, file by file, in the order in which they stand there. Edits insert, replace
/// and take away text, but leave the order of what stays, and write no unnamed type. So a type of a ported file has the number that
/// it had before, wherever its lines have moved.
class UnnamedTypes {
 public:
  explicit UnnamedTypes(const Source& source) : source_(source) {}

  /// The file, and the number there; outside of the packages, where nothing moves: the offset. All instances of a template have
  /// that of its pattern.
  std::string number_of(const clang::TagDecl* type);

  /// Where a type stands: the offset in its file, and, of what a macro makes, those in the macros.
  using Where = std::pair<unsigned, std::vector<unsigned>>;

 private:
  const Source& source_;
  bool are_collected_ = false;
  std::map<std::string, std::vector<Where>> by_file_;  ///< sorted
};

}  // namespace tzc::rewriter
