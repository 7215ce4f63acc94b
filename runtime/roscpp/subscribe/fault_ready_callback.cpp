// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/fault_ready_callback.h"

#include <boost/make_shared.hpp>
#include <typeinfo>
#include <utility>

#include "channel/fault_signals.h"

namespace tzc {
namespace detail {
namespace {

class FaultReadyCallback final : public ros::CallbackInterface {
 public:
  explicit FaultReadyCallback(ros::CallbackInterfacePtr callback) : callback_(std::move(callback)) {}
  CallResult call() override {
    channel::keep_watching_write_faults();
    return callback_->call();
  }
  bool ready() override { return callback_->ready(); }

 private:
  const ros::CallbackInterfacePtr callback_;
};

}  // namespace

ros::CallbackInterfacePtr fault_ready(const ros::CallbackInterfacePtr& callback) {
  const ros::CallbackInterface& given = *callback;
  if (typeid(given) == typeid(FaultReadyCallback)) return callback;
  return boost::make_shared<FaultReadyCallback>(callback);
}

}  // namespace detail
}  // namespace tzc
