#pragma once

#include "render/studies/stability/lab.h"
#include "render/studies/stability/scenes.h"

// Invariances: two views that differ by nothing but the words in which they are told have one picture.

namespace crest::stability {

struct View {
  Scene scene;
  Camera camera;
};

/// The gyroid in levels, haze and peaks, all of it in view.
View plain_view(Mode mode);

/// Another way to tell a view.
struct Change {
  std::string name;
  std::function<View(const View&)> apply;
  bool mirrors_picture = false;
};

/// Pixels whose rays so nearly graze a surface that they meet more or fewer when it moves by 1e-4 of the
/// range: there the place of a crossing hangs on the last digit.
std::vector<bool> nearly_grazing(const Lab& lab, const View& view);

/// A row for each tested mode: the largest difference that any of the changes makes, demanded to be at most
/// 1e-5. Left out are nearly grazing pixels, and those where the number of DVR samples is another: a ray of
/// nearly a whole number of steps has one more or less as its length is rounded.
std::vector<Row> rows_of_changes(Lab& lab, const std::string& name, const std::function<View(Mode)>& plain,
                                 const std::vector<Change>& changes);

/// Values v become scale * v + shift, in the field and in the TF. The products and sums must be float32
/// numbers, or the field itself changes.
View with_values(const View& view, double scale, double shift);

}  // namespace crest::stability
