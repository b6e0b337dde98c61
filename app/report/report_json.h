#pragma once

#include "app/report/report.h"
#include "presets/json_text.h"

namespace crest {

/// The report as docs/report.schema.json describes it: all that was measured, and what follows from it.
Json report_json(const Report& report);

/// The measured points as a table: a row for each point and exact answer.
std::string report_csv(const Report& report);

}  // namespace crest
