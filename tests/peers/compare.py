#!/usr/bin/python3
"""Crest beside VTK's GPU ray caster: time and error against the exact answer, of the same scenes.

    xvfb-run -a /usr/bin/python3 tests/peers/compare.py --peer DIR --crest build/app/crest -o OUT

DIR holds lib_peer.py, vtk_peer.py and scenes/. Needs Debian's python3-vtk9, python3-numpy and xvfb. It takes some
10 minutes at 256x256 and is run by hand. OUT gets result.json, table.md and the pictures.

Frames of both programs are taken in turn: a round has each method at each step once (three frames of one start of
Crest; VTK's process stays open), and times are medians over the rounds. Each method is measured against the answer
that it is after: `integral` (VTK's compositing, Crest's DVR_ONLY), `base+crossings` (PEAK_XOR_DVR), `crossings`
(VTK's isosurfaces, PEAK_ONLY). Both sides stop rays at an opacity of 254/255, which the exact answers do not, and
which VTK cannot turn off: where much is opaque that is a floor under both, so Crest is measured without it as well.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys

import numpy as np

import curves
import pictures
import scenes

VTK_STEPS = [2, 1, 0.5, 0.25, 0.125, 1 / 16, 1 / 32]
CREST_STEPS = [4, 2, 1, 0.5, 0.25, 0.125, 1 / 16]
# name: answer, mode, settings; `preintegrated_table` places its samples from the entry alone
TABLE = ["rendering.classification=preintegrated_table", "rendering.placement=entry",
         "rendering.preintegration_bins=1024"]  # fmt: skip
PRE = ["rendering.classification=preintegrated"]
TO_THE_END = ["rendering.early_termination=0"]
CREST = {
    "DVR_ONLY, post": ("integral", "DVR_ONLY", []),
    "DVR_ONLY, post, no early end": ("integral", "DVR_ONLY", TO_THE_END),
    "DVR_ONLY, preintegrated": ("integral", "DVR_ONLY", PRE),
    "DVR_ONLY, preintegrated_table": ("integral", "DVR_ONLY", TABLE),
    "PEAK_XOR_DVR, post": ("base+crossings", "PEAK_XOR_DVR", []),
    "PEAK_XOR_DVR, preintegrated": ("base+crossings", "PEAK_XOR_DVR", PRE),
    "PEAK_ONLY": ("crossings", "PEAK_ONLY", []),
}
VTK = {"VTK composite": ("integral", "dvr"), "VTK composite, TF bent": ("integral", "bent"),
       "VTK isosurfaces": ("crossings", "iso")}  # fmt: skip
ANSWER_MODES = {"integral": "DVR_ONLY", "base+crossings": "PEAK_XOR_DVR", "crossings": "PEAK_ONLY"}


def file_name(*parts):
    return "_".join("%g" % p if isinstance(p, float | int) else p for p in parts).replace(", ", "_").replace(" ", "_")


class Bench:
    def __init__(self, args, worker):
        self.args, self.worker = args, worker
        self.env = dict(os.environ, LP_NUM_THREADS=str(args.threads))

    def path(self, *parts):
        return os.path.join(self.args.output, file_name(*parts))

    def crest(self, scene, mode, out, *options):
        command = [self.args.crest, "render", self.path(scene["volume"] + ".nrrd"), "--preset",
                   self.path(scene["name"] + ".json"), "--mode", mode, "--size", "{0}x{0}".format(self.args.size),
                   "-o", out, "--json", *options]  # fmt: skip
        done = subprocess.run(command, env=self.env, capture_output=True, text=True)
        if done.returncode:
            sys.exit(" ".join(command) + "\n" + done.stderr)
        return json.loads(done.stdout)

    def crest_frames(self, scene, method, step, first):
        _, mode, settings = CREST[method]
        out = self.path(scene["name"], method, step) + ".exr"
        options = [w for s in settings for w in ("--set", s)] + ["--step", str(step), "--frames", "4"]
        told = self.crest(scene, mode, out, *options)
        if told["renderer"].split(",")[0] not in self.worker.info["GL_RENDERER"]:
            sys.exit("Crest is on %s, VTK on %s" % (told["renderer"], self.worker.info["GL_RENDERER"]))
        return told["frame_ms_all"], pictures.read_exr(out) if first else None

    def vtk_frames(self, scene, method, step, first):
        out = self.path(scene["name"], method, step)
        job = dict(scenes.vtk_job(scene, VTK[method][1], step, self.args.size), frames=3 if step > 0.2 else 1)
        done = self.worker.run(dict(job, out=out) if first else job)
        return [1000 * t for t in done["times"]], np.load(out + ".npy") if first else None

    def exact(self, scene, answer):
        out = self.path(scene["name"], "exact", answer) + ".exr"
        told = self.crest(scene, ANSWER_MODES[answer], out, "--engine", "reference")
        assert told["answer"] == answer, told["answer"]
        return pictures.read_exr(out)

    def curves_of(self, scene, exact):
        """method -> [{step, ms, rmse, share}], from interleaved rounds."""
        plan = [(m, s, self.crest_frames, CREST[m][0]) for m in CREST for s in CREST_STEPS]
        plan += [(m, s, self.vtk_frames, VTK[m][0]) for m in VTK for s in VTK_STEPS]
        if len(scenes.peaks_of(scene)) < 2:
            plan = [p for p in plan if p[3] != "crossings"]
        if not scenes.peaks_of(scene):
            plan = [p for p in plan if p[3] == "integral"]
        plan.sort(key=lambda p: -p[1])  # like beside like: steps that take about as long
        points = {}
        for turn in range(self.args.rounds):
            for method, step, frames, answer in plan:
                if turn and step < 0.1:
                    continue  # these tell where a floor is; one round is enough for that
                ms, picture = frames(scene, method, step, turn == 0)
                point = points.setdefault((method, step), {"step": step, "answer": answer, "ms_all": []})
                point["ms_all"] += ms
                if picture is not None:
                    point.update(pictures.errors(picture, exact[answer]))
                    if method.startswith("VTK comp"):
                        point["beside_surfaces"] = pictures.errors(picture, exact["base+crossings"])
        found = {}
        for (method, _), point in points.items():
            found.setdefault(method, []).append(dict(point, ms=statistics.median(point["ms_all"])))
        return found

    def check_agreement(self, scene, exact):
        """Both programs must mean the same picture, or no error says anything: at a step so small that where the
        samples lie does not show, with the same early end of rays, pixel by pixel."""
        step, size = 1 / 32, self.args.size
        job = scenes.without_correction(scenes.vtk_job(scene, "bent", step, size))
        out = self.path(scene["name"], "agreement")
        self.worker.run(dict(job, frames=0, out=out))
        vtk = np.load(out + ".npy")
        self.crest(scene, "DVR_ONLY", out + ".exr", "--step", str(step))
        crest = pictures.read_exr(out + ".exr")
        told = {"VTK to Crest": pictures.errors(vtk, crest), "Crest to exact": pictures.errors(crest, exact),
                "upside down": pictures.errors(vtk[::-1], crest)["rmse"],
                "left to right": pictures.errors(vtk[:, ::-1], crest)["rmse"],
                "moved by pixels": pictures.shift_between(vtk, crest)}  # fmt: skip
        rmse, mirrored = told["VTK to Crest"]["rmse"], min(told["upside down"], told["left to right"])
        if rmse > 1e-3 or max(map(abs, told["moved by pixels"])) > 0.05:
            sys.exit("VTK and Crest show different pictures: %s" % told)
        if mirrored < 10 * rmse:
            told["mirrored"] = "the scene is too symmetric to tell"
        return told


def equal_errors(found):
    """The questions that both sides answer, at 1/255, a tenth of it, and what VTK has at three of its steps and at
    best. VTK has no mode for `base+crossings`: its compositing stands in, since that is how a surface is asked of
    it. It converges to another picture, so what it has at a step is no target there."""
    composite = {m: c for m, c in found.items() if m in VTK and c[0]["answer"] == "integral"}
    vtk = {"integral": composite,
           "base+crossings": {m: [dict(p, **p["beside_surfaces"]) for p in c] for m, c in composite.items()},
           "crossings": {m: c for m, c in found.items() if m in VTK and c[0]["answer"] == "crossings"}}  # fmt: skip
    results = []
    for answer, theirs in vtk.items():
        ours = {m: c for m, c in found.items() if m in CREST and c[0]["answer"] == answer}
        if not ours or not theirs:
            continue
        targets = {"1/255": 1 / 255, "1/2550": 1 / 2550}
        if answer != "base+crossings":
            plain = next(iter(theirs.values()))
            targets |= {"VTK's at step %g" % p["step"]: p["rmse"] for p in plain if p["step"] in (1, 0.5, 0.125)}
            targets["VTK's best"] = min(p["rmse"] for curve in theirs.values() for p in curve)
        for why, target in targets.items():
            results.append(curves.equal_error("%s, %s" % (answer, why), target, theirs, ours))
    return results


def markdown(scene, agreement, found, equal):
    lines = ["## " + scene["name"], "", "Agreement: " + json.dumps(agreement), "",
             "step: ms (RMSE, pixels off by > 1/255)", ""]  # fmt: skip
    lines += [curves.error_row(m, c) for m, c in found.items()]
    lines += ["", "| answer, target | RMSE | VTK | Crest | VTK's time / Crest's |", "|---|---|---|---|---|"]
    return lines + [curves.equal_error_row(r) for r in equal] + [""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peer", required=True, help="folder of lib_peer.py, vtk_peer.py and scenes/")
    parser.add_argument("--crest", required=True, help="the program")
    parser.add_argument("-o", dest="output", required=True, help="folder of what is written")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="llvmpipe's, of both")
    parser.add_argument("--scenes", default="A-gauss128,B-gauss128,C-gauss128,A-ml128,B-ml128,C-ml128")
    args = parser.parse_args()
    sys.path.insert(0, args.peer)
    import lib_peer
    import vtk_peer

    os.makedirs(args.output, exist_ok=True)
    bench = Bench(args, lib_peer.Worker(args.threads))
    make = {"gauss128": vtk_peer.gauss_noise, "ml128": vtk_peer.marschner_lobb}
    result, lines = {"vtk": bench.worker.info, "size": args.size, "scenes": {}}, []
    for tf, volume in (name.split("-") for name in args.scenes.split(",")):
        scene = scenes.read_scene(args.peer, volume, tf)
        scenes.write_nrrd(bench.path(volume + ".nrrd"), make[volume](128))
        with open(bench.path(scene["name"] + ".json"), "w") as file:
            json.dump(scenes.preset_of(scene), file)
        exact = {answer: bench.exact(scene, answer) for answer in ANSWER_MODES}
        agreement = bench.check_agreement(scene, exact["integral"]) if tf == "A" else {}
        found = bench.curves_of(scene, exact)
        equal = equal_errors(found)
        result["scenes"][scene["name"]] = {"agreement": agreement, "curves": found, "equal_error": equal}
        lines += markdown(scene, agreement, found, equal)
        print("\n".join(markdown(scene, agreement, found, equal)), flush=True)
        with open(bench.path("result.json"), "w") as file:
            json.dump(result, file, indent=1)
        with open(bench.path("table.md"), "w") as file:
            file.write("\n".join(lines))
    bench.worker.close()


if __name__ == "__main__":
    main()
