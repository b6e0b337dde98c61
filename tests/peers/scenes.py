"""The peers' scenes as jobs for VTK and as volumes and presets for Crest."""
import json
import os

import numpy as np

# VTK stops a ray at an opacity of 254/255, and so does Crest here.
EARLY_TERMINATION = 1 / 255


def read_scene(peer_folder, volume, tf):
    folder = os.path.join(peer_folder, "scenes")
    with open(os.path.join(folder, "volumes.json")) as file:
        scene = dict(json.load(file)[volume], volume=volume, name="%s, %s" % (tf, volume))
    with open(os.path.join(folder, "tf_%s_%s.json" % (tf, volume))) as file:
        scene["points"] = json.load(file)["points"]
    return scene


def write_nrrd(path, values):
    """float32 values, indexed z, y, x; a spacing of 1 from an origin of 0."""
    header = "NRRD0004\ntype: float\ndimension: 3\nsizes: %d %d %d\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n"
    with open(path, "wb") as file:
        file.write((header % values.shape[::-1]).encode() + values.astype("<f4").tobytes())


def preset_of(scene):
    camera = scene["cam"]
    points = [{"value": p["value"], "color": [p["r"], p["g"], p["b"]], "opacity": p["a"]} for p in scene["points"]]
    return {
        "format": "crest-preset", "version": 1, "name": scene["name"],
        "transfer_function": {"domain": "data", "unit_distance": scene["unit"], "unit": "world", "points": points},
        "rendering": {"early_termination": EARLY_TERMINATION},
        "camera": {"eye": camera["eye"], "target": camera["center"], "up": camera["up"],
                   "fov_y_degrees": camera["fovy"]},
    }  # fmt: skip


def peaks_of(scene):
    """The TF's inner points that are higher than both neighbours and narrow: Crest's spikes."""
    points = scene["points"]
    width = 0.01 * (points[-1]["value"] - points[0]["value"])
    triples = zip(points, points[1:], points[2:])
    return [b for a, b, c in triples if b["a"] > max(a["a"], c["a"]) and c["value"] - a["value"] <= width]


def vtk_job(scene, mode, step, size):
    """`bent` is `dvr` with the TF's points moved so that VTK's table lookup, which is off by up to half a
    texel, finds them where they are. `iso` gets a plateau about each peak, so that its table costs nothing."""
    points = scene["points"]
    if mode == "iso":
        points = [dict(p, value=p["value"] + side * 0.02) for p in peaks_of(scene) for side in (-1, 1)]
    return {"volume": scene["spec"], "tf": {"points": points}, "camera": scene["cam"], "size": [size, size],
            "mode": "iso" if mode == "iso" else "dvr", "prewarp": mode == "bent", "sample_distance": step,
            "iso": [p["value"] for p in peaks_of(scene)], "unit_distance": scene["unit"]}  # fmt: skip


def without_correction(job, texels=1024):
    """The same job with the opacity of one step in the TF, texel by texel. VTK leaves texels of at most 1e-4 as
    they are instead of correcting them for the step: at 1/32 voxel these are 32 times too opaque."""
    points = job["tf"]["points"]
    at = [p["value"] for p in points]
    values = np.linspace(at[0], at[-1], texels)
    columns = {c: np.interp(values, at, [p[c] for p in points]) for c in "rgba"}
    columns["a"] = 1 - (1 - columns["a"]) ** (job["sample_distance"] / job["unit_distance"])
    rows = zip(values, *columns.values())
    told = [dict(zip(("value", *"rgba"), map(float, row))) for row in rows]
    return dict(job, tf={"points": told}, unit_distance=job["sample_distance"])
