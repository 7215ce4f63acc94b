// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/Lex/Preprocessor.h>

#include "parse/preprocessor_notes.h"

namespace tzc::rewriter {

/// Notes what happens outside of system headers, until the main file ends.
void note_preprocessing(clang::Preprocessor& preprocessor, PreprocessorNotes& notes);

}  // namespace tzc::rewriter
