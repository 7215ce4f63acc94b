// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "facts/collect_unit.h"
#include "model/api_call.h"
#include "model/facts.h"
#include "parse/compile_commands.h"
#include "parse/parse.h"
#include "verify/callees.h"

namespace tzc::rewriter {

/// The result of parsing one unit, or every unit of a package.
struct UnitReading {
  Facts facts;
  std::set<ApiCall> api_calls;     ///< what the report is compared with
  CallsOfUnits calls;              ///< unit id -> the functions that overload resolution picked
  PreprocessorNotes preprocessor;  ///< of the packages' own files
  std::vector<Diagnostic> errors;  ///< the unit does not parse; all else is empty
  bool crashed = false;            ///< reading it did, which is the only error

  void merge(UnitReading&& other);
};

/// Parses one unit. Thread-safe. `accesses` may be null.
UnitReading read_unit(const CompileUnit& unit, const CollectOptions& options,
                      FileAccesses* accesses = nullptr);

}  // namespace tzc::rewriter
