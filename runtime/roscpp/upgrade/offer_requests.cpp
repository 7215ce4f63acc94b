// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/offer_requests.h"

#include <memory>

#include "roscpp/publish/publication_endpoint.h"

namespace tzc {
namespace detail {
namespace {

constexpr std::size_t kMostWaiting = 4096;

}  // namespace

void OfferRequests::note(const std::string& topic, const std::string& subscriber) {
  const Request request(topic, subscriber);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.size() >= kMostWaiting || !waiting_.insert(request).second) return;
  }
  clerk_.post([this, request] { grant(request); });
}

void OfferRequests::grant(const Request& request) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.erase(request);
  }
  if (const std::shared_ptr<PublicationEndpoint> endpoint = detail::find_endpoint(request.first))
    endpoint->offer_again(request.second);
}

}  // namespace detail
}  // namespace tzc
