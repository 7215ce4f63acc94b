// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Facts about a parsed package: plain values, named by USR or by place, so that the facts of many translation
// units merge by id and a header that is seen twice counts once.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "model/array_casts.h"
#include "model/content_flow.h"
#include "model/escape_facts.h"
#include "model/ids.h"
#include "model/location.h"
#include "model/obstacle.h"
#include "model/thread_facts.h"

namespace tzc::rewriter {

/// An edit that is made when its entity or site is ported. `$PUB` in the text stands for the publisher.
struct Change {
  Place where;
  std::string text;
  std::string rule;
  std::vector<std::string> headers;  ///< that the text needs: "tzc/ros.h"
};

enum class EntityRole { message, publisher, filter };
enum class Storage { local, static_local, member, global, parameter, result, temporary };

/// Where the message, publisher or filter is: the entity itself, an element of it by value, or what it points or refers to.
enum class Form { itself, contained, elsewhere };

struct MemberOf {
  std::string record;  ///< USR of the class
  bool is_private = false;
  std::string scope;  ///< instead, of a global: the namespaces around it, "a::b"
};

/// TZC's class in place of another package's.
struct PortedClass {
  std::string name;    ///< "tzc::Publisher"
  std::string header;  ///< "tzc/ros.h"
};

/// A variable, member, parameter, function result or temporary that carries a message, a publisher or a
/// filter.
struct Entity {
  EntityId id;
  EntityRole role = EntityRole::message;
  Storage storage = Storage::local;
  std::string type;       ///< "sensor_msgs/Image", empty for publishers
  std::string name;       ///< as written
  MemberOf member_of;     ///< of a member or global
  PortedClass ported_as;  ///< of a publisher or filter
  Form form = Form::elsewhere;
  bool ported = false;  ///< a publisher or filter that has TZC's class already
  Location where;
  std::vector<Change> changes;  ///< its declared types
  std::vector<Obstacle> obstacles;

  /// No function makes it, or it outlives the function that does.
  bool lasts() const {
    return storage == Storage::static_local || storage == Storage::member || storage == Storage::global;
  }
};

/// Two entities that must have the same type: initialised, assigned, passed, returned.
struct Flow {
  EntityId from, to;
  Location where;
  std::string what;
  /// A message is copied as a whole, and the copy may have another type than what it is made of: a ported one takes a stock one.
  bool copies = false;
  /// Makes a stock message of what is copied, where the copy stays one for certain; none: that cannot be written.
  std::vector<Change> as_stock;
};

/// `Image a, b;`: where the declaration is cut when only one of two neighbours is ported.
struct Cut {
  EntityId left;
  Place words;         ///< the type that both share, where it is written
  Place at;            ///< from the comma to the second declarator
  std::string stock;   ///< what is written there, with the type as it was
  std::string ported;  ///< the same with the ported type
};

/// Of the edit that leaves out a zero-fill, and of none: an instance of the template, or a unit, needs the fill there.
constexpr const char* uninitialized_rule = "uninitialized";
constexpr const char* zero_fill_rule = "zero-fill";

/// A use of an entity that takes an edit when the entity is ported.
struct Use {
  EntityId entity;
  Change change;
};

/// A publisher whose name can be evaluated at an allocation site.
struct PublisherName {
  EntityId publisher;
  std::string text;  ///< "pub_", "pubs_[LEFT]"
  bool pointer = false;
  bool guarded = false;            ///< the pointer may be null here
  std::vector<EntityId> messages;  ///< with which it is named
  std::set<std::string>
      callees;  ///< functions, none of which may take a lock, by USR; "": one that is not seen
};

/// A message that is made as a copy of another one can be made empty instead, and be assigned the other one.
struct LaterCopy {
  std::vector<Change> without;  ///< make it empty
  std::string source;           ///< what it is assigned: "*in"
  bool runs_code = false;       ///< of the package, perhaps, which may make or change publishers only then
};

/// A statement that calls `allocate` is inserted.
struct InsertedAllocation {
  std::optional<Place> at;  ///< insertion point; none: there is none
  std::string object;       ///< "image", "*image"
  std::string indent;       ///< of the inserted line
  bool own_line = true;     ///< the inserted statement gets a line of its own
  std::optional<Place>
      opening;          ///< where a brace opens, for a statement that stands alone in place of a block
  bool filled = false;  ///< the message already has content there, which allocate would copy
  std::optional<LaterCopy> copy;  ///< instead it can get its content behind allocate
  bool is_needed = true;          ///< no: its arrays are in elements that come later, or it is only copied

