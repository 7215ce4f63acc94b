// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/attachment.h>
#include <tzc/message.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

namespace tzc {
namespace detail {

/// How the program publishes a message. roscpp writes the topic's sequence number into what it gets by reference, for
/// subscribers of the same process, too, and into what it gets by pointer only on the wire.
enum class ByReference { no, yes };

/// A message that is being published: its partial form, and the stock message over the same shared bytes that
/// roscpp and subscribers of this process see.
template <class M>
struct SharedMessage {
  typedef typename message::StockOf<M>::type Stock;

  /// False when no shared memory is left.
  bool encode(const M& message, const std::shared_ptr<MemorySource>& memory) {
    return message::encode(message, memory, encoded);
  }
  /// Sets `view`; call encode first. False: no view is possible, which does not happen for a valid message.
  bool make_view(const M& message) {
    view = message::stock_view(message, encoded);
    return view != nullptr;
  }
  /// Calls `publish` with what roscpp and the callbacks of this process are to see (LocalView); call encode first. False: it did nothing, since no view is possible, which does not happen for a valid
  /// message.
  template <class Publish>
  bool publish_view(Attachment& attachment, const M& message, ByReference how, Others others,
                    const Publish& publish) {
    const auto publish_it = [&] {
      if (!make_local_view(attachment, message)) return;
      const EncodedScope scope(view.get(), encoded);
      publish(view);
    };
    if (how == ByReference::yes) {
      attachment.publish_numbered(typeid(Stock), encoded, others, publish_it);
    } else {
      attachment.send_queued();
      publish_it();
    }
    return view != nullptr;
  }

  message::Encoded encoded;
  boost::shared_ptr<const Stock> view;

 private:
  bool make_local_view(const Attachment& attachment, const M& message) {
    const LocalMessage local = attachment.local_message(typeid(Stock), encoded);
    switch (local.view) {
      case LocalView::unseen:
      case LocalView::borrowed:
        make_view(message);
        break;
      case LocalView::private_pages:
        view = message::callback_view(message, encoded);
        break;
      case LocalView::copy:
        view = message::stock_copy(message, encoded);
        break;
    }
    if (view && local.hold)
      view.reset(view.get(), [kept = view, hold = local.hold](const Stock*) mutable {
        kept.reset();
        hold.reset();
      });
    return view != nullptr;
  }
};

/// Publishes a message through a publisher that takes only stock pointers, and may take long (image_transport's plugins
/// compress meanwhile): over shared memory if there is any, otherwise as a stock message on the heap.
/// @param publish called once with the pointer, or not at all when the message was dropped, which none is that nobody takes
/// from shared memory
template <class M, class Publish>
void publish_as_stock(Attachment* attachment, const M& message, ByReference how, Publish publish) {
  typedef typename message::StockOf<M>::type Stock;
  SharedMessage<M> shared;
  if (attachment && shared.encode(message, attachment->memory()) &&
      shared.publish_view(*attachment, message, how, Others::publish, publish)) {
    return;
  } else if (!attachment || attachment->delivers_exhausted() || !attachment->wants_pointer(typeid(Stock))) {
    publish(boost::shared_ptr<const Stock>(message::make_stock(message)));
  } else {
    attachment->count_dropped(ros::serialization::serializationLength(message));
  }
}

}  // namespace detail
}  // namespace tzc
