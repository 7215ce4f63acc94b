// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/offer.h"

namespace tzc {
namespace detail {
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
constexpr int kStrings = 7;
constexpr int kPublisher = 3;  ///< the last of those that keep their places in every version

/// A number, and so many strings at least.
bool has_fields(XmlRpcValue& params, int strings) {
  if (params.getType() != XmlRpcValue::TypeArray || params.size() <= strings) return false;
  if (params[0].getType() != XmlRpcValue::TypeInt) return false;
  for (int i = 1; i <= strings; ++i)
    if (params[i].getType() != XmlRpcValue::TypeString) return false;
  return true;
}

}  // namespace

XmlRpcValue to_xmlrpc(const Offer& offer) {
  XmlRpcValue params;
  params[0] = kOfferVersion;
  visit_strings(offer, [&](int index, const std::string& text) { params[index] = text; });
  return params;
}

bool from_xmlrpc(XmlRpcValue& params, Offer& offer) {
  if (!has_fields(params, kStrings) || params.size() != 1 + kStrings) return false;
  if (static_cast<int>(params[0]) != kOfferVersion) return false;
  visit_strings(offer, [&](int index, std::string& text) { text = static_cast<std::string>(params[index]); });
  return true;
}

bool is_other_version(XmlRpcValue& params, Offer& offer) {
  if (!has_fields(params, kPublisher) || static_cast<int>(params[0]) == kOfferVersion) return false;
  offer.topic = static_cast<std::string>(params[1]);
  offer.publisher = static_cast<std::string>(params[kPublisher]);
  return true;
}

XmlRpcValue response(int code, const std::string& status) {
  XmlRpcValue value;
  value[0] = code;
  value[1] = status;
  value[2] = 0;
  return value;
}

}  // namespace detail
}  // namespace tzc
