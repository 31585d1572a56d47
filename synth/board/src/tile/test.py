"""Whole frames on the pins against the pictures in reference/, and every synchronisation against the mode."""

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, FallingEdge
from PIL import Image

FRAMES = {{ frames }}
WIDTH, HEIGHT = {{ line.active }}, {{ frame.active }}
LINE, FRAME = {{ line.total }}, {{ frame.total }}
HSYNC, VSYNC = {{ line.sync }}, {{ frame.sync }}
LEFT, TOP = {{ line.sync + line.back }}, {{ frame.sync + frame.back }}
# Levels of the pins in a synchronisation, and their places among the outputs.
HSYNC_LEVEL, VSYNC_LEVEL = {{ hsync_level }}, {{ vsync_level }}
HSYNC_PIN, VSYNC_PIN = {{ hsync_pin }}, {{ vsync_pin }}
# Of red, green and blue, the lowest bit first.
COLOURS = {{ colours }}


def colour(pins):
    return bytes(85 * sum((pins >> pin & 1) << bit for bit, pin in enumerate(bits)) for bits in COLOURS)


@cocotb.test()
async def frames_are_the_reference(dut):
    cocotb.start_soon(Clock(dut.clk, {{ picoseconds }}, unit="ps").start())
    dut.ena.value, dut.ui_in.value, dut.uio_in.value, dut.rst_n.value = 1, 0, 0, 0
    await ClockCycles(dut.clk, 10)
    await FallingEdge(dut.clk)
    dut.rst_n.value = 1
    await ClockCycles(dut.clk, 4)

    async def pins():
        await FallingEdge(dut.clk)
        return int(dut.uo_out.value)

    # A frame begins with its vertical synchronisation.
    while (await pins()) >> VSYNC_PIN & 1 != VSYNC_LEVEL:
        pass
    first = int(dut.uo_out.value)
    for number in range(FRAMES):
        picture = bytearray()
        for at in range(LINE * FRAME):
            seen = first if at == number == 0 else await pins()
            row, column = divmod(at, LINE)
            assert (seen >> HSYNC_PIN & 1 == HSYNC_LEVEL) == (column < HSYNC), f"hsync at {column}, {row}"
            assert (seen >> VSYNC_PIN & 1 == VSYNC_LEVEL) == (row < VSYNC), f"vsync at {column}, {row}"
            if TOP <= row < TOP + HEIGHT and LEFT <= column < LEFT + WIDTH:
                picture += colour(seen)
            else:
                assert colour(seen) == bytes(3), f"a colour in the blanking at {column}, {row}"
        golden = Image.open(f"reference/frame{number}.png").convert("RGB")
        assert bytes(picture) == golden.tobytes(), f"frame {number} differs from its reference"
        dut._log.info(f"frame {number} is its reference")
