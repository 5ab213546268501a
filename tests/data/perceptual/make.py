#!/usr/bin/env python3
"""Values of ST-LPIPS and LPIPS, worked out apart from Effigy in f64 with NumPy, into values.json beside this file.

    python3 make.py FOLDER [PICTURES]

FOLDER holds alex_shift_tolerant.pth, vgg_shift_tolerant.pth, lpips_alex.pth and lpips_vgg.pth, as
tools/fetch_perceptual.sh puts them there. LPIPS's values are with random weights: torchvision's are not fetched.
PICTURES may hold ex_ref.png, ex_p0.png and ex_p1.png of github.com/abhijay9/ShiftTolerant-LPIPS (imgs/): then the
published values are compared as well. Nothing of them is written.
"""
import collections
import json
import pickle
import struct
import sys
from pathlib import Path

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

# What each slice does, in order: a convolution (name, padding, and the stride where it is not 1), "relu", a maximum
# (window), "blur", "half" (every second row and column).
ALEX = [
    [("net.slice1.0", 2), "blur", "relu"],
    [3, "blur", ("net.slice2.5", 2), "relu"],
    [3, "blur", ("net.slice3.9", 1), "relu"],
    [("net.slice4.11", 1), "relu"],
    [("net.slice5.13", 1), "relu"],
]
VGG = [
    [("net.slice1.0", 1), "relu", ("net.slice1.2", 1), "relu"],
    [2, "blur", ("net.slice2.6", 1), "relu", ("net.slice2.8", 1), "relu"],
    [2, "blur", ("net.slice3.12", 1), "relu", ("net.slice3.14", 1), "relu", ("net.slice3.16", 1), "relu"],
    [2, "blur", ("net.slice4.20", 1), "relu", ("net.slice4.22", 1), "relu", ("net.slice4.24", 1), "relu"],
    [2, "blur", ("net.slice5.28", 1), "relu", ("net.slice5.30", 1), "relu", ("net.slice5.32", 1), "relu"],
]
LPIPS_ALEX = [
    [("features.0", 2, 4), "relu"],
    [3, "half", ("features.3", 2), "relu"],
    [3, "half", ("features.6", 1), "relu"],
    [("features.8", 1), "relu"],
    [("features.10", 1), "relu"],
]
LPIPS_VGG = [
    [("features.0", 1), "relu", ("features.2", 1), "relu"],
    [2, "half", ("features.5", 1), "relu", ("features.7", 1), "relu"],
    [2, "half", ("features.10", 1), "relu", ("features.12", 1), "relu", ("features.14", 1), "relu"],
    [2, "half", ("features.17", 1), "relu", ("features.19", 1), "relu", ("features.21", 1), "relu"],
    [2, "half", ("features.24", 1), "relu", ("features.26", 1), "relu", ("features.28", 1), "relu"],
]
NETWORKS = {"alex": ALEX, "vgg": VGG, "lpips-alex": LPIPS_ALEX, "lpips-vgg": LPIPS_VGG}
SHIFT = np.array([-0.030, -0.088, -0.188], "f4").astype("f8").reshape(3, 1, 1)
SCALE = np.array([0.458, 0.448, 0.450], "f4").astype("f8").reshape(3, 1, 1)


class Reader(pickle.Unpickler):
    """A state dictionary without PyTorch: tensors become (storage's key, start, shape)."""

    def __init__(self, file):
        super().__init__(file)
        self.order = {}

    def find_class(self, module, name):
        if (module, name) == ("collections", "OrderedDict"):
            return collections.OrderedDict
        if (module, name) == ("torch._utils", "_rebuild_tensor_v2"):
            return lambda storage, start, shape, stride, *_: (storage, start, tuple(shape))
        if (module, name) == ("torch", "FloatStorage"):
            return "f32"
        raise ValueError(f"{module}.{name}")

    def persistent_load(self, ident):
        return ident[2]


def read(path):
    with open(path, "rb") as file:
        for _ in range(3):
            pickle.load(file)
        tensors = Reader(file).load()
        keys = pickle.load(file)
        storages = {}
        for key in keys:
            (count,) = struct.unpack("<q", file.read(8))
            storages[key] = np.frombuffer(file.read(4 * count), "<f4")
        assert not file.read(1)
    flat = {}
    for name, (key, start, shape) in tensors.items():
        size = int(np.prod(shape))
        flat[name] = storages[key][start : start + size].reshape(shape)
    return flat


