#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/measure/measurement.h"
#include "render/studies/knoll/sampling.h"
#include "render/studies/knoll/table_builds.h"

namespace crest {

/// A scene of Table 1, with its shots: "post" first, then the others by their variants' ids.
struct Table1Row {
  PaperRow paper;
  ShotGroup shots;
};

/// All that the study of Knoll et al. 2009 measured.
struct KnollResults {
  std::vector<KnollScene> scenes;  ///< without those that nothing was measured of
  std::vector<Table1Row> table1;
  std::vector<SamplingRow> table2;
  std::optional<ShotGroup> bins;  ///< of the tables, in a scene with many close peaks: see bins_variants()
  std::vector<TableBuild> builds;
  std::vector<LeftOut> left_out;
};

}  // namespace crest
