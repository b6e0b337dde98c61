#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "files.h"

namespace crest::test {

/// A file's elements, in their order.
class Elements {
 public:
  Elements& put(unsigned group, unsigned number, const std::string& type, const std::string& value) {
    elements_[{group, number}] = dicom_element(group, number, type, value);
    return *this;
  }
  /// Of items with their lengths.
  Elements& put_items(unsigned group, unsigned number, const std::vector<std::string>& items) {
    std::string content;
    for (const std::string& item : items) {
      content += std::string("\xfe\xff\x00\xe0", 4);
      append_value(content, double(item.size()), ScalarType::uint32, std::endian::little);
      content += item;
    }
    return put(group, number, "SQ", content);
  }
  std::string bytes() const {
    std::string all;
    for (const auto& [tag, element] : elements_) all += element;
    return all;
  }

 private:
  std::map<std::pair<unsigned, unsigned>, std::string> elements_;
};

inline constexpr const char* nuclear_class = "1.2.840.10008.5.1.4.1.1.20";

/// 3x2 pixels an image, 10 f + i in frame f.
inline Elements image(int frames, const std::string& instance = "1.2.3.4") {
  std::string pixels;
  for (int f = 0; f < frames; ++f)
    for (int i = 0; i < 6; ++i) pixels += dicom_us(10 * f + i);
  Elements elements;
  elements.put(8, 0x60, "CS", "NM").put(0x20, 0xd, "UI", "1.2").put(0x20, 0xe, "UI", "1.2.3");
  if (frames > 1) elements.put(0x28, 8, "IS", std::to_string(frames));
  elements.put(0x28, 2, "US", dicom_us(1)).put(0x28, 4, "CS", "MONOCHROME2");
  elements.put(0x28, 0x10, "US", dicom_us(2)).put(0x28, 0x11, "US", dicom_us(3));
  elements.put(0x28, 0x30, "DS", "2\\1").put(0x28, 0x100, "US", dicom_us(16));
  elements.put(0x28, 0x101, "US", dicom_us(16)).put(0x28, 0x102, "US", dicom_us(15));
  elements.put(0x28, 0x103, "US", dicom_us(0)).put(0x7fe0, 0x10, "OW", pixels);
  elements.put(8, 0x16, "UI", nuclear_class).put(8, 0x18, "UI", instance);
  return elements;
}

/// What is before them: group 2 alone.
inline std::string dicom_head_of_two() {
  std::string head = dicom_head(nuclear_class, "1");
  head.resize(head.find(std::string("\x08\x00\x16\x00", 4)));
  return head;
}

}  // namespace crest::test
