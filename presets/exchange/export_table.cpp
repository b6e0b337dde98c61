// A table of equidistant values, in the forms that scripts and other tools read.
#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

#include "presets/error.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/png_strip.h"
#include "presets/exchange/script_text.h"
#include "presets/exchange/table.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"

namespace crest {
namespace {

TfTable1d table_of(const ExportInput& input, bool of_volume) {
  const TransferFunction& tf = input.preset.transfer_function;
  // Formats that say nothing of their range have that of the volume
  const ValueRange range = of_volume ? range_there(input) : with_width(tf.range());
  if (input.rows != 0 && (input.rows < 2 || input.rows > most_table_rows))
    throw Error(fmt::format("{} samples are not in [2, {}]", input.rows, most_table_rows));
  return make_table(tf, range, input.rows ? input.rows : fewest_rows(tf, range));
}

void say_table_losses(const ExportInput& input, const TfTable1d& table, Exported& result) {
  const std::string rows =
      fmt::format("{} rows over {}..{}, {:.3g} apart", table.rows.size(), short_number(table.range.min),
                  short_number(table.range.max), table.spacing());
  if (table.largest_error > 1.0 / 255)
    result.losses.push_back(
        fmt::format("{}: opacity or colour is off by up to {:.3g} at a control point (at {})", rows,
                    table.largest_error, short_number(table.at_value)));
  if (table.widened > 0)
    result.losses.push_back(fmt::format("{}: {} {} put on the nearest, in full height and one row wide", rows,
                                        table.widened, table.widened == 1 ? "peak is" : "peaks are"));
  if (table.lost > 0)
    result.losses.push_back(fmt::format("{}: {} {} in the row of a higher one", rows, table.lost,
                                        table.lost == 1 ? "peak is lost" : "peaks are lost"));
  const ValueRange tf_range = input.preset.transfer_function.range();
  if (tf_range.min < table.range.min || tf_range.max > table.range.max)
    result.losses.push_back(fmt::format("{}: the points outside of that are cut off", rows));
  say_no_peaks(input, result.losses);
  say_no_surface_settings(input, result.losses);
  say_no_rendering(input, result.losses);
}

/// For a table that holds opacities as they are and no unit.
void say_no_unit_distance(const ExportInput& input, Exported& result) {
  result.losses.push_back(
      fmt::format("the unit distance is not in the file: opacities are those of {} world units",
                  short_number(input.preset.transfer_function.unit_distance)));
}

void say_range(const TfTable1d& table, Exported& result) {
  result.losses.push_back(fmt::format("the range of values is not in the file: its rows are {}..{}",
                                      short_number(table.range.min), short_number(table.range.max)));
}

}  // namespace

Exported write_csv(const ExportInput& input) {
  const TfTable1d table = table_of(input, false);
  const double unit_distance = input.preset.transfer_function.unit_distance;
  std::string text = "value,red,green,blue,opacity,extinction\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const glm::dvec4& c = table.rows[row];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", table.value(row), c.r, c.g, c.b, c.a,
                   extinction(c.a, unit_distance));
  }
  Exported result;
  result.files.push_back({"", std::move(text)});
  say_table_losses(input, table, result);
  return result;
}

// NumPy's own format, version 1.0: a header of a multiple of 64 bytes, then little-endian doubles.
Exported write_npy(const ExportInput& input) {
  static_assert(std::endian::native == std::endian::little);
  const TfTable1d table = table_of(input, false);
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, 5), }}", table.rows.size());
  constexpr std::size_t prefix = 10, block = 64;
  header.append(block - (prefix + header.size() + 1) % block, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += char(header.size() & 0xff);
  bytes += char(header.size() >> 8);
  bytes += header;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const glm::dvec4& c = table.rows[row];
    const double numbers[] = {table.value(row), c.r, c.g, c.b, c.a};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  }
  Exported result;
  result.files.push_back({"", std::move(bytes)});
  say_table_losses(input, table, result);
  say_no_unit_distance(input, result);
  result.advice.emplace_back("table = numpy.load(FILE): columns value, red, green, blue, opacity");
  result.advice.emplace_back(
      "matplotlib: ListedColormap(table[:, 1:]); napari: Colormap(table[:, 1:]), contrast_limits = "
      "(table[0, 0], table[-1, 0])");
  result.advice.emplace_back(
      "yt: tf = ColorTransferFunction((table[0, 0], table[-1, 0]), nbins=len(table)); tf.red.y, tf.green.y, "
      "tf.blue.y, tf.alpha.y = table[:, 1:].T");
  return result;
}

