#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "presets/preset.h"

namespace crest {

inline constexpr int view_count = 4;
/// The modes of the 2x2 grid when nobody chose others, left to right, top to bottom.
inline constexpr std::array<Mode, view_count> view_modes{Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr,
                                                         Mode::both};

/// What a view shows when nobody does anything: the picture as the settings have it; or the exact one, where
/// there is one for the settings, or how far each of its pixels may be off, at most.
enum class ShownPicture { as_set, exact, error_bound };

/// A preset that is shown beside the document's: a snapshot of it, one from a file, or from the library.
struct OtherPreset {
  std::string name;  ///< for people
  Preset preset;
};

/// What a view shows of the volume.
struct ViewContent {
  Mode mode = Mode::dvr_only;
  std::optional<Engine> engine;              ///< without one that of its preset
  std::optional<ShownPicture> picture;       ///< without one what all views show
  std::shared_ptr<const OtherPreset> other;  ///< null: the document's preset
  bool operator==(const ViewContent&) const = default;
};

/// The four modes of the document's preset.
std::array<ViewContent, view_count> contents_of_modes();

/// The settings of the preset that it shows, in its mode and by its engine.
Rendering rendering_of(const ViewContent& content, const Preset& documents);

/// That preset, with these settings.
Preset preset_of(const ViewContent& content, const Preset& documents);

/// "Surfaces + volume, VDLS, exact, snapshot 2": what tells it from the document's preset in the same mode.
std::string text_of(const ViewContent& content);

}  // namespace crest