  /// Whether it has content where allocate could be called, or would be, if it could.
  bool has_content() const { return filled && !(at && copy); }
};

/// A library call that makes the message is replaced by an adapter that is given the publisher.
struct AdapterAllocation {
  std::vector<Change> changes;  ///< use $PUB; none: the call cannot be replaced
};

/// A factory makes the message and can be given the publisher.
struct FactoryAllocation {
  EntityId factory;             ///< its result
  std::vector<Change> changes;  ///< use $PUB; none: the call cannot be changed
};

/// A member, global or static pointer that starts with the message, where no statement can stand. It lasts, and with it the message,
/// so that nothing has to be allocated: its first publish binds it.
struct LastingStart {
  std::string usr;
  bool is_member = false;  ///< of objects, each of which starts with a message of its own
};

/// Where a message comes into being, and how `allocate` is called for it.
struct AllocationSite {
  EntityId entity;
  std::variant<InsertedAllocation, AdapterAllocation, FactoryAllocation> how;
  std::vector<PublisherName> publishers;  ///< that publish it in this function and are available here
  std::set<EntityId> unnameable;          ///< those that this function names in a way that is not valid here
  bool is_early = false;  ///< it stands before the body of its function, and members may not be there yet
  std::string record;     ///< USR of the class whose `this` is available here
  std::string scope;      ///< the namespaces around it
  EntityId function;      ///< result of the function around it
  std::string refusal;    ///< why there is no place for allocate, where it is something special
  std::optional<LastingStart> start;
  std::vector<EntityId>
      copied_from;  ///< what it starts as a copy of; none: it does not, or that is not known
  Location where;
};

/// A function that makes a message for its callers and can be given the publisher as its first parameter.
struct Factory {
  std::vector<Place> declarations;  ///< behind the parenthesis of each
  bool has_parameters = false;
  std::string parameter;  ///< the publisher's name in it
};

/// Common base of the calls that advertise, publish and subscribe.
struct SiteFact {
  Place where;
  std::vector<unsigned>
      in_macros;              ///< byte offsets of the call in the macros that make it, from the innermost
  std::string function;       ///< qualified name of the function around it
  std::string type;           ///< "sensor_msgs/Image"
  bool has_data_part = true;  ///< or is gathered
  bool is_gathered = false;   ///< a large message of which shared memory can hold no array in place
  bool has_varied_elements = false;         ///< an array whose elements have strings or arrays of their own
  std::set<std::string> elements;           ///< types of its arrays' elements: "unsigned char"
  std::optional<std::uint64_t> most_bytes;  ///< that its arrays hold, by its type; none: any number
  std::vector<Obstacle> obstacles;

