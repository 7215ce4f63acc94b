// SPDX-License-Identifier: BSD-3-Clause
// Definitions of <tzc/message.h>.
#pragma once

#include <tzc/detail/partial_input.h>
#include <tzc/detail/partial_output.h>
#include <tzc/detail/placement.h>
#include <tzc/detail/view.h>
#include <tzc/detail/wire_input.h>

#include <boost/make_shared.hpp>

#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

namespace tzc {
namespace message {
namespace detail {

/// Reads all of the input into `message`; false when it does not fit exactly.
template <class Input, class S>
bool read(Input& input, S& message) {
  try {
    Codec<S>::read(input, message);
    return input.remaining() == 0;
  } catch (const ControlReader::Malformed&) {
    return false;
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const std::length_error&) {
    return false;
  }
}

/// Seals the blocks of `encoded`; returns their bytes, and what keeps them alive.
std::vector<ConstBlock> seal_blocks(Encoded& encoded);
std::shared_ptr<const void> hold_buffers(const Encoded& encoded);

}  // namespace detail

template <class M>
bool encode(const M& message, const std::shared_ptr<MemorySource>& memory, Encoded& encoded) {
  detail::PartialOutput output(encoded);
  Codec<M>::write(output, message);
  if (!output.finish(memory)) return false;
  Traits<M>::visit_message_arrays(message, [&](const auto& messages) { messages.bind_published(memory); });
  return true;
}

template <class S>
bool encode_serialized(const std::uint8_t* bytes, std::size_t size,
                       const std::shared_ptr<MemorySource>& memory, Encoded& encoded) {
  // Not on the stack: a message with an array of fixed size can be larger than that.
  const std::unique_ptr<detail::View<S> > view(new detail::View<S>(nullptr));
  detail::WireInput input(bytes, size, view->loan.borrowers());
  return detail::read(input, view->message) && encode(view->message, memory, encoded);
}

template <class S>
boost::shared_ptr<S> make_view(const std::uint8_t* control, std::size_t size,
                               const std::vector<ConstBlock>& blocks, std::shared_ptr<const void> hold) {
  const auto view = boost::make_shared<detail::View<S> >(std::move(hold));
  detail::PartialInput input(control, size, blocks, &view->loan.borrowers());
  if (!detail::read(input, view->message)) return boost::shared_ptr<S>();
  view->loan.release_unused();
  return boost::shared_ptr<S>(view, &view->message);
}

template <class S>
boost::shared_ptr<S> make_copy(const std::uint8_t* control, std::size_t size,
                               const std::vector<ConstBlock>& blocks) {
  const auto message = boost::make_shared<S>();
  detail::PartialInput input(control, size, blocks, nullptr);
  return detail::read(input, *message) ? message : boost::shared_ptr<S>();
}

template <class M>
boost::shared_ptr<const typename StockOf<M>::type> stock_view(const M&, Encoded& encoded) {
  const std::vector<ConstBlock> blocks = detail::seal_blocks(encoded);
  return make_view<typename StockOf<M>::type>(encoded.control.data(), encoded.control.size(), blocks,
                                              detail::hold_buffers(encoded));
}

template <class M>
boost::shared_ptr<const typename StockOf<M>::type> callback_view(const M&, Encoded& encoded) try {
  const BufferViews views = view_for_callbacks(encoded.buffers);
  return make_view<typename StockOf<M>::type>(encoded.control.data(), encoded.control.size(), views.blocks,
                                              views.hold);
} catch (const std::bad_alloc&) {
  return nullptr;
}

template <class M>
boost::shared_ptr<typename StockOf<M>::type> stock_copy(const M&, Encoded& encoded) {
  return make_copy<typename StockOf<M>::type>(encoded.control.data(), encoded.control.size(),
                                              detail::seal_blocks(encoded));
}

template <class M>
bool allocate(M& message, const std::shared_ptr<MemorySource>& memory) {
  detail::Placement placement(memory);
  Traits<M>::visit_message_arrays(message, [&](auto& messages) { messages.bind(memory); });
  Traits<M>::visit_data(message, [&](auto& array) { placement.measure(array); });
  if (!placement.acquire()) return false;
  Traits<M>::visit_data(message, [&](auto& array) { placement.place(array); });
  return true;
}

}  // namespace message
}  // namespace tzc
