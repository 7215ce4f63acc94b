// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/syntax/function_view.h"
#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Notes in a function which messages that outlive it are given away by value, and from where it publishes. Stock messages
/// and their twins alike, so that a port is seen as its original is.
void note_given_messages(const Unit& unit, const FunctionView& view, EscapeFacts& facts);

}  // namespace tzc::rewriter
