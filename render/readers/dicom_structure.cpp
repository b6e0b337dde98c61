#include "render/readers/dicom_structure.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "presets/error.h"
#include "render/files/kinds.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;
constexpr std::uint32_t transfer_syntax = 0x00020010, rows = 0x00280010, bits_allocated = 0x00280100,
                        pixels = 0x7fe00010, float_pixels = 0x7fe00008, double_pixels = 0x7fe00009;
constexpr std::size_t preamble = 128;

/// PS3.5, section 7: how an element's tag and length are written.
struct Coding {
  bool explicit_type = true, big_endian = false;
  bool big_endian_pixels = false;  ///< as of 16-bit words, or of what is longer
  bool compresses = false, has_run_lengths = false;
};

struct Element {
  std::uint32_t tag = 0, length = 0;
  std::string type = {};  ///< "DS"; empty when the file does not say it
};

/// Elements whose type GDCM takes for granted.
constexpr std::pair<std::uint32_t, std::string_view> known_types[] = {
    {0x00080016, "UI"}, {0x00080018, "UI"}, {0x00080060, "CS"}, {0x00180050, "DS"}, {0x00180088, "DS"},
    {0x0020000d, "UI"}, {0x0020000e, "UI"}, {0x00200013, "IS"}, {0x00200032, "DS"}, {0x00200037, "DS"},
    {0x00280004, "CS"}, {0x00280006, "US"}, {0x00280008, "IS"}, {0x00280030, "DS"}, {0x00281050, "DS"},
    {0x00281051, "DS"}, {0x00281052, "DS"}, {0x00281053, "DS"},
};

/// Whole numbers (US) that it takes for granted: what they may be, from `min` to `max` (PS3.3, C.7.6.3).
struct Limits {
  std::uint32_t tag;
  std::uint64_t min, max, step = 1;
};
constexpr Limits image_limits[] = {
    {0x00280002, 1, 3, 2},   // samples per pixel
    {rows, 1, 65535},        //
    {0x00280011, 1, 65535},  // columns
    {0x00280101, 1, 64},     // bits stored, and the highest one
    {0x00280102, 0, 63},     //
    {0x00280103, 0, 1},      // signed
};

constexpr std::string_view short_types = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
constexpr std::string_view long_types = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
bool is_type(std::string_view type) {
  return short_types.find(type) != std::string_view::npos || long_types.find(type) != std::string_view::npos;
}

/// No type at all, before a short length.
constexpr std::string_view no_type("\0\0", 2);

/// A sequence whose type its writer did not know is coded as where no types are told (PS3.5, 6.2.2).
Coding coding_within(const Element& sequence, Coding coding) {
  return sequence.type == "UN" ? Coding{.explicit_type = false} : coding;
}

class Walker {
 public:
  explicit Walker(const fs::path& path)
      : name_(path.string()), file_(path, std::ios::binary), size_(fs::file_size(path)), left_(size_) {}

