// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A rule is data: what it matches (a qualified name and an argument), and what it writes. The facts attach
// the resulting edits to the entity that the rule is about; the edits are made when that entity is ported.

#include <set>
#include <string>
#include <vector>

namespace tzc::rewriter {

/// A class whose objects are ported by writing another class.
struct ClassRename {
  enum class Role { publisher, filter, accessor };
  const char* rule;
  Role role;
  const char* from;  ///< qualified name; templates without arguments
  const char* to;
  const char* header;  ///< of `to`
};

/// A library function that takes the message: the call is replaced by one of the adapter's function.
struct LibraryCall {
  const char* rule;
  const char* function;  ///< qualified name
  unsigned argument;     ///< which argument is the message that is ported
  const char* to;
  const char* header;
  /// What becomes of the arrays' elements: the function fills them anew, gives the message those of a std::vector, or leaves them.
  enum class Elements { filled, of_vector, left } elements = Elements::filled;
};

/// A member function of a library class that becomes a free function with the object as first argument.
struct MethodCall {
  enum class Role {
    advertise,
    advertise_transport,
    publish,
    subscribe,
    subscribe_transport,
    builds_message,
    fills_message
  };
  const char* rule;
  Role role;
  const char* object;  ///< qualified name of the class
  const char* method;
  const char* to;
  const char* header;
  int arguments = -1;             ///< how many the call has; -1: any number
  unsigned filled = 0;            ///< of one that fills a message: which argument that is
  const char* message = nullptr;  ///< and of which type, "sensor_msgs/Image"; null: of any
};

/// A function of a library that advertises for the package, `advertise...`, and returns the publisher: the
/// result is passed to a function that attaches shared memory to the topic.
struct LibraryAdvertise {
  const char* rule;
  const char* result;  ///< qualified name of the publisher class
  const char* owner;   ///< the class whose own advertise functions are not meant
  bool is_template;    ///< of the message; else it is an image
  const char* to;
  const char* header;
};

/// A publisher that cannot become one of TZC's: the advertise call is passed to a function that attaches shared memory to the topic
/// and returns the publisher as it is.
struct AttachedAdvertise {
  const char* rule;
  const char* publisher;  ///< qualified name of its class
  bool is_template;       ///< of the message; else it is an image
  const char* to;
  const char* header;
};

/// A class of a library that advertises and publishes by itself and tells its topics: what a function of the library returns,
/// `advertise...`, is passed to a function that attaches shared memory to them.
struct LibraryTransport {
  const char* rule;
  const char* publisher;  ///< qualified name of the class
  const char* message;    ///< that it is given: "sensor_msgs/Image"
  const char* to;
  const char* header;
};

/// The rules of a run. Tests remove single ones to show that each is needed.
struct RuleSet {
  std::vector<const ClassRename*> classes;
  std::vector<const LibraryCall*> calls;
  std::vector<const MethodCall*> methods;
  std::vector<const LibraryAdvertise*> advertisers;
  std::vector<const AttachedAdvertise*> attached;
  std::vector<const LibraryTransport*> transports;
  std::vector<const MethodCall*> filters;  ///< of filters that cannot become TZC's

  const ClassRename* find_class(const std::string& name) const;
  /// The publisher or filter class that an earlier run wrote.
  const ClassRename* find_ported_class(const std::string& name) const;
  /// Either of them.
  const ClassRename* find_class_or_ported(const std::string& name) const;
  const LibraryCall* find_call(const std::string& function, unsigned argument) const;
  const MethodCall* find_method(const std::string& object, const std::string& method,
                                unsigned arguments) const;
  /// The names of those that write another function in place of this one.
  std::set<std::string> replacing(const std::string& function) const;
  const LibraryAdvertise* find_advertiser(const std::string& result) const;
  const AttachedAdvertise* find_attached(const std::string& publisher) const;
  const LibraryTransport* find_transport(const std::string& publisher) const;
  /// The function that an earlier run wrote to advertise, publish or subscribe.
  const MethodCall* find_ported_function(const std::string& function) const;
  /// The function that subscribes a filter of this class, which keeps it.
  const MethodCall* find_filter_call(const std::string& filter) const;
  /// Whether an earlier run wrote the function to subscribe such a filter.
  bool is_filter_call(const std::string& function) const;
};

/// Every rule of the rewriter but those named.
RuleSet all_rules(const std::set<std::string>& without = {});

}  // namespace tzc::rewriter
