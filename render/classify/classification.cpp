#include "render/classify/classification.h"

namespace crest {

Classification classify(TransferFunction tf, ValueRange field) {
  Classification result;
  result.peaks = find_peaks(tf);
  for (const Peak& peak : shown_peaks(result.peaks))
    if (float(peak.value) > float(field.min) && float(peak.value) <= float(field.max))
      result.surfaces.push_back(peak);
  result.base = base_transfer_function(tf, result.peaks);
  result.tf = std::move(tf);
  return result;
}

}  // namespace crest
