// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The message that a statement fills as a whole: image = other, sensor_msgs::fillImage(image, ...), cv_image.toImageMsg(image).
/// Null: none.
const clang::Expr* filled_message(const Unit& unit, const clang::Stmt* stmt);

/// Whether the class is PointCloud2Iterator or PointCloud2ConstIterator.
bool is_cloud_iterator(const clang::CXXRecordDecl* record);
/// fields.emplace_back(cloud, "x"), field.emplace(cloud, "x"), by_name.try_emplace("x", cloud, "x"): the cloud whose data the iterator in the
/// container may write. Null: nothing like it.
const clang::Expr* cloud_of_emplaced_iterator(const clang::Stmt* stmt);

}  // namespace tzc::rewriter
