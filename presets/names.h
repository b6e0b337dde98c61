#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "presets/preset.h"

namespace crest {

/// What a value is called in files, on the command line and in the interface.
template <class T>
struct Named {
  T value;
  std::string_view name;
};

/// The names of an enumeration's values, each in this one place.
template <class T>
struct EnumNames;

template <>
struct EnumNames<Mode> {
  static constexpr Named<Mode> table[] = {{Mode::both, "both"},
                                          {Mode::peak_xor_dvr, "PEAK_XOR_DVR"},
                                          {Mode::peak_only, "PEAK_ONLY"},
                                          {Mode::dvr_only, "DVR_ONLY"}};
};
template <>
struct EnumNames<PeakForm> {
  static constexpr Named<PeakForm> table[] = {{PeakForm::split, "split"}, {PeakForm::paper, "paper"}};
};
template <>
struct EnumNames<Engine> {
  static constexpr Named<Engine> table[] = {
      {Engine::raycaster, "raycaster"}, {Engine::vdls, "vdls"}, {Engine::reference, "reference"}};
};
template <>
struct EnumNames<Placement> {
  static constexpr Named<Placement> table[] = {{Placement::eye, "eye"},
                                               {Placement::entry, "entry"},
                                               {Placement::entry_exit, "entry_exit"},
                                               {Placement::entry_exit_corner, "entry_exit_corner"}};
};
template <>
struct EnumNames<ClassificationMethod> {
  static constexpr Named<ClassificationMethod> table[] = {
      {ClassificationMethod::post, "post"},
      {ClassificationMethod::preintegrated, "preintegrated"},
      {ClassificationMethod::preintegrated_table, "preintegrated_table"},
      {ClassificationMethod::analytic, "analytic"}};
};
template <>
struct EnumNames<Sampling> {
  static constexpr Named<Sampling> table[] = {{Sampling::uniform, "uniform"},
                                              {Sampling::differential, "differential"},
                                              {Sampling::footprint, "footprint"}};
};
template <>
struct EnumNames<Filter> {
  static constexpr Named<Filter> table[] = {{Filter::linear, "linear"},
                                            {Filter::linear_exact, "linear_exact"},
                                            {Filter::bspline, "bspline"},
                                            {Filter::bc, "bc"}};
};
template <>
struct EnumNames<Gradient> {
  static constexpr Named<Gradient> table[] = {{Gradient::central, "central"}, {Gradient::filter, "filter"}};
};
template <>
struct EnumNames<Shading> {
  static constexpr Named<Shading> table[] = {{Shading::none, "none"}, {Shading::gradient, "gradient"}};
};
template <>
struct EnumNames<BlendMode> {
  static constexpr Named<BlendMode> table[] = {{BlendMode::semi_transparent, "semi_transparent"},
                                               {BlendMode::lookup, "lookup"},
                                               {BlendMode::iso_surface, "iso_surface"},
                                               {BlendMode::maximum, "maximum"},
                                               {BlendMode::minimum, "minimum"},
                                               {BlendMode::mean, "mean"}};
};
template <>
struct EnumNames<Projection> {
  static constexpr Named<Projection> table[] = {{Projection::perspective, "perspective"},
                                                {Projection::parallel, "parallel"}};
};
template <>
struct EnumNames<Domain> {
  static constexpr Named<Domain> table[] = {{Domain::data, "data"}, {Domain::normalized, "normalized"}};
};
template <>
struct EnumNames<LengthUnit> {
  static constexpr Named<LengthUnit> table[] = {{LengthUnit::world, "world"}, {LengthUnit::voxel, "voxel"}};
};
template <>
struct EnumNames<SurfaceMode> {
  static constexpr Named<SurfaceMode> table[] = {
      {SurfaceMode::automatic, "auto"}, {SurfaceMode::on, "on"}, {SurfaceMode::off, "off"}};
};

template <class T>
concept NamedEnum = requires {
  EnumNames<T>::table;
};

/// All values with their names, in the order in which they are offered.
template <NamedEnum T>
constexpr std::span<const Named<T>> names_of() {
  return EnumNames<T>::table;
}

template <NamedEnum T>
constexpr std::string_view name_of(T value) {
  for (const Named<T>& named : EnumNames<T>::table)
    if (named.value == value) return named.name;
  return "";
}

/// Nothing when the name is not known. Names are case-sensitive.
template <NamedEnum T>
constexpr std::optional<T> value_named(std::string_view name) {
  for (const Named<T>& named : EnumNames<T>::table)
    if (named.name == name) return named.value;
  return std::nullopt;
}

/// "both, PEAK_XOR_DVR, PEAK_ONLY, DVR_ONLY", for messages.
template <NamedEnum T>
std::string name_list() {
  std::string list;
  for (const Named<T>& named : EnumNames<T>::table) {
    if (!list.empty()) list += ", ";
    list += named.name;
  }
  return list;
}

}  // namespace crest
