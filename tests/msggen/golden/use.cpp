// SPDX-License-Identifier: BSD-3-Clause
// Uses what user code can name of the golden headers, and checks what it means.
#include <tzc/demo/Ask.h>
#include <tzc/demo/AskResponse.h>
#include <tzc/demo/Buttons.h>
#include <tzc/demo/Cloud.h>
#include <tzc/demo/Corners.h>
#include <tzc/demo/Label.h>
#include <tzc/demo/Picture.h>
#include <tzc/demo/Shop.h>
#include <tzc/demo/Stock.h>

#include <pthread.h>

#include <boost/make_shared.hpp>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <type_traits>

#define REQUIRE(condition)                                            \
  do {                                                                \
    if (!(condition)) {                                               \
      std::fprintf(stderr, "%d: not so: %s\n", __LINE__, #condition); \
      std::exit(1);                                                   \
    }                                                                 \
  } while (false)

const std::string& quote_of_another_file();

template <class Twin, class Stock>
void require_no_silent_copies() {
  static_assert(!std::is_convertible<Stock, Twin>::value && !std::is_convertible<Twin, Stock>::value,
                "explicit");
  static_assert(std::is_constructible<Twin, Stock>::value && std::is_constructible<Stock, Twin>::value,
                "possible");
  static_assert(std::is_assignable<Twin&, Stock>::value && !std::is_assignable<Stock&, Twin>::value,
                "a stock message can be assigned, and nothing that becomes one");
  Twin empty;
  empty = {};
  static_assert(std::is_same<typename Twin::ConstPtr, boost::shared_ptr<const Twin>>::value, "as in roscpp");
}

void check_picture() {
  require_no_silent_copies<tzc::demo::Picture, demo::Picture>();
  static_assert(std::is_same<tzc::demo::Picture::Stock, demo::Picture>::value, "");
  static_assert(std::is_same<tzc::demo::Picture::Type, tzc::demo::Picture>::value, "");
  static_assert(std::is_same<tzc::demo::Stock::Stock, demo::Stock>::value, "");
  static_assert(std::is_same<tzc::demo::Stock::Type, tzc::demo::Stock>::value, "");
  static_assert(tzc::message::IsGenerated<tzc::demo::Shop>::value, "whatever its fields are called");
  static_assert(
      !tzc::message::IsTwin<const demo::Stock>::value && tzc::message::IsTwin<const tzc::demo::Stock>::value,
      "");
  static_assert(std::is_same<tzc::demo::Picture::_height_type, uint32_t>::value, "");
  static_assert(std::is_same<tzc::demo::Picture::_header_type, std_msgs::Header>::value,
                "stock where nothing is data");
  static_assert(std::is_same<tzc::demo::Picture::_data_type, tzc::Array<uint8_t>>::value, "");
  tzc::demo::PicturePtr picture = boost::make_shared<tzc::demo::Picture>();
  REQUIRE(picture->height == 0 && picture->data.empty());
  picture->data.resize(3);
  picture->header.frame_id = "camera";
  const tzc::demo::PictureConstPtr same = picture;
  REQUIRE(static_cast<demo::Picture>(*same).data.size() == 3);
  std::ostringstream text, stock_text;
  text << *same;
  stock_text << demo::Picture(*same);
  REQUIRE(text.str() == stock_text.str() && text.str().find("camera") != std::string::npos);
  REQUIRE(ros::message_traits::HasHeader<tzc::demo::Picture>::value);
  REQUIRE(ros::message_traits::timeStamp(*picture) != nullptr);
}

/// A stack that a message does not fit.
void on_small_stack(void* (*body)(void*)) {
  pthread_attr_t attributes;
  pthread_t thread;
  REQUIRE(pthread_attr_init(&attributes) == 0 && pthread_attr_setstacksize(&attributes, 128 * 1024) == 0);
  REQUIRE(pthread_create(&thread, &attributes, body, nullptr) == 0 && pthread_join(thread, nullptr) == 0);
  pthread_attr_destroy(&attributes);
}

void* check_large(void*) {
  const tzc::demo::StockPtr large = boost::make_shared<tzc::demo::Stock>();
  large->shelf[19999] = 2.5;
  large->labels[1].header.frame_id = "second";
  large->prices.resize(3);
  const boost::shared_ptr<demo::Stock> stock = tzc::message::make_stock(*large);
  REQUIRE(stock->shelf[19999] == 2.5 && stock->prices.size() == 3);
  REQUIRE(stock->labels[1].header.frame_id == "second");
  const boost::shared_ptr<demo::Stock> copy = tzc::message::make_stock(*stock);
  std::ostringstream text, printed, stock_text;
  text << *large;
  ros::message_operations::Printer<tzc::demo::Stock>::stream(printed, "", *large);
  stock_text << *copy;
  REQUIRE(text.str() == stock_text.str() && printed.str() == stock_text.str());
  return nullptr;
}

void check_cloud() {
  static_assert(std::is_same<tzc::demo::Cloud::_origin_type, demo::Place>::value,
                "no data part: the stock type");
  tzc::demo::Cloud cloud;
  cloud.channels.resize(2);
  cloud.channels[1].values.resize(5);
  cloud.points.resize(4);
  std::size_t arrays = 0, elements = 0;
  const auto count = [&](const auto& array) {
    ++arrays;
    elements += array.size();
  };
  tzc::message::Traits<tzc::demo::Cloud>::visit_data(cloud, count);
  REQUIRE(arrays == 3 && elements == 9);
  const tzc::demo::Cloud copy(cloud);
  tzc::message::Traits<tzc::demo::Cloud>::visit_data(copy, count);
  REQUIRE(copy == cloud && !(copy != cloud));
}

void check_buttons() {
  static_assert(sizeof(demo::Button) == 8, "two bytes of padding");
  tzc::demo::Buttons buttons;
  buttons.array.resize(3);
  REQUIRE(ros::serialization::serializationLength(buttons) == 4 + 3 * 6 + 4 + 4);
  REQUIRE(ros::serialization::serializationLength(demo::Buttons(buttons)) == 4 + 3 * 6 + 4 + 4);
}

void check_corners() {
  using tzc::demo::Corners;
  REQUIRE(Corners::LOWEST == -128 && Corners::LETTER == 'A' && Corners::FAR == -9007199254740993);
  REQUIRE(Corners::RATIO == demo::Corners::RATIO && Corners::WHOLE == 3.0 && Corners::YES == 1);
  REQUIRE(Corners::QUOTE == demo::Corners::QUOTE && Corners::QUOTE == "\"a\\b\" is it?? # this, too");
  REQUIRE(&Corners::QUOTE == &quote_of_another_file());
  Corners corners;
  corners.both[1].values.push_back(1);
  corners.Corners.push_back(2);
  corners.Stock = 3;
  const demo::Corners stock(corners);
  REQUIRE(stock.both[1].values.size() == 1 && stock.Corners[0] == 2 && stock.Stock == 3);
  REQUIRE(Corners(stock).both[1].values[0] == 1);
}

int main() {
  check_picture();
  on_small_stack(check_large);
  check_cloud();
  check_buttons();
  check_corners();
  static_assert(std::is_same<tzc::demo::Label, demo::Label>::value, "no data part");
  static_assert(std::is_same<tzc::demo::LabelConstPtr, demo::LabelConstPtr>::value, "");
  static_assert(std::is_same<tzc::demo::Ask, demo::Ask>::value, "a service");
  static_assert(std::is_same<tzc::demo::AskResponse::_view_type, tzc::demo::Picture>::value, "a twin inside");
  std::puts("golden headers: all as expected");
}