  SiteId id() const { return {where.file, where.begin, type, in_macros}; }
};

/// How a call attaches shared memory to its topic.
struct Attaching {
  bool is_done = false;         ///< by an earlier run
  std::vector<Change> changes;  ///< that make it so; empty: it cannot be, or is
  std::string why_not;          ///< empty: it can be, or is, or no class of TZC's does that
};

/// The type that an advertise call names.
struct AdvertisedType {
  std::string stock;     ///< as it is written
  std::string twin;      ///< the same where the call must keep it
  bool no_twin = false;  ///< there is none
};

struct Advertise : SiteFact {
  /// function_for_callers: exported, returns the publisher, and stays as it is.
  enum class Around { function, template_instance, function_for_callers };
  std::optional<std::string> topic;
  std::optional<std::string> queue;  ///< its number where it is known, else as written
  EntityId publisher;                ///< empty: kept in no entity
  std::vector<Change> changes;  ///< `$TYPE` stands for one of the types, `$MEM` for the memory size argument
  AdvertisedType written;
  bool needs_memory = false;          ///< the argument that follows could be taken for a memory size
  std::optional<std::string> memory;  ///< as written; set where the call is ported already
  bool pcl = false;                   ///< advertised as a cloud of PCL
  Attaching attaching;                ///< while the publisher keeps its class
  Around around = Around::function;
  std::string library_class;  ///< of a library, which advertises for the package; empty: none does
  std::string rule;
};

/// A local variable or a parameter.
struct LocalObject {
  std::string name;
  bool is_given = false;  ///< it is made elsewhere
};

/// A statement that is nothing but a call.
struct CallStatement {
  Place begin;  ///< empty file: the call is part of a larger expression
  Place end;
  bool in_block = false;  ///< it stands in a block of its own
  bool in_void_function = false;
};

struct Publish : SiteFact {
  CallStatement statement;
  EntityId publisher;
  std::string publisher_text;
  std::string object;  ///< "image", "*image": for allocate in front of the call; empty: a temporary
  std::vector<EntityId> messages;  ///< what the first argument denotes
  bool pcl = false;                ///< a cloud of PCL or a cv_bridge::CvImage is published as such
  bool by_serializer = false;      ///< the latter, of which TZC has no form
  bool nested_only = false;
  bool twin = false;                   ///< a tzc:: message is published
  Attaching attaching;                 ///< to the topic of a publisher that keeps its class
  std::optional<LocalObject> part_of;  ///< none: of no object, or of one that lasts
  std::string library_class;           ///< of a library, which publishes for the package; empty: none does
};

/// What Subscribe::asked_transport says of ros::TransportHints().unreliable().
constexpr const char* udpros = "UDPROS";

struct Subscribe : SiteFact {
  std::optional<std::string> topic;
  bool ported = false;          ///< it subscribes through TZC already
  bool writes = false;          ///< a callback takes the message as its own
  bool is_unknown = false;      ///< a callback is not known, and may do with the message what its type allows
  bool converts = false;        ///< the callbacks take a type that is made from the message
  std::string asked_transport;  ///< that shares no memory, in words; empty: it asks for none
  std::vector<EntityId> callbacks;  ///< the parameters that receive the message
  EntityId filter;                  ///< the filter object that must be ported with it
  std::string scope;                ///< USR of the class around it
  std::vector<Change> changes;
  std::vector<Change> changes_if_kept;  ///< of the call, while its filter keeps its class
  std::string rule;

  /// Those that another instance, or unit, gives the same subscription.
  void add_callbacks(const Subscribe& other);
};

/// A use of a data array of an entity.
struct DataUse {
  EntityId entity;
  Location where;
  std::optional<std::uint64_t> most_bytes =
      {};                ///< that the array holds because of this use; none: any number
  bool appends = false;  ///< to what the array has already, once in its life
};

/// Where a callback is registered with what another class may hold.
constexpr char any_class[] = "any";

/// Which message the callbacks of a filter take, and in which class they are registered.
struct FilterCallback {
  std::string scope;  ///< USR of the class, or any_class
  std::string type;   ///< empty: any, of a callback that is not known
  EntityId filter{};  ///< with which it is registered; empty: with something behind filters, or not known