def hashed(value):
    """The finaliser of SplitMix64."""
    with np.errstate(over="ignore"):
        z = np.asarray(value, np.uint64) + np.uint64(0x9E3779B97F4A7C15)
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return z ^ (z >> np.uint64(31))


def uniform(seed, stream, count):
    """The first numbers of effigy_core's Random, 0 to 1."""
    start = hashed(np.uint64(seed) ^ hashed(stream))
    with np.errstate(over="ignore"):
        steps = np.arange(1, count + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        bits = hashed(start + steps)
    return (bits >> np.uint64(11)).astype(np.float64) / 2.0**53


def shapes(network):
    """Of every convolution, in order: name, (out, in, window, window)."""
    found, channels = [], 3
    is_alex = network.endswith("alex")
    widths = [64, 192, 384, 256, 256] if is_alex else [64, 128, 256, 512, 512]
    for index, steps in enumerate(NETWORKS[network]):
        for step in steps:
            if isinstance(step, tuple):
                window = {0: 11, 1: 5}.get(index, 3) if is_alex else 3
                found.append((step[0], (widths[index], channels, window, window)))
                channels = widths[index]
    return found, widths


def made(network, seed):
    """The weights of Perceptual::random: a stream for each tensor, in f32."""
    convolutions, widths = shapes(network)
    weights = {}
    for index, (name, shape) in enumerate(convolutions):
        fan = shape[1] * shape[2] * shape[3]
        numbers = uniform(seed, 2 * index, shape[0] * fan)
        weights[name + ".weight"] = ((2 * numbers - 1) * np.sqrt(6 / fan)).astype("f4").reshape(shape)
        weights[name + ".bias"] = (0.2 * uniform(seed, 2 * index + 1, shape[0]) - 0.1).astype("f4")
    for layer, width in enumerate(widths):
        weights[f"lin{layer}.model.1.weight"] = uniform(seed, 1000 + layer, width).astype("f4")
    return weights


def picture(kind, width, height):
    """Stripes, blocks and noise in whole numbers of 0 to 255."""
    c, y, x = np.meshgrid(np.arange(3), np.arange(height), np.arange(width), indexing="ij")
    noise = (hashed((x + 1000 * y + 1000000 * c + 7000000 * kind).astype(np.uint64)) % np.uint64(32)).astype(int)
    wave = lambda t: np.abs(t % 64 - 32) * 7
    if kind == 0:
        levels = np.minimum(wave(3 * x + 5 * y + 20 * c), 223) + noise
    else:
        levels = np.minimum(wave(4 * x + 3 * y + 33 * c + 7) // 2 + 64 * ((x // 8 + y // 8) % 2), 223) + noise
    return (levels.astype("f4") / np.float32(255)).astype(np.float64)


def direction(width, height):
    """A direction of whole numbers of -127 to 127, over 127."""
    c, y, x = np.meshgrid(np.arange(3), np.arange(height), np.arange(width), indexing="ij")
    levels = (hashed((x + 1000 * y + 1000000 * c + 99000000).astype(np.uint64)) % np.uint64(255)).astype(int)
    return (levels - 127) / 127


class Forward:
    """Features and their derivative along a direction."""

    def __init__(self, network, weights):
        self.slices = NETWORKS[network]
        self.weights = {name: value.astype(np.float64) for name, value in weights.items()}

    def features(self, image, along):
        value, slope = (2 * image - 1 - SHIFT) / SCALE, 2 * along / SCALE
        taps = []
        for steps in self.slices:
            for step in steps:
                value, slope = self.step(step, value, slope)
            taps.append((value, slope))
        return taps

    def step(self, step, value, slope):
        if step == "relu":
            return np.maximum(value, 0), np.where(value > 0, slope, 0)
        if step == "blur":
            return blurred(value), blurred(slope)
        if step == "half":
            return value[:, ::2, ::2], slope[:, ::2, ::2]
        if isinstance(step, int):
            windows = lambda a: sliding_window_view(a, (step, step), (1, 2)).reshape(
                a.shape[0], a.shape[1] - step + 1, a.shape[2] - step + 1, -1
            )
            seen = windows(value)
            best = seen.argmax(-1)[..., None]
            take = lambda a: np.take_along_axis(a, best, -1)[..., 0]
            return take(seen), take(windows(slope))
        name, pad, stride = (*step, 1)[:3]
        weight = self.weights[name + ".weight"]
        bias = self.weights[name + ".bias"].reshape(-1, 1, 1)
        apply = lambda a: np.tensordot(
            weight,
            sliding_window_view(np.pad(a, ((0, 0), (pad, pad), (pad, pad))), weight.shape[2:], (1, 2))[
                :, ::stride, ::stride
            ],
            ((1, 2, 3), (0, 3, 4)),
        )
        return apply(value) + bias, apply(slope)

    def compare(self, image, along, target):
        """Distances of the layers, and their derivatives along a direction."""
        values, slopes = [], []
        ours, theirs = self.features(image, along), self.features(target, np.zeros_like(target))
        for layer, ((a, da), (b, _)) in enumerate(zip(ours, theirs)):
            head = self.weights[f"lin{layer}.model.1.weight"].reshape(-1, 1, 1)
            norm = np.sqrt((a * a).sum(0))
            slope_of_norm = np.where(norm > 0, (a * da).sum(0) / np.where(norm > 0, norm, 1), 0)
            unit = a / (norm + 1e-10)
            slope_of_unit = da / (norm + 1e-10) - a * slope_of_norm / (norm + 1e-10) ** 2
            other = b / (np.sqrt((b * b).sum(0)) + 1e-10)
            values.append(float((head * (unit - other) ** 2).sum(0).mean()))
            slopes.append(float((head * 2 * (unit - other) * slope_of_unit).sum(0).mean()))
        return values, slopes


def blurred(a):
    padded = np.pad(a, ((0, 0), (2, 2), (2, 2)), "reflect")
    window = np.outer([1, 2, 1], [1, 2, 1]) / 16
    return (sliding_window_view(padded, (3, 3), (1, 2))[:, ::2, ::2] * window).sum((3, 4))


def rows(network, name, forward, sizes):
    for size in sizes:
        image, target = picture(0, *size), picture(1, *size)
        for kind, along in [("towards", target - image), ("noise", direction(*size))]:
            values, slopes = forward.compare(image, along, target)
            yield {
                "network": network,
                "weights": name,
                "size": size,
                "direction": kind,
                "layers": values,
                "value": sum(values),
                "slope": sum(slopes),
            }


def main():
    folder = Path(sys.argv[1])
    found = []
    sums = {}
    for network in ["lpips-alex", "lpips-vgg"]:
        heads = read(folder / f"{network.replace('-', '_')}.pth")
        sums[network] = float(sum(np.abs(value.astype(np.float64)).sum() for value in heads.values()))
        print(network, "sum of |w| of the heads", sums[network], {name: value.shape for name, value in heads.items()})
    for network in ["alex", "vgg"]:
        smallest = {"alex": 21, "vgg": 18}[network]
        weights = read(folder / f"{network}_shift_tolerant.pth")
        sums[network] = float(sum(np.abs(value.astype(np.float64)).sum() for value in weights.values()))
        blurs = [value for name, value in weights.items() if name.endswith(".filt")]
        assert all((blur == np.outer([1, 2, 1], [1, 2, 1]) / 16).all() for blur in blurs)
        print(network, "sum of |w|", sums[network], "numbers", sum(value.size for value in weights.values()))
        if "-v" in sys.argv:
            for name, value in weights.items():
                print(name, value.shape)
        trained = Forward(network, weights)
        found += rows(network, "file", trained, [[32, 32], [47, 38], [smallest, smallest]])
        found += rows(network, "random 5", Forward(network, made(network, 5)), [[32, 32], [33, 24]])
        if len(sys.argv) > 2 and not sys.argv[2].startswith("-"):
            published(network, trained, Path(sys.argv[2]))
    for network in ["lpips-alex", "lpips-vgg"]:
        found += rows(network, "random 5", Forward(network, made(network, 5)), [[32, 32], [47, 38]])
    text = json.dumps({"sums": sums, "rows": found}, indent=1)
    (Path(__file__).parent / "values.json").write_text(text + "\n")


def published(network, forward, pictures):
    from PIL import Image

    load = lambda name: np.asarray(Image.open(pictures / name).convert("RGB"), np.float64).transpose(2, 0, 1) / 255
    target = load("ex_ref.png")
    for name in ["ex_p0.png", "ex_p1.png"]:
        image = load(name)
        values, slopes = forward.compare(image, target - image, target)
        print(network, name, "value %.9f" % sum(values), "layers", np.round(values, 6), "slope %.4f" % sum(slopes))


if __name__ == "__main__":
    main()
