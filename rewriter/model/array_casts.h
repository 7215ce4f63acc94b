// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What units tell about casts of arrays, std::vectors of a fixed-length type, whose message is not known where they stand.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/location.h"
#include "model/obstacle.h"

namespace tzc::rewriter {

/// Where an array comes from: one of these, or a parameter of a function of the package, "USR#0".
constexpr char own_array[] = "own";  ///< an object of its own, no part of a message
constexpr char followed_array[] =
    "message";  ///< a message's, which the search for escapes follows to each cast of it
constexpr char unknown_array[] = "";

/// An array becomes writable that was const, or of no type, before.
struct ArrayCast {
  std::set<std::string> elements;  ///< of the types before and after: "unsigned char"
  std::string from;
  bool untyped = false;  ///< before, it was no array at all: void*, bytes, a number
  Obstacle obstacle;
};

struct ArrayCastFacts {
  std::vector<ArrayCast> array_casts;
  std::map<std::string, std::set<std::string>>
      given_arrays;                      ///< by parameter: where what it is given comes from
  std::vector<Location> untyped_arrays;  ///< where an array that may be a message's loses its type
};

}  // namespace tzc::rewriter