  std::string take(std::uint64_t count) {
    require(count);
    std::string bytes(count, '\0');
    if (!file_.read(bytes.data(), std::streamsize(count))) throw_short();
    left_ -= count;
    return bytes;
  }
  std::uint64_t number(std::size_t size, Coding coding) {
    const std::string bytes = take(size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = coding.big_endian ? i : size - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  }
  void skip(std::uint64_t count) {
    require(count);
    file_.seekg(std::streamoff(count), std::ios::cur);
    left_ -= count;
  }
  [[noreturn]] void throw_damaged(std::string_view how) const {
    throw Error(fmt::format("{}: the DICOM file is damaged: {}", name_, how));
  }
  bool at_end() const { return left_ == 0; }
  std::uint64_t place() const { return size_ - left_; }
  /// The next element's group, of group 2 or of another, read in group 2's coding.
  std::uint64_t peek_group() {
    const std::string bytes = peek(2);
    return std::uint64_t(static_cast<unsigned char>(bytes[1])) << 8 | static_cast<unsigned char>(bytes[0]);
  }
  /// Whether the next element tells its type, behind its tag.
  bool peek_has_type() {
    const std::string bytes = peek(6);
    return is_type(bytes.substr(4));
  }
  /// At the file's begin: whether a head is there.
  bool has_head() { return size_ >= preamble + 4 && peek(preamble + 4).ends_with("DICM"); }

  Element next(Coding coding) {
    const std::uint64_t group = number(2, coding), member = number(2, coding);
    const auto tag = std::uint32_t(group << 16 | member);
    if (!coding.explicit_type || group == item >> 16) return {tag, std::uint32_t(number(4, coding)), ""};
    const std::string type = take(2);
    if (short_types.find(type) != std::string_view::npos)
      return {tag, std::uint32_t(number(2, coding)), type};
    if (type == no_type) return {tag, std::uint32_t(number(2, coding)), type};
    if (long_types.find(type) == std::string_view::npos) throw_damaged("an element has an unknown type");
    skip(2);
    return {tag, std::uint32_t(number(4, coding)), type};
  }

  /// Past the items of a sequence that says no length.
  void skip_sequence(Coding coding, int depth = 0) {
    constexpr int deepest = 32;
    if (depth > deepest) throw_damaged("its sequences are nested too deeply");
    for (Element part = next(coding); part.tag != sequence_end; part = next(coding)) {
      if (part.tag != item) throw_damaged("a sequence holds what is no item");
      if (part.length != undefined_length) {
        skip(part.length);
        continue;
      }
      for (Element inner = next(coding); inner.tag != item_end; inner = next(coding)) {
        if (inner.length == undefined_length)
          skip_sequence(coding_within(inner, coding), depth + 1);
        else
          skip(inner.length);
      }
    }
  }

  /// Past those of compressed pixels; the first is a table, and none of them.
  std::vector<DicomFragment> take_fragments(Coding coding) {
    std::vector<DicomFragment> fragments;
    bool is_table = true;
    for (Element part = next(coding); part.tag != sequence_end; part = next(coding)) {
      if (part.tag != item || part.length == undefined_length)
        throw_damaged("its compressed pixels hold what is no fragment");
      if (!is_table) fragments.push_back({place(), part.length});
      is_table = false;
      skip(part.length);
    }
    return fragments;
  }

 private:
  std::string peek(std::size_t count) {
    std::string bytes = take(count);
    file_.seekg(-std::streamoff(count), std::ios::cur);
    left_ += count;
    return bytes;
  }
  void require(std::uint64_t count) const {
    if (count > left_) throw_short();
  }
  [[noreturn]] void throw_short() const {
    throw Error(fmt::format("{}: truncated: the DICOM file ends within an element", name_));
  }

  std::string name_;
  std::ifstream file_;
  std::uint64_t size_, left_;
};

/// PS3.5, section 10 and annex A; the last one is GE's, of which only the pixels are big-endian.
Coding coding_of(const std::string& name, std::string syntax) {
  while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
  if (syntax == "1.2.840.10008.1.2.1.99") {
    throw Error(
        fmt::format("{}: DICOM with a deflated data set is not read; this writes one that is: "
                    "dcmconv +te {} NEW.dcm",
                    name, name));
  }
  if (syntax == "1.2.840.10008.1.2") return {.explicit_type = false};
  if (syntax == "1.2.840.10008.1.2.1") return {};
  if (syntax == "1.2.840.10008.1.2.2") return {.big_endian = true, .big_endian_pixels = true};
  if (syntax == "1.2.840.113619.5.2") return {.explicit_type = false, .big_endian_pixels = true};
  return {.compresses = true, .has_run_lengths = syntax == "1.2.840.10008.1.2.5"};
}

std::string tag_text(std::uint32_t tag) { return fmt::format("({:04x},{:04x})", tag >> 16, tag & 0xffff); }

/// Takes the element's number if it is one with limits, and whether it was.
bool check_number(Walker& walker, const Element& element, Coding coding) {
  const auto limits = std::ranges::find(image_limits, element.tag, &Limits::tag);
  if (limits == std::end(image_limits)) return false;
  const bool is_number =
      element.length == 2 && (element.type == "US" || element.type == "UN" || element.type.empty());
  const std::uint64_t value = is_number ? walker.number(2, coding) : 0;
  if (!is_number || value < limits->min || value > limits->max || (value - limits->min) % limits->step != 0) {
    walker.throw_damaged(fmt::format("{} is {}, and not one of {} to {} by {}", tag_text(element.tag), value,
                                     limits->min, limits->max, limits->step));
  }
  return true;
}

void check_bits_allocated(Walker& walker, const Element& element, Coding coding) {
  const std::uint64_t bits = element.length == 2 ? walker.number(2, coding) : 0;
  if (bits != 1 && (bits == 0 || bits > 64 || bits % 8 != 0))
    walker.throw_damaged(
        fmt::format("{} is {}, and not 1, or one of 8 to 64 by 8", tag_text(element.tag), bits));
}

/// Bytes count by 16-bit words where they are said to be such, as the first pixel of two is a word's low
/// half.
DicomPlace place_of(const Walker& walker, const Element& element, Coding coding) {
  DicomPlace place{walker.place(), element.length};
  if (element.tag == float_pixels) place.numbers = DicomNumbers::float32;
  if (element.tag == double_pixels) place.numbers = DicomNumbers::float64;
  if (!coding.big_endian_pixels || element.type == "OB") return place;
  place.swapped = element.tag == float_pixels    ? sizeof(float)
                  : element.tag == double_pixels ? sizeof(double)
                                                 : 2;
  return place;
}

}  // namespace

