// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/definition.h"

namespace tzc::msggen {

/// Size and alignment of a fixed-length type in memory, as every ABI that ROS runs on lays it out.
struct Layout {
  std::uint64_t size = 0;
  std::uint64_t alignment = 1;
};

/// Facts that follow from a message's definition and those of all messages inside it.
struct Facts {
  std::string md5;
  bool fixed_length = false;
  bool has_variable_array = false;  ///< at any depth
  bool comparable = false;          ///< roscpp's operator== compiles for it (it has none for empty messages)
  std::vector<std::string> data_fields;  ///< "points", "channels[].values": the data part, in wire order
  std::uint64_t wire_size = 0;           ///< bytes on the wire; of a type that is not fixed-length: at least
  Layout memory;                         ///< of a fixed-length type
  std::vector<const Message*> nested;    ///< every type inside, in the order of genmsg's full text

  /// A variable-length array of a fixed-length type, at any depth.
  bool has_data_part() const { return !data_fields.empty(); }
};

/// A field's role in partial serialization.
enum class Part {
  control,  ///< serialized into the control part
  data,     ///< an array that lives in shared memory
  mixed     ///< a message, or messages, with a data part inside
};

/// Computes facts of resolved messages, each once. Messages must outlive it and be free of cycles.
class Analysis {
 public:
  const Facts& facts(const Message& message);
  bool fixed_length(const Field& field);  ///< of one element, whether or not the field is an array
  Part part(const Field& field);
  std::uint64_t element_wire_size(const Field& field);
  Layout element_layout(const Field& field);
  std::string md5_text(const Message& message);
  std::string full_text(const Message& message);

 private:
  Facts compute(const Message& message);
  void add_field(const Field& field, Facts& facts);
  void add_data_fields(const Field& field, Facts& facts);

  std::unordered_map<const Message*, Facts> known_;
};

/// A service's md5sum covers its request and its response.
std::string service_md5(Analysis& analysis, const Message& request, const Message& response);

/// a * b and a + b that stick at the largest value instead of wrapping.
std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b);
std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b);

}  // namespace tzc::msggen
