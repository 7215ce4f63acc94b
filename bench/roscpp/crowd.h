// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "process_needs.h"

namespace tzc {
namespace bench {

/// One process that publishes many topics, and others each of which subscribes to all of them.
struct Crowd {
  std::size_t topics = 12;
  std::size_t subscribers = 3;
  std::size_t memory_bytes = 0;  ///< of each publisher; 0: its default
  std::size_t descriptors = 0;   ///< that each process may have; 0: as many as permitted
  std::size_t patience_s = 15;   ///< without any progress; then what has come must do
  std::size_t connections() const { return topics * subscribers; }
};

/// What one message on each topic came to, after all connections were made. What processes need is looked at some seconds later.
struct CrowdResult {
  double connected_s = 0;     ///< until TCPROS had connected the last; of the processes' start
  double upgraded_s = 0;      ///< from then until the last connection was on shared memory
  std::size_t connected = 0;  ///< connections
  std::size_t upgraded = 0;   ///< of those, on shared memory
  std::size_t delivered = 0;  ///< messages
  Needs publisher;
  Needs subscriber;  ///< the most of any
};

/// How the crowd's nodes publish and subscribe. One object for each process.
class CrowdTransport {
 public:
  virtual ~CrowdTransport() = default;
  virtual const char* name() const = 0;
  virtual bool shares_memory() const = 0;
  virtual void advertise(const std::string& topic, std::size_t memory_bytes) = 0;
  virtual void subscribe(const std::string& topic, const std::function<void()>& on_message) = 0;
  /// Connections of all topics.
  virtual std::size_t connected() const = 0;
  virtual std::size_t upgraded() const = 0;
  /// One message on each topic.
  virtual void publish(std::size_t bytes) const = 0;
};

enum class Transport { tcpros, tzc };
/// In a process that has a ROS node.
std::unique_ptr<CrowdTransport> crowd_transport(Transport transport);

/// Runs the crowd in processes of its own. False: a process ended before its time.
bool run_crowd(const Crowd& crowd, Transport transport, CrowdResult& result);

}  // namespace bench
}  // namespace tzc
