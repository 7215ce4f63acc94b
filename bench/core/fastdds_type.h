// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>

#include <algorithm>
#include <cstring>
#include <functional>

#include "measure.h"

namespace tzc {
namespace bench {

/// A struct of a stamp and an array of bytes, as fastddsgen would make it; the array's length is known only at run time.
/// Plain: its bytes are the same in memory and on the wire, so that Fast DDS can lend them.
class FastDdsType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit FastDdsType(std::size_t size_bytes)
      : size_(static_cast<std::uint32_t>(std::max(size_bytes, sizeof(Stamp)))) {
    setName("tzc_bench::Message");
    m_typeSize = header_bytes + size_;
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }

  std::uint32_t size() const { return size_; }

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    if (payload->max_size < m_typeSize) return false;
    constexpr unsigned char little_endian_cdr[header_bytes] = {0, 1, 0, 0};
    std::memcpy(payload->data, little_endian_cdr, header_bytes);
    std::memcpy(payload->data + header_bytes, data, size_);
    payload->encapsulation = CDR_LE;
    payload->length = m_typeSize;
    return true;
  }
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    if (payload->length < m_typeSize) return false;
    std::memcpy(data, payload->data + header_bytes, size_);
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [this] { return m_typeSize; };
  }
  void* createData() override { return ::operator new(size_); }
  void deleteData(void* data) override { ::operator delete(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
  bool is_bounded() const override { return true; }
  bool is_plain() const override { return true; }

 private:
  static constexpr std::uint32_t header_bytes = 4;  // CDR's: which byte order
  const std::uint32_t size_;
};

}  // namespace bench
}  // namespace tzc
