#include "app/recovery_text.h"

#include <cmath>

#include "presets/error.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

using Seconds = std::chrono::seconds;

constexpr std::string_view format = "crest-recovery";
constexpr int version = 1;

/// The epoch where it says a time that no clock has.
std::chrono::system_clock::time_point time_in(const Json& seconds) {
  using std::chrono::system_clock;
  constexpr auto most = std::chrono::duration_cast<Seconds>(system_clock::duration::max()).count();
  const double said = seconds.get<double>();
  return std::abs(said) < double(most) ? system_clock::time_point(Seconds(std::int64_t(said)))
                                       : system_clock::time_point();
}

}  // namespace

std::string recovery_text(const KeptDocument& kept) {
  const Document& document = kept.document;
  const auto time = std::chrono::duration_cast<Seconds>(kept.time.time_since_epoch()).count();
  Json json = {{"format", format},
               {"version", version},
               {"time", time},
               {"volume", document.volume_source},
               {"preset_path", document.preset_path.string()},
               {"library_name", document.library_name}};
  json["preset"] = parse_json(write_preset(document.preset));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

KeptDocument parse_recovery(std::string_view text, const std::string& source) {
  try {
    const auto json = parse_json(text);
    if (json.at("format") != format || json.at("version") != version)
      throw Error(source + ": it is of another version of Crest");
    KeptDocument kept;
    kept.time = time_in(json.at("time"));
    kept.document.volume_source = json.at("volume").get<std::string>();
    kept.document.preset_path = json.at("preset_path").get<std::string>();
    kept.document.library_name = json.at("library_name").get<std::string>();
    kept.document.preset = parse_preset(json.at("preset").dump(), source);
    return kept;
  } catch (const Json::exception&) {
    throw Error(source + ": it is damaged: a field is missing, or of another kind");
  }
}

}  // namespace crest
