// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is known of the classes and functions that share the elements of an image.

#include <clang/AST/ExprCXX.h>

namespace tzc::rewriter {

/// cv::Mat and its like: copies share the elements.
bool is_mat(clang::QualType type);
/// Whether the elements can be reached through a value of this type: images, pointers, iterators, containers of them.
bool leads_to_elements(clang::QualType type);
/// cv_bridge::toCvShare(message): an image over the message's own elements.
bool shares_message(const clang::Stmt* stmt);
/// Converts a smart pointer to another one of the same object, or keeps what it is given.
bool hands_on(const clang::FunctionDecl* function);
/// A class of OpenCV that stands for an output.
bool is_output(const clang::CXXRecordDecl* record);
/// Whether a function of a library may write to the elements that its argument leads to.
bool may_write_through(const clang::FunctionDecl* function, unsigned parameter);

}  // namespace tzc::rewriter
