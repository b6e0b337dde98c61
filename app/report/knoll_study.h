#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/knoll_scenes.h"
#include "app/report/studies.h"
#include "presets/json_text.h"
#include "render/studies/knoll/claims.h"
#include "render/studies/knoll/results.h"

namespace crest {

/// The study with all that its reader is told beyond what was measured.
struct KnollReport {
  std::string command, renderer, made_at;
  glm::ivec2 size{0};
  double seconds = 0;
  KnollResults results;
};

/// Measures all parts, the most informative first. A part that the budget has no time for is among
/// `left_out`. A GL 4.5 context is current. Throws Cancelled, Error.
KnollResults measure_knoll(KnollLab& lab, KnollScenes& scenes, std::optional<double> budget_seconds,
                           const std::function<void(const std::string&)>& tell);

/// One picture of a figure, and what the paper has for it.
struct KnollPanel {
  const char *label, *group, *variant;  ///< of a figure's part; of a ShotGroup; of a Variant
  double paper_fps = 0;
};
struct KnollFigure {
  const char *number, *title, *note;  ///< the note is on what differs from the paper's; may be empty
  std::vector<KnollPanel> panels;
};
/// Figures 3 to 7.
std::vector<KnollFigure> knoll_figures();
bool is_in_figures(std::string_view group, std::string_view variant);
/// Null where it was not measured.
const Shot* find_shot(const KnollResults& results, std::string_view group, std::string_view variant);

/// File names below the report's folder.
std::string knoll_picture_name(const KnollPanel& panel);
std::string knoll_error_picture_name(const KnollPanel& panel);
std::string knoll_preset_name(const KnollScene& scene);

Json knoll_json(const KnollReport& report);
/// All shots: a row each.
std::string knoll_csv(const KnollReport& report);

/// "The paper's results again" (Knoll et al. 2009): writes knoll.json, .csv, .html, the scenes' presets in
/// presets/ and the figures in images/ into the folder, the page last. Throws Error.
void run_knoll_study(const StudyOptions& options);

}  // namespace crest
