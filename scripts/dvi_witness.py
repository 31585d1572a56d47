#!/usr/bin/env python3
"""Decodes the pins of a board with the TMDS decoder of cocotbext-dvi, and compares the picture with the golden one.

    scripts/setup --boards
    imogene board simulation scenes/cone.toml --mode 160x120 --samples --out out
    target/tools/bin/python scripts/dvi_witness.py out/pins.bin out/golden.rgb 160x120

`pins.bin` has one byte for each bit of the channels: bits 0, 1, 2 are blue, green and red, bit 3 their clock.
`golden.rgb` has red, green and blue of every pixel. What a word means is said by the class TMDS of cocotbext-dvi 0.5.0
(Copyright Dave Keeshan, MIT) alone; that words begin where the clock rises, and that a frame is what stands between two
vertical synchronisations, is said here. Exit code 1: pixels differ. 2: usage.
"""

import importlib.util
import sysconfig
import sys
from pathlib import Path


def decoder():
    """The module of the decoder by its path: its package would load a simulator."""
    path = Path(sysconfig.get_paths()["purelib"]) / "cocotbext" / "dvi" / "tmds.py"
    spec = importlib.util.spec_from_file_location("tmds", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.TMDS()


def meanings():
    """(level, is shown, vsync, hsync) of each word of ten bits."""
    tmds = decoder()
    return [tmds.decode(word) for word in range(1 << 10)]


def words(samples):
    """Blue, green and red words from where the clock channel first rises."""
    begin = next(i for i in range(1, len(samples)) if samples[i] & 8 and not samples[i - 1] & 8)
    for at in range(begin, len(samples) - 9, 10):
        yield [sum((samples[at + i] >> channel & 1) << i for i in range(10)) for channel in range(3)]


def frames(samples):
    """Pixels between vertical synchronisations; the first and the last frame may not be whole."""
    table = meanings()
    frame, synced = bytearray(), None
    for blue, green, red in words(samples):
        level, shown, vsync, _ = table[blue]
        if shown:
            frame += bytes((table[red][0], table[green][0], level))
        elif vsync != synced:
            synced = vsync
            if frame:
                yield bytes(frame)
                frame = bytearray()
    yield bytes(frame)


def main():
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    samples, golden = (Path(name).read_bytes() for name in sys.argv[1:3])
    width, height = map(int, sys.argv[3].split("x"))
    whole = [frame for frame in frames(samples) if len(frame) == 3 * width * height]
    if not whole or len(golden) != 3 * width * height:
        print(f"no whole frame of {width} x {height} pixels")
        return 1
    pixels = range(0, len(golden), 3)
    differing = sum(whole[-1][at : at + 3] != golden[at : at + 3] for at in pixels)
    print(f"{len(whole)} frames of {width} x {height} pixels; in the last {differing} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
