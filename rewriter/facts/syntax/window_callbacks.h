// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenCV's windows call what they were given for the mouse and for trackbars while the program waits for a key: code of
// the package that runs in cv::waitKey, on the thread that calls it.

#include <clang/AST/Expr.h>

#include <string>
#include <vector>

namespace tzc::rewriter {

/// Stands for all of these callbacks, as a function's USR does.
constexpr const char* window_callbacks = "cv::waitKey";

/// A call of cv::waitKey or its like. It takes no lock but what the callbacks take.
bool runs_window_callbacks(const clang::Stmt* stmt);

/// The functions that a call gives to windows, by USR; "" for one that is not seen here.
std::vector<std::string> callbacks_given_to_windows(const clang::CallExpr* call);

}  // namespace tzc::rewriter
