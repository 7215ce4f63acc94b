// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/attachment.h>
#include <tzc/message.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

namespace tzc {
namespace detail {

/// A message on its way out: its partial form, and the stock message over the same shared bytes that subscribers of
/// this process and roscpp itself get to see.
template <class M>
struct SharedMessage {
  typedef typename message::StockOf<M>::type Stock;

  /// False when no shared memory is left.
  bool encode(const M& message, MemorySource& memory) { return message::encode(message, memory, encoded); }
  /// After encode. False: the message can't be viewed, which valid messages always can.
  bool look(const M& message) {
    view = message::stock_view(message, encoded);
    return view != nullptr;
  }

  message::Encoded encoded;
  boost::shared_ptr<const Stock> view;
};

/// Publishes a message by pointer through a publisher that takes only stock pointers: through shared memory when
/// somebody can take it, otherwise as a stock message on the heap.
/// @param publish called once with the pointer, or not at all when the message was dropped
template <class M, class Publish>
void publish_as_stock(Attachment* attachment, const M& message, Publish publish) {
  typedef typename message::StockOf<M>::type Stock;
  SharedMessage<M> shared;
  if (attachment && shared.encode(message, *attachment->memory()) && shared.look(message)) {
    const EncodedScope scope(shared.view.get(), shared.encoded);
    publish(shared.view);
  } else if (!attachment || attachment->delivers_exhausted()) {
    publish(boost::shared_ptr<const Stock>(boost::make_shared<Stock>(message::to_stock(message))));
  } else {
    attachment->count_dropped();
  }
}

}  // namespace detail
}  // namespace tzc
