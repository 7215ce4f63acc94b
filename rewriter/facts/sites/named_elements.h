// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

#include <optional>
#include <string>
#include <vector>

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

/// What a message is called behind the declaration of a variable that starts with a pointer to it: *image, or *images[0] for
/// ImagePtr images[2] = {make_shared<Image>(), ...}, also for a std::array, std::vector or std::deque that starts with such a list. Empty:
/// it has no name, as in a map, or in a vector that is told how many pointers to put there.
std::string name_of_made(const clang::VarDecl* variable, const clang::Expr* made);

/// Image images[2]; the elements by name, where they are messages that start empty, and so few that each can have a statement. None: the
/// variable is something else.
std::vector<std::string> few_messages_in(const clang::VarDecl* variable);

/// The message that a variable is, or each of those few elements. None: it is something else.
std::optional<MessageType> message_declared_by(const clang::VarDecl* variable);

}  // namespace tzc::rewriter
