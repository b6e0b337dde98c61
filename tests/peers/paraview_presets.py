"""pvpython paraview_presets.py FOLDER: ParaView imports each FOLDER/*.pv.json, and its functions are those of the preset
beside it, FOLDER/*.preset.json, at 1000 values; also after a rescale to another range and back."""
import glob
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import tf  # noqa: E402
from paraview import servermanager  # noqa: E402
from paraview.simple import GetColorTransferFunction, GetOpacityTransferFunction  # noqa: E402


def farthest(preset, lut, opacity, to_value=lambda v: v):
    """The largest difference in what it may be, and where that is."""
    worst = 0, 0
    for value in tf.test_values(preset):
        expected = tf.evaluate(preset, value)
        color = [0, 0, 0]
        lut.GetClientSideObject().GetColor(to_value(value), color)
        found = color + [opacity.GetClientSideObject().GetValue(to_value(value))]
        off = max(abs(a - b) for a, b in zip(expected, found))
        worst = max(worst, (off / tf.tolerance(preset, value), value))
    return worst


def main(folder):
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
    bad = 0
    files = sorted(glob.glob(os.path.join(folder, "*.pv.json")))
    for number, path in enumerate(files):
        preset = tf.load(path.replace(".pv.json", ".preset.json"))
        name = tf.load(path)[0]["Name"]
        if not presets.ImportPresets(path):
            print("FAILED: ParaView does not import", path)
            bad += 1
            continue
        lut, opacity = GetColorTransferFunction("array%d" % number), GetOpacityTransferFunction("array%d" % number)
        # The preset's own range, as "Use preset range" does
        if not (lut.ApplyPreset(name, False) and opacity.ApplyPreset(name, False)):
            print("FAILED: ParaView does not know", name)
            bad += 1
            continue
        as_is = farthest(preset, lut, opacity)
        low, high = tf.value_range(preset)
        first = opacity.GetClientSideObject().GetRange()
        lut.RescaleTransferFunction(-1000, 3000)
        opacity.RescaleTransferFunction(-1000, 3000)
        place = lambda v: -1000 + 4000 * (v - first[0]) / (first[1] - first[0])
        rescaled = farthest(preset, lut, opacity, place)
        good = as_is[0] <= 1 and rescaled[0] <= 1
        bad += not good
        print("%s %s: off by %.2g of what it may be, at %g; after a rescale by %.2g, at %g" % (
            "ok    " if good else "FAILED", os.path.basename(path), *as_is, *rescaled))
    if not files:
        print("FAILED: no files")
    return bad == 0 and bool(files)


sys.exit(0 if main(sys.argv[1]) else 1)
