"""Presets of Crest's as plain Python, for the tests that compare with other programs: random ones, and their function."""
import json
import random


def random_preset(rng):
    """Steps, spikes down to 1e-6 of the range, points that are alone; a range of any size."""
    width = 10 ** rng.uniform(-3, 4)
    low = rng.choice([0, -0.5 * width, 3 * width])
    points = []

    def add(place, opacity):
        points.append({"value": low + place * width, "opacity": opacity, "color": [rng.random() for _ in range(3)]})

    for _ in range(rng.choice([2, 6, 30])):
        place, opacity = rng.random(), rng.random()
        kind = rng.randrange(4)
        if kind == 0:
            half = 10 ** rng.uniform(-6, -2)
            add(place - half, 0)
            add(place, opacity)
            add(place + half, 0)
        elif kind == 1:
            add(place, opacity)
            add(place, rng.random())
        else:
            add(place, opacity)
    points.sort(key=lambda p: p["value"])
    return {"format": "crest-preset", "version": 1, "name": "random %d" % rng.randrange(10**6),
            "transfer_function": {"unit_distance": 10 ** rng.uniform(-2, 2), "points": points}}


def save(preset, path):
    with open(path, "w") as file:
        json.dump(preset, file)


def load(path):
    with open(path) as file:
        return json.load(file)


def value_range(preset):
    points = preset["transfer_function"]["points"]
    return points[0]["value"], points[-1]["value"]


def evaluate(preset, value):
    """[r, g, b, opacity]; at a value that points share the last one holds."""
    points = preset["transfer_function"]["points"]
    rgba = lambda p: list(p["color"]) + [p["opacity"]]
    if value < points[0]["value"]:
        return rgba(points[0])
    for before, after in zip(points, points[1:]):
        if before["value"] <= value < after["value"]:
            s = (value - before["value"]) / (after["value"] - before["value"])
            return [a + (b - a) * s for a, b in zip(rgba(before), rgba(after))]
    return rgba(points[-1])


def tolerance(preset, value):
    """What the function may be off by there, since a step's points are drawn apart by some 2e-6 of the size of their
    values: that, along the line that leads through the value."""
    points = preset["transfer_function"]["points"]
    low, high = value_range(preset)
    size = max(high - low, abs(low), abs(high))
    for before, after in zip(points, points[1:]):
        if before["value"] <= value < after["value"]:
            a, b = list(before["color"]) + [before["opacity"]], list(after["color"]) + [after["opacity"]]
            rise = max(abs(x - y) for x, y in zip(a, b))
            return 1e-9 + 3e-6 * size * rise / (after["value"] - before["value"])
    return 1e-9


def near_point(preset, value, distance):
    return any(abs(p["value"] - value) <= distance for p in preset["transfer_function"]["points"])


def test_values(preset, count=1000):
    """Values at which the function is known although points may have been drawn apart by some 1e-5 of their range: not
    beside a point, but in the midst between two, and at the points' own sides."""
    low, high = value_range(preset)
    width = high - low
    size = max(width, abs(low), abs(high))
    rng = random.Random(1)
    points = [p["value"] for p in preset["transfer_function"]["points"]]
    candidates = [rng.uniform(low - 0.1 * width, high + 0.1 * width) for _ in range(20 * count)]
    candidates += [v + s * 2e-5 * size for v in points for s in (-1, 1)]
    values = [v for v in candidates if not near_point(preset, v, 1e-5 * size)]
    return values[-count:]
