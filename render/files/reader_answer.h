#pragma once

#include "presets/json.h"
#include "presets/json_text.h"
#include "render/files/open_choice.h"
#include "render/volume/volume.h"

namespace crest {

// What the reader's program writes to its standard output: JSON objects, one a line, and after the last of
// them as many values, in the machine's bytes, as it tells: floats, or, of a volume, what "stored" says.
//   {"expects": bytes, "seconds": of processor time}   what it sets about, and when it is ended; any number
//   {"read": share}                                    how much of the file it has read, in [0, 1]; at most
//                                                      some hundred, most_told
//   {"error": "..."}                                    then no more; with "choice" it is ChoiceNeeded
//   {"volume": {...}, "values": count, "stored": {"type", "slope", "intercept"}}
//                                                      all but statistics, name and file
//   {"picture": [width, height], "values": count}
//   {"preset": "..."}

/// Lines longer than this are none.
inline constexpr std::size_t longest_answer_line = std::size_t(1) << 24;

/// Told more often how much is read, a reader is not what it should be.
inline constexpr int most_told = 1000;

Json volume_to_json(const Volume& volume);
/// Without values. Throws Error, or an exception of the JSON library, unless it is a volume's.
Volume volume_from_json(const Json& json);

/// How the values behind a volume's line are stored, and mapped.
struct StoredValues {
  ScalarType type = ScalarType::float32;
  LinearMap map;
};
/// Of 8- and 16-bit integers; null of floats.
Json stored_to_json(const Voxels& values);
/// What a volume's line says: floats where it says nothing. Throws as volume_from_json.
StoredValues stored_from_json(const Json& line);

/// Without path and query, which the one who asked knows.
Json choice_to_json(const OpenChoice& choice);
/// Throws as volume_from_json. Raw voxels are not for the reader's program.
OpenChoice choice_from_json(const Json& json);

}  // namespace crest
