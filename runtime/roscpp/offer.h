// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <string>

namespace tzc {

/// The two XMLRPC methods that a node with TZC answers beside roscpp's own. A node without TZC answers with a
/// fault and stays on TCPROS.
constexpr const char kOfferMethod[] = "tzcOffer";  ///< publisher -> subscriber: "come over to shared memory"
constexpr const char kRequestMethod[] = "tzcRequest";  ///< subscriber -> publisher: "I can take an offer now"

/// Raised when the meaning of an offer, of a record's tag or of the control part changes; unequal versions
/// stay on TCPROS.
constexpr int kProtocolVersion = 1;

/// What a record's tag says about its bytes.
enum RecordTag : unsigned {
  kControlPart = 0,   ///< control part; the data parts lie in the record's blocks
  kWholeMessage = 1,  ///< a message in the stock wire format, in the record itself or in its one block
  kSwitch = 2,        ///< nothing: all that was sent over TCPROS before is on its way, shared records follow
};

/// An invitation to one subscriber for one topic.
struct Offer {
  std::string topic;  ///< resolved
  std::string md5sum;
  std::string publisher;   ///< caller id of the publishing node
  std::string address;     ///< of the channel
  std::string identity;    ///< host_identity() of the publisher
  std::string connection;  ///< connection_name() of the TCPROS connection that is to be replaced
  std::string token;       ///< the channel's hello, known to nobody else
};

XmlRpc::XmlRpcValue to_xmlrpc(const Offer& offer);
/// False when the parameters are not an offer of this protocol version.
bool from_xmlrpc(XmlRpc::XmlRpcValue& params, Offer& offer);

/// ROS's response triple.
XmlRpc::XmlRpcValue response(int code, const std::string& status);

}  // namespace tzc
