"""Work-precision curves: what an error costs a method, and the tables of it."""
import math


def time_for(curve, target):
    """ms that a method needs for an RMSE of `target`, and how that is known: "=" interpolated between two of
    its points, on logarithmic scales; "<=" its coarsest point is better already; None, "never" if no point is as good.
    `curve` is of {"rmse", "ms"}, from the coarsest to the finest."""
    points = [(p["rmse"], p["ms"]) for p in curve]
    if points[0][0] <= target:
        cheapest = min(ms for rmse, ms in points if rmse <= target)
        return cheapest, "<="
    for (rmse0, ms0), (rmse1, ms1) in zip(points, points[1:]):
        if rmse1 <= target < rmse0:
            part = math.log(rmse0 / target) / math.log(rmse0 / rmse1)
            return ms0 * (ms1 / ms0) ** part, "="
    return None, "never"


def cheapest(curves, target):
    """(method, ms, how) of the fastest of several methods at `target`; None if none reaches it."""
    found = [(name, *time_for(curve, target)) for name, curve in curves.items()]
    return min((f for f in found if f[1] is not None), key=lambda f: f[1], default=None)


def error_row(name, curve):
    cells = ["%.3g: %.0f (%.1e, %.1f %%)" % (p["step"], p["ms"], p["rmse"], 100 * p["share"]) for p in curve]
    return "| %s | %s |" % (name, " | ".join(cells))


def not_reached(curves):
    """Halving the finest step once more helps a curve that still falls, and not one that has met its floor."""
    falls = [curve[-1]["rmse"] < 0.9 * curve[-2]["rmse"] for curve in curves.values()]
    return "not at its smallest step" if any(falls) else "never reached"


def equal_error(question, target, vtk, crest):
    """What each side needs for the same RMSE, and how many times as long VTK takes."""
    best = {"VTK": cheapest(vtk, target), "Crest": cheapest(crest, target)}
    ratio = None
    if all(best.values()):
        ratio = best["VTK"][1] / best["Crest"][1]
    return {"question": question, "target_rmse": target, **best, "ratio": ratio,
            "otherwise": {"VTK": not_reached(vtk), "Crest": not_reached(crest)}}  # fmt: skip


def equal_error_row(result):
    def told(side):
        best = result[side]
        return "%s%.0f ms, %s" % (best[2].strip("="), best[1], best[0]) if best else result["otherwise"][side]

    ratio = "-"
    if result["ratio"]:
        # a bound on either side makes the ratio one as well
        bounds = {("=", "="): "", ("=", "<="): ">= ", ("<=", "="): "<= ", ("<=", "<="): "about "}
        ratio = bounds[result["VTK"][2], result["Crest"][2]] + "%.1f" % result["ratio"]
    return "| %s | %.1e | %s | %s | %s |" % (
        result["question"], result["target_rmse"], told("VTK"), told("Crest"), ratio)  # fmt: skip
