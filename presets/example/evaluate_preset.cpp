// evaluate_preset PRESET VALUE...: what a preset makes of values, and its peaks.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "presets/peaks.h"
#include "presets/preset_file.h"

int main(int argc, char** argv) try {
  const crest::TransferFunction tf = crest::load_preset(argc > 1 ? argv[1] : "dirac-shell").transfer_function;
  for (int i = 2; i < argc; ++i) {
    const auto [color, opacity] = crest::evaluate(tf, std::atof(argv[i]));
    std::printf("%s: %g %g %g, opacity %g\n", argv[i], color.r, color.g, color.b, opacity);
  }
  for (const crest::Peak& peak : crest::find_peaks(tf))
    std::printf("peak at %g, opacity %g\n", peak.value, peak.opacity);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
