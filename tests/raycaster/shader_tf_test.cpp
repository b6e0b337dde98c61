// The TF as the exact march reads it.
#include "render/resources/shader_tf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/classify/classification.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

double width_of(const ShaderTfPiece& piece) {
  return (double(piece.high_value.x) + double(piece.high_value.y)) -
         (double(piece.low_value.x) + double(piece.low_value.y));
}

// No piece goes from clear to opaque, which would take many panels of Simpson's rule.
TEST(ShaderTf, IsCutWhereItIsNearlyOpaque) {
  const auto depth = [](double opacity) { return -std::log(std::max(1 - opacity, least_transmittance)); };
  for (const auto& [from, to] : {std::pair(0.0, 1.0), {1.0, 0.3}, {0.0, 0.95}, {0.999, 1.0}, {0.0, 0.5}}) {
    double width = 0;
    for (const ShaderTfPiece& piece :
         shader_tf(make_tf({point(0, from), point(1, to)}), {}, {0, 1}, 1).pieces) {
      const double low = piece.low.a, high = double(piece.low.a) + double(piece.rise.a);
      EXPECT_LT(std::abs(depth(high) - depth(low)), std::log(1024.0)) << from << " " << to;
      if (piece.low_value.x > -1e38F && piece.high_value.x < 1e38F) width += width_of(piece);
    }
    EXPECT_NEAR(width, 1, 1e-6);
  }
}

// Pieces follow each other without a gap, and the levels between are met at both of their ends.
TEST(ShaderTf, PiecesJoin) {
  const TransferFunction tf = make_tf({point(-2, 0.1), point(0.5, 0.1), point(0.5 + 1e-9, 1),
                                       point(0.5 + 2e-9, 0.1), point(1, 0), point(1, 0.7)});
  const Classification classes = classify(tf, {-3, 3});
  const ShaderTf cut = shader_tf(tf, classes.surfaces, {-3, 3}, 1);
  ASSERT_GT(cut.pieces.size(), tf.points.size());
  double spike = 0;
  for (std::size_t i = 0; i + 1 < cut.pieces.size(); ++i) {
    const ShaderTfPiece &below = cut.pieces[i], &above = cut.pieces[i + 1];
    EXPECT_EQ(below.high_value, above.low_value) << i;
    if (below.low_value.x == 0.5F && below.high_value.x == 0.5F) spike += width_of(below);
  }
  EXPECT_NEAR(spike, 2e-9, 1e-14);
  int surfaces = 0;
  for (const ShaderTfPiece& piece : cut.pieces) surfaces += int(piece.past_surface - piece.first_surface);
  EXPECT_EQ(surfaces, int(classes.surfaces.size()));
}

TEST(ShaderTf, WithoutPointsIsOnePieceThatIsClear) {
  const ShaderTf none = shader_tf({}, {}, {0, 1}, 1);
  ASSERT_EQ(none.pieces.size(), 1u);
  EXPECT_EQ(none.pieces[0].low.a, 0);
  EXPECT_EQ(none.pieces[0].rise.a, 0);
}

}  // namespace
}  // namespace crest::testing
