// SPDX-License-Identifier: BSD-3-Clause
/// Lets an unmodified roscpp program use shared memory: put in front of libroscpp by tzc-run (LD_PRELOAD), this library
/// sees every advertise and subscribe call and attaches its topic, if it knows the message type.
#include <dlfcn.h>
#include <ros/node_handle.h>
#include <ros/subscription_callback_helper.h>
#include <tzc/subscribe.h>

#include "preload/codec_table.h"
#include "roscpp/publish/plain_attachment.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/traces/traced_callback.h"

namespace tzc {
namespace {

/// The function of that name in the next library: roscpp's own.
template <class Function>
Function next(const char* symbol) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, symbol));
}

/// Null for types without a data part, and for those that were not installed when TZC was built.
const detail::MessageCodec* codec_for(const std::string& datatype, const std::string& md5sum) {
  const auto found = codec_table().find(datatype);
  return found != codec_table().end() && found->second.md5sum == md5sum ? &found->second : nullptr;
}

}  // namespace
}  // namespace tzc

namespace ros {

// A member function is called like a free one with the object in front (Itanium C++ ABI 3.1.1, 3.1.3), so the next
// definition can be called through a plain function pointer.

Subscriber NodeHandle::subscribe(SubscribeOptions& options) {
  using Subscribe = Subscriber (*)(NodeHandle*, SubscribeOptions&);
  static const auto subscribe = tzc::next<Subscribe>("_ZN3ros10NodeHandle9subscribeERNS_16SubscribeOptionsE");
  const tzc::detail::MessageCodec* codec = tzc::codec_for(options.datatype, options.md5sum);
  if (codec && options.helper && options.helper->getTypeInfo() == *codec->type)
    tzc::detail::attach_topic(resolveName(options.topic), *codec);
  if (!options.callback_queue) options.callback_queue = getCallbackQueue();  // as roscpp's own function does
  SubscribeOptions prepared = options;  // the program may subscribe with them again
  prepared.callback_queue = tzc::detail::fault_ready_queue(*options.callback_queue);
  prepared.helper = tzc::detail::traced(options.helper, resolveName(options.topic));
  const Subscriber subscriber = subscribe(this, prepared);
  options.topic = prepared.topic;  // roscpp's own function resolves it, too
  return subscriber;
}

Publisher NodeHandle::advertise(AdvertiseOptions& options) {
  using Advertise = Publisher (*)(NodeHandle*, AdvertiseOptions&);
  static const auto advertise = tzc::next<Advertise>("_ZN3ros10NodeHandle9advertiseERNS_16AdvertiseOptionsE");
  const tzc::detail::MessageCodec* codec = tzc::codec_for(options.datatype, options.md5sum);
  AdvertiseOptions hooked = options;  // the program may advertise with them again
  if (!hooked.callback_queue) hooked.callback_queue = getCallbackQueue();  // as roscpp's own function does
  if (codec) tzc::detail::hook_advertisement(resolveName(options.topic), *codec, hooked);
  const Publisher publisher = advertise(this, hooked);
  options.topic = hooked.topic;  // roscpp's own function resolves it, too
  return publisher;
}

}  // namespace ros
