// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::msggen {

/// "::sensor_msgs::Image": roscpp's type of a message.
std::string stock_type(const Message& message);

/// "::tzc::sensor_msgs::Image" for a message with a data part, else its stock type.
std::string twin_type(const Message& message, Analysis& analysis);

/// The type of one element of a field in the twin.
std::string twin_element(const Field& field, Analysis& analysis);

/// The type of the whole field in the twin.
std::string field_type(const Field& field, Analysis& analysis);

/// The macro that guards a message's header; it keeps letter case, so that Foo and FOO may be in one package.
std::string include_guard(const std::string& package, const std::string& name);

}  // namespace tzc::msggen
