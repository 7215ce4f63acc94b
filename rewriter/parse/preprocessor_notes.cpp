// SPDX-License-Identifier: BSD-3-Clause
#include "parse/preprocessor_notes.h"

#include <iterator>

namespace tzc::rewriter {
namespace {

void append(std::vector<Place>& into, std::vector<Place>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(into));
}

}  // namespace

void PreprocessorNotes::merge(PreprocessorNotes&& other) {
  append(skipped, other.skipped);
  append(dropped, other.dropped);
  append(texts, other.texts);
  compiled.merge(other.compiled);
  kept.merge(other.kept);
}

}  // namespace tzc::rewriter