Exported write_png(const ExportInput& input) {
  const TfTable1d table = table_of(input, true);
  Exported result;
  result.files.push_back({"", png_strip(table.rows, 4)});
  say_table_losses(input, table, result);
  say_range(table, result);
  say_no_unit_distance(input, result);
  return result;
}

// ImageVis3D's and VisRTX's: a count, then "R G B A" a row, equidistant over the volume's range.
Exported write_1dt(const ExportInput& input) {
  const TfTable1d table = table_of(input, true);
  std::string text = fmt::format("{}\n", table.rows.size());
  for (const glm::dvec4& c : table.rows)
    fmt::format_to(std::back_inserter(text), "{:.9g} {:.9g} {:.9g} {:.9g}\n", c.r, c.g, c.b, c.a);
  Exported result;
  result.files.push_back({"", std::move(text)});
  say_table_losses(input, table, result);
  say_range(table, result);
  say_no_unit_distance(input, result);
  result.advice.emplace_back("ImageVis3D: 1D Transfer Function > Load");
  result.advice.emplace_back(
      "VisRTX: leave out the first line (the count), put the file into ~/.config/tsd/colormaps");
  return result;
}

// F3D >= 3.5: two strips and the command line; VTK's unit distance of one world unit.
Exported write_f3d(const ExportInput& input) {
  ExportInput scaled = input;
  scaled.preset.transfer_function = with_unit_distance(input.preset.transfer_function, 1);
  const TfTable1d table = table_of(scaled, true);
  std::vector<glm::dvec4> opacities;
  for (const glm::dvec4& c : table.rows) opacities.emplace_back(c.a, c.a, c.a, 1);
  Exported result;
  const glm::dvec3 background = input.preset.rendering.background;
  std::string text = fmt::format(
      "#!/bin/sh\n# Written by Crest from the preset \"{}\". Needs F3D 3.5 or newer.\n"
      "here=$(dirname \"$0\")\nvolume={}\n[ $# -gt 0 ] && volume=$1\n"
      "f3d \"$volume\" --volume --coloring-range={},{} \\\n"
      "  --colormap-file=\"$here\"/{} --volume-opacity-file=\"$here\"/{} \\\n"
      "  --background-color={},{},{}\n",
      one_line(input.name),
      shell_string(input.volume && !input.volume->file.empty() ? input.volume->file : "VOLUME"),
      number(table.range.min), number(table.range.max), shell_string(input.stem + "-colors.png"),
      shell_string(input.stem + "-opacity.png"), number(background.r), number(background.g),
      number(background.b));
  result.files.push_back({"", std::move(text)});
  result.files.push_back({"-colors.png", png_strip(table.rows, 3)});
  result.files.push_back({"-opacity.png", png_strip(opacities, 3)});
  say_table_losses(scaled, table, result);
  if (input.preset.transfer_function.unit_distance != 1)
    result.losses.push_back(
        fmt::format("F3D has no unit distance: opacities are written for 1 world unit in place of {}",
                    number(input.preset.transfer_function.unit_distance)));
  return result;
}

namespace {

/// VTK's rendering, of the table's own rows.
Preset drawn_by(const ExportInput& input, bool of_volume) {
  const TfTable1d table = table_of(input, of_volume);
  Preset drawn = in_vtk_settings(input.preset);
  TransferFunction& tf = drawn.transfer_function;
  tf.points.clear();
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    tf.points.push_back({.value = table.value(row),
                         .color = glm::dvec3(table.rows[row]),
                         .opacity = table.rows[row].a,
                         .surface = {},
                         .unknown = {}});
  return drawn;
}

}  // namespace

Preset drawn_by_table(const ExportInput& input) { return drawn_by(input, false); }

Preset drawn_by_volume_table(const ExportInput& input) { return drawn_by(input, true); }

Preset drawn_by_f3d(const ExportInput& input) {
  ExportInput scaled = input;
  scaled.preset.transfer_function = with_unit_distance(input.preset.transfer_function, 1);
  return drawn_by(scaled, true);
}

}  // namespace crest
