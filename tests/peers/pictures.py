"""Pictures as numpy arrays (rows, columns, premultiplied RGBA), and the errors between them."""
import struct
import zlib

import numpy as np

QUANTUM = 1 / 255


def _unfilter(data, size):
    """Undoes OpenEXR's ZIP filter: a running difference, and the bytes parted into even and odd ones."""
    if len(data) == size:
        return data  # what does not shrink is stored as it is
    delta = np.frombuffer(zlib.decompress(data), np.uint8).astype(np.uint32)
    delta[1:] += 256 - 128
    halves = np.cumsum(delta, dtype=np.uint32).astype(np.uint8)
    out = np.empty(size, np.uint8)
    half = (size + 1) // 2
    out[0::2], out[1::2] = halves[:half], halves[half:]
    return out.tobytes()


def read_exr(path):
    """A scanline OpenEXR file of 32-bit float channels A, B, G, R; without compression, ZIPS or ZIP."""
    data = open(path, "rb").read()
    at, header = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)[0], data[at:].split(b"\0", 2)[1], 0
        at += len(name) + len(kind) + 2
        (rest,) = struct.unpack_from("<i", data, at)
        header[name.decode()] = data[at + 4 : at + 4 + rest]
        at += 4 + rest
    at += 1
    names = [c[: c.index(b"\0")] for c in _channels(header["channels"])]
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines_a_block = {0: 1, 2: 1, 3: 16}[header["compression"][0]]
    picture = np.zeros((height, len(names), width), np.float32)
    blocks = -(-height // lines_a_block)
    for offset in struct.unpack_from("<%dQ" % blocks, data, at):
        y, length = struct.unpack_from("<ii", data, offset)
        lines = min(lines_a_block, height - (y - y0))
        raw = _unfilter(data[offset + 8 : offset + 8 + length], lines * len(names) * width * 4)
        picture[y - y0 : y - y0 + lines] = np.frombuffer(raw, "<f4").reshape(lines, len(names), width)
    return np.stack([picture[:, names.index(c)] for c in (b"R", b"G", b"B", b"A")], axis=-1)


def _channels(data):
    at = 0
    while data[at]:
        end = data.index(b"\0", at) + 17
        if struct.unpack_from("<i", data, end - 16)[0] != 2:
            raise ValueError("the channels are not 32-bit float")
        yield data[at:end]
        at = end


def errors(picture, exact):
    """RMSE and the share of pixels off by more than 1/255, over the pixels that either shows."""
    shown = (picture[..., 3] > 0) | (exact[..., 3] > 0)
    off = np.abs(picture.astype(float) - exact)[shown]
    return {"rmse": float(np.sqrt((off**2).mean())), "share": float((off.max(axis=1) > QUANTUM).mean())}


def shift_between(picture, exact):
    """By how many pixels the picture lies beside the exact one, (across, down): the least of a parabola
    through the squared differences at -1, 0, 1."""
    shifts = []
    for axis in (1, 0):
        before, here, after = (
            ((np.roll(picture.astype(float), by, axis) - exact) ** 2).mean() for by in (-1, 0, 1)
        )
        shifts.append(float((after - before) / (2 * (before - 2 * here + after))))
    return shifts
