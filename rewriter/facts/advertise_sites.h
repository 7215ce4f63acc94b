// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the collectors of advertise sites share.

#include <optional>
#include <string>

#include "facts/unit.h"

namespace tzc::rewriter {

/// A site at the call, an image as long as nothing else is said.
Advertise advertise_at(Unit& unit, const clang::CallExpr* call, const char* rule);
/// What is advertised: advertise<type>(...).
void describe_type(const Unit& unit, clang::QualType type, Advertise& site);
void add_advertise(Unit& unit, Advertise site);
std::optional<std::string> written_text(Unit& unit, const clang::CallExpr* call, unsigned index);
/// advertise<T>(...) in a template: T stays written, and stands for the stock message.
bool is_template_parameter(const clang::TemplateArgument& argument);

/// The rule for a call of a library's function that advertises for the package; null: it is none.
const LibraryAdvertise* library_advertise_rule(Unit& unit, const clang::CallExpr* call);
/// The call that an earlier run has put around it; null: none.
const clang::CallExpr* attaching_call(Unit& unit, const clang::CallExpr* call, const LibraryAdvertise& rule);
/// tzc::attach_publisher<M>(...), as `rule` writes it.
bool attaches_publisher(const Unit& unit, const clang::CallExpr* call);
void collect_library_advertise(Unit& unit, const clang::CallExpr* call);

}  // namespace tzc::rewriter
