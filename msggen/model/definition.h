// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The generator's data flow:
//
//   file ──parse──> Message (fields, constants, text) ──resolve──> Library (every nested type found, no
//   cycles)
//        ──> facts: md5sum, full text, fixed length?, data fields, sizes ──emit──> header
//
#include <cstdint>
#include <string>
#include <vector>

#include "model/builtin.h"
#include "model/diagnostic.h"

namespace tzc::msggen {

struct Message;

enum class ArrayKind { none, fixed, variable };

struct Field {
  std::string
      type;  ///< as genmsg spells it after resolution: "uint8[]", "std_msgs/Header", "geometry_msgs/Point[3]"
  std::string base;  ///< the element's type: a builtin, or "package/Name"
  std::string name;
  ArrayKind array = ArrayKind::none;
  std::uint64_t length = 0;          ///< of a fixed array
  const Builtin* builtin = nullptr;  ///< exactly one of builtin and message is set once the field is resolved
  const Message* message = nullptr;  ///< owned by the Library
  Position at;                       ///< of the type
  std::size_t type_width = 0;        ///< characters that the type takes in the file
  std::string source_line;
};

struct Constant {
  std::string type;
  std::string name;
  std::string text;   ///< the value as written; the md5sum is made from it
  std::string value;  ///< integers in plain decimal, bool as 0 or 1, floats as shortest C++ literal, strings
                      ///< as they are
};

/// One message definition. The halves of a service and the seven messages of an action are messages too.
struct Message {
  std::string package;
  std::string name;
  std::string file;  ///< where it was read from
  std::string text;  ///< as it enters the full text
  std::vector<Field> fields;
  std::vector<Constant> constants;

  std::string full_name() const { return package + "/" + name; }
};

}  // namespace tzc::msggen
