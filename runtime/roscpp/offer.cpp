// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/offer.h"

namespace tzc {
namespace {

using XmlRpc::XmlRpcValue;

/// The offer's strings in the order in which they travel, after the version.
template <class OfferType, class Visit>
void visit_strings(OfferType& offer, Visit visit) {
  visit(1, offer.topic);
  visit(2, offer.md5sum);
  visit(3, offer.publisher);
  visit(4, offer.address);
  visit(5, offer.identity);
  visit(6, offer.connection);
  visit(7, offer.token);
}
constexpr int kFields = 8;

bool has_offer_shape(XmlRpcValue& params) {
  if (params.getType() != XmlRpcValue::TypeArray || params.size() != kFields) return false;
  if (params[0].getType() != XmlRpcValue::TypeInt) return false;
  for (int i = 1; i < kFields; ++i)
    if (params[i].getType() != XmlRpcValue::TypeString) return false;
  return true;
}

}  // namespace

XmlRpcValue to_xmlrpc(const Offer& offer) {
  XmlRpcValue params;
  params[0] = kProtocolVersion;
  visit_strings(offer, [&](int index, const std::string& text) { params[index] = text; });
  return params;
}

bool from_xmlrpc(XmlRpcValue& params, Offer& offer) {
  if (!has_offer_shape(params) || static_cast<int>(params[0]) != kProtocolVersion) return false;
  visit_strings(offer, [&](int index, std::string& text) { text = static_cast<std::string>(params[index]); });
  return true;
}

XmlRpcValue response(int code, const std::string& status) {
  XmlRpcValue value;
  value[0] = code;
  value[1] = status;
  value[2] = 0;
  return value;
}

}  // namespace tzc