DicomStructure read_dicom_structure(const fs::path& path) {
  const std::string name = path.string();
  if (!is_dicom(path))
    throw Error(
        fmt::format("{}: not a DICOM file: it has no DICM at byte 128, nor begins with an element", name));
  Walker walker(path);
  if (walker.has_head()) walker.skip(preamble + 4);

  DicomStructure structure;
  bool has_rows = false, has_pixels = false;
  std::uint32_t last_tag = 0;
  Coding coding;  // that of group 2, which says how the others are coded, where it is there
  if (!walker.at_end() && walker.peek_group() != 2) coding.explicit_type = walker.peek_has_type();
  std::string syntax;
  while (!walker.at_end()) {
    if (!syntax.empty() && walker.peek_group() != 2) coding = coding_of(name, std::exchange(syntax, ""));
    const Element element = walker.next(coding);
    if (element.tag <= last_tag) walker.throw_damaged("its elements are out of order");
    last_tag = element.tag;
    if (element.tag == bits_allocated) {
      check_bits_allocated(walker, element, coding);
      continue;
    }
    if (check_number(walker, element, coding)) {
      has_rows = has_rows || element.tag == rows;
      continue;
    }
    for (const auto& [tag, type] : known_types) {
      if (element.tag == tag && !element.type.empty() && element.type != "UN" && element.type != type) {
        walker.throw_damaged(fmt::format("{} is of type {}, not {}", tag_text(tag), element.type, type));
      }
    }
    if (element.tag == transfer_syntax) {
      syntax = walker.take(element.length);
      continue;
    }
    if (element.tag == pixels || element.tag == float_pixels || element.tag == double_pixels) {
      has_pixels = true;
      structure.pixel_tag = element.tag;
      structure.is_run_lengths = coding.has_run_lengths;
      if (element.length != undefined_length && !coding.compresses)
        structure.pixels = place_of(walker, element, coding);
    }
    if (element.length != undefined_length)
      walker.skip(element.length);
    else if (element.tag == pixels)
      structure.fragments = walker.take_fragments(coding);
    else
      walker.skip_sequence(coding_within(element, coding));
    structure.end = walker.place();
    if (has_pixels) break;  // behind them lie signatures, and what pads the file
  }
  if (has_rows && !has_pixels) throw Error(fmt::format("{}: truncated: the DICOM file has no pixels", name));
  structure.has_image = has_rows && has_pixels;
  return structure;
}

}  // namespace crest
