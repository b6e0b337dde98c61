// Every variant of the two programs that a scene can ask for compiles and links.
#include "render/vdls/variants.h"
#include "presets/names.h"
#include "render/gl/program.h"
#include "tests/pairwise.h"
#include "tests/vdls/fixture.h"

namespace crest::testing {
namespace {

using VdlsVariants = VdlsTest;

struct Variant {
  Rendering rendering;
  bool whole_values = false, counts = false;
};

Parameter<Variant> flag(const char* name, const std::function<void(Variant&, bool)>& set) {
  return {name, {{"no", [=](Variant& v) { set(v, false); }}, {"yes", [=](Variant& v) { set(v, true); }}}};
}

Value<Variant> gradient(const char* name, Shading shading, bool volume) {
  return {name, [=](Variant& v) {
            v.rendering.shading = shading;
            v.rendering.vdls.gradient_volume = volume;
          }};
}

Value<Variant> layers(int count) {
  return {std::to_string(count), [=](Variant& v) { v.rendering.vdls.layers_per_pass = count; }};
}

Pairwise<Variant> variants() {
  Parameter<Variant> blend_modes{"illumination", {}};
  for (const auto& [blend_mode, name] : names_of<BlendMode>())
    blend_modes.values.push_back(
        {std::string(name), [=](Variant& v) { v.rendering.blend_mode = blend_mode; }});
  return {{blend_modes,
           {"gradient",
            {gradient("none", Shading::none, true), gradient("central", Shading::gradient, false),
             gradient("volume", Shading::gradient, true)}},
           {"layers", {layers(1), layers(16)}},
           flag("early test", [](Variant& v, bool in) { v.rendering.vdls.early_test = in; }),
           flag("back to front", [](Variant& v, bool in) { v.rendering.vdls.back_to_front = in; }),
           flag("whole values", [](Variant& v, bool in) { v.whole_values = in; }),
           flag("counts", [](Variant& v, bool in) { v.counts = in; })},
          {{"illumination", {"maximum", "minimum", "mean"}, "gradient", {"none"}}}};
}

TEST_F(VdlsVariants, EveryPairOfOptionsThatGoTogetherCompiles) {
  const auto table = variants();
  const std::vector<Choice> choices = table.choices();
  for (const auto& pair : table.valid_pairs())
    EXPECT_TRUE(std::ranges::any_of(choices, [&](const Choice& c) { return table.holds(c, pair); }));
  for (const Choice& choice : choices) {
    const auto [rendering, whole_values, counts] = table.subject(choice);
    EXPECT_NO_THROW(gl::build_fullscreen_program("vdls_setup.frag", setup_defines(rendering, counts)))
        << table.describe(choice);
    EXPECT_NO_THROW(
        gl::build_program("vdls_proxy.vert", "vdls_layers.frag", layers_defines(rendering, whole_values)))
        << table.describe(choice);
  }
}

}  // namespace
}  // namespace crest::testing
