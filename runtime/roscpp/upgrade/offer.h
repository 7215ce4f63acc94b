// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <string>

#include "channel/wire/wire.h"
#include "segment/layout.h"

namespace tzc {
namespace detail {

/// The two XMLRPC methods that a node with TZC answers beside roscpp's own. A node without TZC answers with a
/// fault and stays on TCPROS.
constexpr const char kOfferMethod[] = "tzcOffer";      ///< publisher -> subscriber: an offer
constexpr const char kRequestMethod[] = "tzcRequest";  ///< subscriber -> publisher: a request for an offer

/// Raise it when the meaning of an offer, of a record's tag or of the control part changes.
constexpr int kProtocolVersion = 1;

/// All that two nodes must agree on before they share memory, in the first field of offers and requests: the protocol and
/// the layouts of packets and files. So a change of any of the three keeps unequal nodes on TCPROS from the start, instead
/// of breaking their channel later.
constexpr int kOfferVersion = (kProtocolVersion * 1000 + static_cast<int>(channel::wire_version)) * 1000 +
                              static_cast<int>(segment::layout_version);

/// The tag of a record: the format of its bytes.
enum RecordTag : unsigned {
  kControlPart = 0,   ///< control part; the data parts lie in the record's blocks
  kWholeMessage = 1,  ///< a message in the stock wire format, in the record itself or in its one block
  /// The switch record: everything before was sent over TCPROS, shared records follow. Holds a u64: how many
  /// bytes of the publisher's memory one subscriber may hold.
  kSwitch = 2,
};

/// Invites one subscriber of one topic.
struct Offer {
  std::string topic;  ///< resolved
  std::string md5sum;
  std::string publisher;   ///< caller id of the publishing node
  std::string address;     ///< of the channel
  std::string identity;    ///< host_identity() of the publisher
  std::string connection;  ///< connection_name() of the TCPROS connection to replace
  std::string token;       ///< the channel's hello, a secret of both ends
};

XmlRpc::XmlRpcValue to_xmlrpc(const Offer& offer);
/// False when the parameters are not an offer of this version.
bool from_xmlrpc(XmlRpc::XmlRpcValue& params, Offer& offer);

/// The answer to an offer that the subscriber takes. Another text with the same code: it does not come this time, and why.
constexpr const char kComingStatus[] = "coming";
/// The status with which a node refuses an offer of another version. Every release uses these words: the publisher knows
/// the reason by them.
constexpr const char kOtherVersionStatus[] = "not an offer of this version of TZC";
/// The parameters are an offer of another version; its topic and publisher, which have the same places in every version.
bool is_other_version(XmlRpc::XmlRpcValue& params, Offer& offer);

/// ROS's response triple.
XmlRpc::XmlRpcValue response(int code, const std::string& status);

}  // namespace detail
}  // namespace tzc
