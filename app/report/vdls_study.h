#pragma once

#include <string>
#include <vector>

#include "app/report/studies.h"
#include "presets/json_text.h"
#include "render/measure/image_error.h"
#include "render/studies/vdls/performance.h"

namespace crest {

/// All that the study of view-dependent layer sampling found.
struct VdlsReport {
  std::string command, renderer, made_at;
  glm::ivec2 size{0};

  /// Largest of a pixel, between the engines' pictures.
  struct Difference {
    double same_gradients = 0, gradient_volume = 0;
  };
  /// A volume of the paper's Table 2 and figure 9.
  struct Row {
    std::string id, title;
    glm::ivec3 dims{0};
    double vdls_bytes = 0, raycaster_bytes = 0;  ///< that the device holds
    std::vector<VdlsTiming> timings;             ///< of table_setups()
    Difference difference;
  };
  std::vector<Row> table;
  std::vector<VdlsSeries> series;  ///< figures 5 to 8

  /// A quadtree over a picture, as in figure 6.
  struct Quadtree {
    std::string title, picture;
    std::vector<ScreenNode> nodes;
  };
  std::vector<Quadtree> quadtrees;

  /// A post-shaded filter, as in figure 10.
  struct Filter {
    std::string name;
    Difference difference;
  };
  std::vector<Filter> filters;

  /// A way to render the phantom, as in figure 11.
  struct Quality {
    std::string name, picture, error_picture;
    double samples_per_voxel = 1;
    PixelErrors error;  ///< against the exact integral
  };
  std::string phantom;
  std::vector<Quality> quality;

  struct Picture {
    std::string name;  ///< of the file, below the report's folder
    Image image;
  };
  std::vector<Picture> pictures;
};

Json vdls_json(const VdlsReport& report);

/// "View-dependent layer sampling": writes vdls.json, vdls.html and pictures in images/ into the folder, the
/// page last. VOLUME is a folder of real volumes (vdls_scenes). Throws Error.
void run_vdls_study(const StudyOptions& options);

}  // namespace crest
