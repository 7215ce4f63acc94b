// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is known about a package after parsing it: plain values, keyed by USR or by place, so that the facts
// of many translation units merge by key and a header that is seen twice counts once.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "facts/callees.h"
#include "report/completeness.h"
#include "report/model.h"

namespace tzc::rewriter {

/// Names an entity in all translation units.
using Key = std::string;

/// A byte range of a file, with the line and column of its begin (from 1).
struct Place {
  std::string file;  ///< absolute, canonical
  unsigned begin = 0;
  unsigned end = 0;
  unsigned line = 0;
  unsigned column = 0;
};

inline Location location_of(const Place& place) {
  return {place.file, place.line, place.column};
}

/// An edit that is made when what it belongs to is ported. `$PUB` in the text stands for the publisher.
struct Change {
  Place where;
  std::string text;
  std::string rule;
  std::vector<std::string> headers;  ///< that the text needs: "tzc/ros.h"
};

/// Why something has to stay as it is.
struct Obstacle {
  std::string code;
  std::string reason;
  Location where;
};

enum class Carrier { message, publisher, filter };
enum class Home { local, member, global, parameter, result, temporary };

/// A variable, member, parameter, function result or temporary that carries a message, a publisher or a
/// filter.
struct Entity {
  Key key;
  Carrier carrier = Carrier::message;
  Home home = Home::local;
  std::string type;           ///< "sensor_msgs/Image", empty for publishers
  std::string name;           ///< as written
  std::string record;         ///< USR of the class of a member
  std::string ported_class;   ///< of a publisher: "tzc::Publisher"
  std::string ported_header;  ///< "tzc/ros.h"
  bool plain = false;         ///< the publisher itself, not a pointer to it or a container of it
  bool ported = false;        ///< a publisher or filter that has TZC's class already
  Location where;
  std::vector<Change> changes;  ///< its declared types
  std::vector<Obstacle> obstacles;
};

/// Two entities that must have the same type: initialised, assigned, passed, returned.
struct Flow {
  Key from, to;
  Location where;
  std::string what;
};

/// A use of an entity that takes an edit when the entity is ported.
struct Use {
  Key entity;
  Change change;
};

/// A publisher that can be named at some place.
struct PublisherName {
  Key publisher;
  std::string text;  ///< "pub_", "pubs_[LEFT]"
  bool pointer = false;
  bool guarded = false;       ///< the pointer may be null here
  std::vector<Key> messages;  ///< that it is named together with
};

/// Where a message comes into being, and where `allocate` can be said for it.
struct Birth {
  Key entity;
  std::optional<Place> at;      ///< insertion point; none: nowhere
  std::string object;           ///< "image", "*image"
  std::string indent;           ///< of the inserted line
  bool own_line = true;         ///< the inserted statement gets a line of its own
  bool before = false;          ///< the insertion stands before the statement at `at`, not behind it
  bool filled = false;          ///< it already has content there, which allocate would copy
  bool adapter = false;         ///< the message is built by a library call that is replaced (uses $PUB)
  std::vector<Change> changes;  ///< of an adapter
  std::vector<PublisherName> publishers;  ///< that publish it in this function and can be named here
  std::string calls;                      ///< USR of the helper that this call has it built by
  std::string record;                     ///< USR of the class whose `this` can be used here
  std::string function;                   ///< USR
  Location where;
};

/// A function that builds a message for its callers and could be given the publisher as first parameter.
struct Helper {
  std::vector<Place> declarations;  ///< behind the parenthesis of each
  bool has_parameters = false;
  std::string parameter;  ///< the publisher's name in it
};

struct Advertise {
  Place where;
  std::string function;  ///< qualified name, for the site's id
  std::string type;
  std::optional<std::string> topic;
  std::optional<std::string> queue;  ///< as written
  Key publisher;                     ///< empty: not kept anywhere that is understood
  std::vector<Change> changes;       ///< `$MEM` stands for the memory size
  bool heavy = true;
  bool no_twin = false;
  std::optional<std::string> memory;  ///< as written; set where the call is ported already
  bool pcl = false;                   ///< advertised as a pcl::PointCloud
  std::string rule;
  std::vector<Obstacle> obstacles;
};

struct Publish {
  Place where;
  Place statement_end;
  Place statement;  ///< empty file: the call is part of a larger expression
  std::string function;
  std::string type;
  Key publisher;
  std::string publisher_text;
  std::string object;         ///< "image", "*image": for allocate in front of the call; empty: a temporary
  std::vector<Key> messages;  ///< what the first argument denotes
  bool in_void_function = false;
  bool in_block = false;  ///< the statement stands in a block of its own
  bool heavy = true;
  bool pcl = false;  ///< a pcl::PointCloud or a cv_bridge::CvImage is published as such
  bool nested_only = false;
  bool twin = false;  ///< a tzc:: message is published
  std::vector<Obstacle> obstacles;
};

struct Subscribe {
  Place where;
  std::string function;
  std::string type;
  std::optional<std::string> topic;
  bool heavy = true;
  bool ported = false;         ///< it subscribes through TZC already
  bool writes = false;         ///< a callback may write to the message
  std::vector<Key> callbacks;  ///< the parameters that receive the message
  Key filter;                  ///< the filter object that must be ported with it
  std::string scope;           ///< USR of the class around it
  std::vector<Change> changes;
  std::string rule;
  std::vector<Obstacle> obstacles;
};

/// A use of a data array of an entity.
struct DataUse {
  Key entity;
  Location where;
  bool grows = false;  ///< fills an array or changes its size
};

struct Facts {
  std::map<Key, Entity> entities;
  std::vector<Flow> flows;
  std::vector<Use> uses;
  std::vector<Birth> births;
  std::map<std::string, Helper> helpers;        ///< by USR
  std::map<std::string, Advertise> advertises;  ///< by place and type
  std::map<std::string, Publish> publishes;
  std::map<std::string, Subscribe> subscribes;
  std::vector<DataUse> data_uses;
  std::set<ApiCall> api_calls;                                 ///< what the report is held against
  std::map<std::string, std::set<std::string>> bases;          ///< record USR -> USRs of its base classes
  std::map<std::string, std::set<std::string>> units_of_file;  ///< package file -> main files that include it
  std::map<std::string, std::vector<PackageCall>> calls;       ///< unit id -> what overload resolution picked
  std::vector<Note> notes;
  std::vector<Place> skipped;  ///< preprocessor branches that a unit does not compile
  std::set<std::string>
      writing_filter_scopes;  ///< functions or classes that register a callback that may write

  /// Adds what another unit saw; the same entity or site counts once.
  void merge(Facts&& other);
};

}  // namespace tzc::rewriter
