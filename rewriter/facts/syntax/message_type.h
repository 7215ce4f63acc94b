// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/facts.h"
#include "rules/rule.h"

namespace tzc::rewriter {

/// A generated ROS message struct.
struct MessageType {
  const clang::CXXRecordDecl* record = nullptr;
  std::string name;                     ///< "sensor_msgs/Image"
  bool has_data_part = false;           ///< has a data part: an array of a fixed-length type, at any depth
  bool has_direct_data_part = false;    ///< has a data part outside arrays of messages
  bool has_varied_elements = false;     ///< an array whose elements have strings or arrays of their own
  std::set<std::string> elements = {};  ///< of its data parts, by element_name
  bool service = false;                 ///< request or response of a service
  std::optional<std::uint64_t> most_bytes = 0;  ///< that its arrays hold, by the types they are part of
};

/// What a C++ type carries, however deep in pointers and containers.
struct Carried {
  EntityRole role;
  std::optional<MessageType> message;
  const ClassRename* rename = nullptr;
  bool ported = false;  ///< it is the class that `rename` writes
};

EntityRole role_of(const ClassRename& rename);

/// The message struct that a record is, by the shape that gencpp gives it.
std::optional<MessageType> message_of(const clang::CXXRecordDecl* record);

/// The message type itself, without pointers and references around it.
std::optional<MessageType> message_of(clang::QualType type);

/// The stock message that a tzc:: message stands for.
std::optional<MessageType> twin_message_of(clang::QualType type);

/// Writes the type of a site's message.
void set_message(SiteFact& site, const MessageType& message);

/// std::vector of a fixed-length type: a data array.
bool is_data_array(clang::QualType type);

/// The name of an array's element type, equal for all spellings and instances of it: "unsigned char", "geometry_msgs::Point32_".
std::string element_name(clang::QualType element);

/// Message, publisher or filter, directly or in pointers, references, containers and iterators.
std::optional<Carried> carried_by(clang::QualType type, const RuleSet& rules);

/// A message, or arrays and containers of messages by value.
bool holds_messages(clang::QualType type);
/// Likewise pointers to messages, and containers of such.
bool leads_to_messages(clang::QualType type);

/// The stock message that a type leads to, or whose twin it does: through pointers, containers and iterators. One without a
/// data part is nothing but data, as a number is: a Point, a ColorRGBA.
std::optional<MessageType> message_reached(clang::QualType type);

/// The type that a class is first a template of; null: there is none.
clang::QualType first_argument(const clang::ClassTemplateSpecializationDecl* decl);
clang::QualType first_argument(clang::QualType type);

/// pcl::PointCloud<T> or pcl::PCLPointCloud2, directly or by pointer: what roscpp sends as a sensor_msgs/PointCloud2.
bool is_pcl_cloud(clang::QualType type);

/// cv_bridge::CvImage, directly or by pointer.
bool is_cv_image(clang::QualType type);

/// The pointee of a raw, boost:: or std:: pointer; null for other types.
clang::QualType pointee_of(clang::QualType type);

/// "sensor_msgs/Image" -> "tzc::sensor_msgs::Image".
std::string twin_name(const std::string& message);
/// "sensor_msgs/Image" -> "sensor_msgs::Image".
std::string stock_name(const std::string& message);
/// "sensor_msgs/Image" -> "tzc/sensor_msgs/Image.h".
std::string twin_header(const std::string& message);

}  // namespace tzc::rewriter
