#pragma once

#include "tests/changed_shaders.h"

namespace crest::bench {

/// A loop over the samples of DVR that only reads the volume: what the machine can do.
inline ChangedShaders fetch_loop() {
  return {"raycaster.frag",
          "    vec4 material = classify(dvr_field(at(ray, t)));\n"
          "    COUNT_DVR_SAMPLE;\n"
          "    composite(material.rgb * DVR_LIGHT(t), opacity_of(material.a * size_at(s, i)));\n",
          "    collected += vec4(dvr_field(at(ray, t)));\n"};
}

}  // namespace crest::bench
