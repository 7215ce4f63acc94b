// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  image_transport::Publisher pub;
/// After:   tzc::image_transport::Publisher pub;
const ClassRename image_publisher{"image-publisher", ClassRename::Role::publisher,
                                  "image_transport::Publisher", "tzc::image_transport::Publisher",
                                  "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
