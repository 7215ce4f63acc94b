// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/unit.h"

namespace tzc::rewriter {

/// The message that a statement fills as a whole: image = other, sensor_msgs::fillImage(image, ...), cv_image.toImageMsg(image).
/// Null: none.
const clang::Expr* filled_message(const Unit& unit, const clang::Stmt* stmt);

/// PointCloud2Iterator, PointCloud2ConstIterator.
bool is_cloud_iterator(const clang::CXXRecordDecl* record);

}  // namespace tzc::rewriter
