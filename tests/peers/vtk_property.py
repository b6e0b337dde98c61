"""pvpython vtk_property.py MODULE.py PRESET.json [VOLUME.raw N PICTURE.npy]: the property of an exported module is the
preset's function at 1000 values; and with a volume of N^3 floats, what VTK's CPU ray caster makes of it."""
import importlib.util
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import tf  # noqa: E402


def module_from(path):
    spec = importlib.util.spec_from_file_location("exported", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def check_function(exported, preset):
    prop = exported.volume_property()
    worst = 0
    for value in tf.test_values(preset):
        color = prop.GetRGBTransferFunction().GetColor(value)
        found = list(color) + [prop.GetScalarOpacity().GetValue(value)]
        off = max(abs(a - b) for a, b in zip(tf.evaluate(preset, value), found))
        worst = max(worst, off / tf.tolerance(preset, value))
    unit = prop.GetScalarOpacityUnitDistance()
    good = worst <= 1 and unit == preset["transfer_function"]["unit_distance"]
    print("%s the property: off by %.2g of what it may be, unit distance %g" % ("ok    " if good else "FAILED", worst, unit))
    return good


def render(exported, volume, n, picture, camera):
    import vtk
    reader = vtk.vtkImageReader2()
    reader.SetFileName(volume)
    reader.SetFileDimensionality(3)
    reader.SetDataScalarTypeToFloat()
    reader.SetDataByteOrderToLittleEndian()
    reader.SetDataExtent(0, n - 1, 0, n - 1, 0, n - 1)
    reader.Update()
    # The CPU ray caster works on 16-bit integers: it takes the values over their range
    mapper = vtk.vtkFixedPointVolumeRayCastMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    mapper.SetSampleDistance(0.1)
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetImageSampleDistance(1)
    actor = vtk.vtkVolume()
    actor.SetMapper(mapper)
    actor.SetProperty(exported.volume_property())
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0, 0, 0)
    renderer.AddVolume(actor)
    for peak in exported.peak_actors(reader.GetOutputPort()):
        renderer.AddActor(peak)
    view = renderer.GetActiveCamera()
    view.SetPosition(camera["eye"])
    view.SetFocalPoint(camera["target"])
    view.SetViewUp(camera["up"])
    view.SetViewAngle(camera["fov_y_degrees"])
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(160, 160)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferTypeToRGB()
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()


def main(arguments):
    exported, preset = module_from(arguments[0]), tf.load(arguments[1])
    good = check_function(exported, preset)
    if len(arguments) > 2:
        render(exported, arguments[2], int(arguments[3]), arguments[4], preset["camera"])
    return good


sys.exit(0 if main(sys.argv[1:]) else 1)
