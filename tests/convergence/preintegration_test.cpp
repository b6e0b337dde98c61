#include "tests/convergence/order.h"

namespace crest::testing {
namespace {

using PreintegrationOrder = Order;

Scene preintegrated(TransferFunction tf, Mode mode, ClassificationMethod method,
                    PeakForm form = PeakForm::split) {
  Scene scene = scene_of(make_volume(unit_cube(33), transversal), std::move(tf), mode, form);
  scene.rendering.classification = method;
  scene.rendering.preintegration_bins = 2048;
  if (method == ClassificationMethod::preintegrated_table) scene.rendering.placement = Placement::entry;
  return scene;
}

TEST_F(PreintegrationOrder, IsTwoInTheStep) {
  constexpr double steps[] = {8, 4, 2, 1, 0.5};
  for (const auto& [name, method] :
       {std::pair("step, smooth TF, antiderivatives", ClassificationMethod::preintegrated),
        std::pair("step, smooth TF, pre-integration table", ClassificationMethod::preintegrated_table)}) {
    const Scene scene = preintegrated(smooth_tf(), Mode::dvr_only, method);
    EXPECT_NEAR(order_in_step(name, scene, Answer::integral, steps).order, 2, 0.25);
  }
}

// A jump makes sampling first order; between antiderivatives it costs nothing.
TEST_F(PreintegrationOrder, IsTwoAcrossAJumpToo) {
  constexpr double steps[] = {8, 4, 2, 1, 0.5};
  const auto tf = make_tf(
      {point(-0.3, 0.1, blue), point(0.5, 0.1, blue), point(0.5, 0.7, orange), point(1.3, 0.7, orange)}, 0.6);
  const Scene scene = preintegrated(tf, Mode::dvr_only, ClassificationMethod::preintegrated);
  EXPECT_NEAR(order_in_step("step, TF with a jump, antiderivatives", scene, Answer::integral, steps).order, 2,
              0.3);
}

TEST_F(PreintegrationOrder, IsTwoWithPeaksInTheSplitForm) {
  constexpr double steps[] = {8, 4, 2, 1, 0.5};
  const auto tf = spike_tf(2e-3);
  for (const auto& [name, mode, method] :
       {std::tuple("step, spike, PEAK_XOR_DVR, antiderivatives", Mode::peak_xor_dvr,
                   ClassificationMethod::preintegrated),
        std::tuple("step, spike, PEAK_XOR_DVR, table", Mode::peak_xor_dvr,
                   ClassificationMethod::preintegrated_table)}) {
    const Scene scene = preintegrated(tf, mode, method);
    EXPECT_NEAR(order_in_step(name, scene, answers_of(scene.rendering).front(), steps).order, 2, 0.3);
  }
  // What a spike adds to one segment does not shrink with it, and antiderivatives mix its colour with the
  // haze's
  const Scene body = preintegrated(tf, Mode::both, ClassificationMethod::preintegrated);
  const OrderFit mixed =
      order_in_step("step, spike, both, antiderivatives", body, Answer::integral_and_crossings, steps);
  EXPECT_GT(mixed.order, 1);
  EXPECT_LT(mixed.order, 2);
  const Scene paper =
      preintegrated(tf, Mode::peak_xor_dvr, ClassificationMethod::preintegrated, PeakForm::paper);
  EXPECT_NEAR(order_in_step("step, spike, PEAK_XOR_DVR as in the paper, antiderivatives", paper,
                            Answer::base_and_crossings, steps)
                  .order,
              1, 0.25);
}

}  // namespace
}  // namespace crest::testing
