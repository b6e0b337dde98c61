// Transfer functions of other programs.
#include <random>

#include "presets/exchange/exporters.h"
#include "presets/exchange/importers.h"
#include "presets/preset_file.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"
#include "tests/presets/export_inputs.h"
#include "tests/presets/random_tf.h"

namespace crest::fuzz {

void read_imported(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string_view name = input.substr(0, end), content = input.substr(std::min(end + 1, input.size()));
  for (const Imported& one : import_presets(content, name)) {
    const TransferFunction& tf = one.preset.transfer_function;
    require(!tf.points.empty(), "what is imported has points");
    require(parse_preset(write_preset(one.preset), "again") == one.preset, "what is imported can be kept");
    for (const TfParts part : {TfParts::both, TfParts::colors, TfParts::opacities})
      combined(spike(), tf, part, is_over_unit_range(tf));
    for_volume(one, {100, 200, 50});
  }
}

std::vector<std::string> import_seeds() {
  std::vector<std::string> seeds = {
      R"(a.xml
<ColorMaps><ColorMap name="one" space="RGB"><Point x="-1" o="0" r="0" g="0" b="1"/>
<Point x="2" o="0.5" r="1" g="1" b="0"/><NaN r="1" g="0" b="0"/></ColorMap><ColorMap name="two" space="Diverging">
<Point x="0" o="1" r="0.2" g="0.3" b="0.8"/><Point x="1" o="1" r="0.7" g="0" b="0.1"/></ColorMap></ColorMaps>)",
      R"(presets.xml
<MRML><VolumeProperty id="1" name="CT-Bone" interpolation="1" shade="1" gradientOpacity="4 0 1 255 1"
colorTransfer="8 0 0.1 0.2 0.3 100 1 1 1" scalarOpacity="4 0 0 100 0.7"/></MRML>)",
      R"(a.itf
<?xml version="1.0" encoding="UTF-8" ?><InviwoWorkspace version="3"><type content="0" />
<Points><Point><pos content="0.25" /><rgba x="1" y="0" z="0" w="0.5" /></Point>
<Point><pos content="0.75" /><rgba x="0" y="0" z="1" w="1" /></Point></Points></InviwoWorkspace>)",
      R"(a.json
[{"Name": "a", "ColorSpace": "Lab", "RGBPoints": [0, 0, 0, 0.5, 1, 1, 0, 0], "Points": [0, 0, 0.5, 0, 1, 1, 0.5, 0.3]},
{"Name": "b", "ColorSpace": "HSV", "RGBPoints": [0, 0, 0, 0.5, 1, 1, 0, 0], "Creator": "x", "DefaultMap": true}])",
      R"(a.vp.json
{"volumeProperties": [{"components": [{"scalarOpacity": {"points": [{"x": 0, "y": 0, "midpoint": 0.3, "sharpness": 0.5},
{"x": 1, "y": 1}]}, "rgbTransferFunction": {"points": [{"x": 0, "color": [0, 0, 1]}]}, "scalarOpacityUnitDistance": 2}]}]})",
      "a.1dt\n3\n0 0 0 0\n1 0 0 0.5\n1 1 1 1\n",
      "a.csv\nvalue,red,green,blue,opacity,extinction\n0,0,0,0,0.5,0.1\n1,1,1,1,1,1\n"};
  std::mt19937 random(5);
  for (const Exporter& exporter : exporters()) {
    ExportInput input = input_of(random_tf(random, 9));
    input.rows = 8;
    const std::string content = exporter.write(input).files.at(0).content;
    const std::string name = "file" + std::string(exporter.extension);
    if (find_importer(content, name)) seeds.push_back(name + "\n" + content);
  }
  return seeds;
}

}  // namespace crest::fuzz
