// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "paper/store.h"

namespace tzc {
namespace bench {

/// Copies what a repository shows of an evaluation into a folder: README.md, tables, plots, run.json. Raw samples stay.
/// Throws StoreError.
void publish(const Store& store, const std::string& folder);

}  // namespace bench
}  // namespace tzc
