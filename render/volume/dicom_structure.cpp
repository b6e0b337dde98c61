#include "render/volume/dicom_structure.h"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "presets/error.h"
#include "render/volume/voxel_data.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;
constexpr std::uint32_t transfer_syntax = 0x00020010, rows = 0x00280010, pixels = 0x7fe00010,
                        float_pixels = 0x7fe00008, double_pixels = 0x7fe00009;
constexpr std::size_t preamble = 128;

/// PS3.5, section 7: how an element's tag and length are written.
struct Coding {
  bool explicit_type = true, big_endian = false;
};

struct Element {
  std::uint32_t tag = 0, length = 0;
};

class Walker {
 public:
  explicit Walker(const fs::path& path)
      : name_(path.string()), file_(path, std::ios::binary), left_(fs::file_size(path)) {}

  std::string take(std::uint64_t count) {
    require(count);
    std::string bytes(count, '\0');
    if (!file_.read(bytes.data(), std::streamsize(count))) throw_short();
    left_ -= count;
    return bytes;
  }
  void skip(std::uint64_t count) {
    require(count);
    file_.seekg(std::streamoff(count), std::ios::cur);
    left_ -= count;
  }
  bool at_end() const { return left_ == 0; }
  /// The next element's group, of group 2 or of another, read in group 2's coding.
  std::uint64_t peek_group() {
    const std::uint64_t group = number(2, {});
    file_.seekg(-2, std::ios::cur);
    left_ += 2;
    return group;
  }

  Element next(Coding coding) {
    const std::uint64_t group = number(2, coding), member = number(2, coding);
    const auto tag = std::uint32_t(group << 16 | member);
    if (!coding.explicit_type || group == item >> 16) return {tag, std::uint32_t(number(4, coding))};
    constexpr std::string_view long_types = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    if (long_types.find(take(2)) == std::string_view::npos) return {tag, std::uint32_t(number(2, coding))};
    skip(2);
    return {tag, std::uint32_t(number(4, coding))};
  }

  /// Past the items of a sequence, or the fragments of compressed pixels, that says no length.
  void skip_sequence(Coding coding, int depth = 0) {
    constexpr int deepest = 32;
    if (depth > deepest) throw Error(fmt::format("{}: its DICOM sequences are nested too deeply", name_));
    for (Element part = next(coding); part.tag != sequence_end; part = next(coding)) {
      if (part.tag != item)
        throw Error(fmt::format("{}: damaged: a DICOM sequence holds what is no item", name_));
      if (part.length != undefined_length) {
        skip(part.length);
        continue;
      }
      for (Element inner = next(coding); inner.tag != item_end; inner = next(coding)) {
        inner.length == undefined_length ? skip_sequence(coding, depth + 1) : skip(inner.length);
      }
    }
  }

 private:
  std::uint64_t number(std::size_t size, Coding coding) {
    const std::string bytes = take(size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = coding.big_endian ? i : size - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  }
  void require(std::uint64_t count) const {
    if (count > left_) throw_short();
  }
  [[noreturn]] void throw_short() const {
    throw Error(fmt::format("{}: truncated: the DICOM file ends within an element", name_));
  }

  std::string name_;
  std::ifstream file_;
  std::uint64_t left_;
};

Coding coding_of(const std::string& name, std::string syntax) {
  while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
  if (syntax == "1.2.840.10008.1.2.1.99") {
    throw Error(fmt::format("{}: DICOM with a deflated data set is not read", name));
  }
  const bool implicit = syntax == "1.2.840.10008.1.2" || syntax == "1.2.840.113619.5.2";
  return {!implicit, syntax == "1.2.840.10008.1.2.2"};
}

}  // namespace

bool is_dicom(const fs::path& path) {
  if (!fs::is_regular_file(path)) return false;
  const std::string head = read_head(path, preamble + 4);
  return head.size() == preamble + 4 && head.ends_with("DICM");
}

DicomStructure read_dicom_structure(const fs::path& path) {
  const std::string name = path.string();
  if (!is_dicom(path)) throw Error(fmt::format("{}: not a DICOM file: it has no DICM at byte 128", name));
  Walker walker(path);
  walker.skip(preamble + 4);

  DicomStructure structure;
  bool has_rows = false;
  Coding coding;  // that of group 2, which says how the others are coded
  std::string syntax;
  while (!walker.at_end()) {
    if (!syntax.empty() && walker.peek_group() != 2) coding = coding_of(name, std::exchange(syntax, ""));
    const Element element = walker.next(coding);
    if (element.tag == transfer_syntax) {
      syntax = walker.take(element.length);
      continue;
    }
    has_rows = has_rows || element.tag == rows;
    element.length == undefined_length ? walker.skip_sequence(coding) : walker.skip(element.length);
    if (element.tag != pixels && element.tag != float_pixels && element.tag != double_pixels) continue;
    if (element.length != undefined_length) structure.pixel_bytes = element.length;
    structure.has_image = has_rows;
    return structure;
  }
  if (has_rows) throw Error(fmt::format("{}: truncated: the DICOM file has no pixels", name));
  return structure;
}

}  // namespace crest