  friend bool operator<(const FilterCallback& a, const FilterCallback& b) {
    return std::tie(a.scope, a.type, a.filter) < std::tie(b.scope, b.type, b.filter);
  }
};

/// What such callbacks do with it.
struct FilterCallbackUse {
  bool writes = false;            ///< one of them takes it as its own
  bool is_unknown = false;        ///< one of them is not known
  std::set<EntityId> parameters;  ///< that receive it
};

/// Const is cast away from a message, or its type is given to something that has none.
struct ConstCast {
  std::string type;                ///< of the message
  std::vector<EntityId> messages;  ///< that it may be; none: it is not known
  Obstacle obstacle;
};

/// The entities, the flows between them, and their uses.
struct EntityFacts {
  std::map<EntityId, Entity> entities;
  std::vector<Flow> flows;
  std::vector<Use> uses;
  std::map<EntityId, Cut> cuts;  ///< in front of a declarator
  std::vector<DataUse> data_uses;
  std::vector<ConstCast> const_casts;
  std::vector<ConstCast> foreign_casts;        ///< something else is taken for a message, any of the type
  std::set<EntityId> objects;                  ///< messages, and new ones: what flows into them is copied
  std::map<EntityId, std::string> parameters;  ///< USR of their function
  /// Of what is private in exported headers: friends of its class, by USR, "" for one that has none.
  std::map<EntityId, std::set<std::string>> friends;
};

/// The classes of the package, by USR.
struct ClassFacts {
  std::set<std::string> records;                           ///< that it defines
  std::map<std::string, std::set<std::string>> bases;      ///< class -> its base classes
  std::map<std::string, std::set<std::string>> overrides;  ///< virtual function -> all that override it

  /// The class and all its bases. Programs of one package may give a name to different classes, so a class may be its own base.
  std::set<std::string> with_bases(const std::string& record) const;
};

/// Which units have the files of the package.
struct UnitFacts {
  std::map<std::string, std::set<std::string>> units_of_file;  ///< package file -> main files that include it
  std::set<std::string>
      programs;  ///< main files of units that define main(), and cannot be part of another program
  std::set<std::string> parts;  ///< main files of the other units

  /// Whether the file defines main() and nothing else is made of it.
  bool is_of_one_program(const std::string& file) const;
  /// Whether code of both files may run in one process: unless each of them is some program's own.
  bool share_a_process(const std::string& file, const std::string& other) const;
};

struct Facts : EntityFacts, EscapeFacts, ThreadFacts, ClassFacts, UnitFacts, ArrayCastFacts {
  std::vector<AllocationSite> allocations;
  std::map<EntityId, Factory> factories;  ///< by their result
  std::map<SiteId, Advertise> advertises;
  std::map<SiteId, Publish> publishes;
  std::map<SiteId, Subscribe> subscribes;
  std::map<std::string, std::set<EntityId>>
      library_publishers;  ///< class of a library -> publishers that its objects are given
  std::map<FilterCallback, FilterCallbackUse> filter_callbacks;
  std::set<std::string> hidden_code;  ///< that is shown, by name
  std::set<std::string> bodies;       ///< USRs of the functions whose bodies were seen
  bool shadows_tzc = false;           ///< the package gives the name tzc to something of its own
  /// Of messages: whether the parameter's type gives the function one to itself, in each instance of a template.
  std::map<EntityId, bool> own_parameters;

  /// What one instance of a template, or unit, says of it.
  void add_parameter(const EntityId& id, bool is_own);
  /// Leaves out what only hidden code would do of which no unit shows any. After all is merged.
  void leave_out_unshown_code();
  /// Says of a virtual function what its overrides do, too: a call of it may run any of them. After all is merged.
  void add_overrides();
  /// What a function does in one unit, or instance of a template; it may do something else in another one.
  void add_content(const std::string& usr, ContentFlow flow);
  /// A function that is defined elsewhere, or not in C++ (a signal of Qt), keeps its parameters.
  void refuse_unseen_functions();
  /// A friend of an exported class that is defined elsewhere may use what is private in it.
  void refuse_unseen_friends();
  /// Adds what another unit saw; the same entity or site counts once.
  void merge(Facts&& other);
};

}  // namespace tzc::rewriter
