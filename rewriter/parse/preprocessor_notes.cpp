// SPDX-License-Identifier: BSD-3-Clause
#include "parse/preprocessor_notes.h"

#include "model/append.h"

namespace tzc::rewriter {

void PreprocessorNotes::merge(PreprocessorNotes&& other) {
  append(skipped, other.skipped);
  append(dropped, other.dropped);
  append(texts, other.texts);
  compiled.merge(other.compiled);
  kept.merge(other.kept);
}

}  // namespace tzc::rewriter
