"""Makes Verilog of a bitstream of a Gowin whose memories are tables: DEVICE PART BITSTREAM CONSTRAINTS VERILOG.

Apycula tells what each tile does. This adds what its unpacker leaves out: taps of global clocks, long wires of columns,
the table of an adder, the divider of the fast clock. Only what leads to a DVI channel is written.
"""
import importlib.resources
import re
import sys
import warnings

from apycula import attrids, chipdb, codegen, gowin_unpack as unpack

# Output ports of the cells that may be written, but for flip-flops.
OUTPUTS = {"LUT4": ["F"], "MUX2": ["O"], "GOWIN_ADDER": ["SUM", "COUT"], "RAM16SDP4": ["DO"]}


def outputs(cell):
    return ["Q"] if cell.typ.startswith("DFF") else OUTPUTS.get(cell.typ, [])


def bits(wires):
    return wires if isinstance(wires, list) else [wires]


class Part:
    """The cells of a bitstream, and what drives each wire."""

    def __init__(self, device, bitstream):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with importlib.resources.path("apycula", f"{device}.msgpack.xz") as path:
                self.db = chipdb.load_chipdb(path)
        # The unpacker is a program: its functions read these.
        unpack._device, unpack._pinout = device, self.db.pinout[device][unpack._packages[device]]
        self.bitmap = unpack.read_bitstream(bitstream)[0]
        self.tiles = chipdb.tile_bitmap(self.db, self.bitmap)
        self.module, self.tables = codegen.Module(), {}
        banks = set(self.db.bank_tiles.values())
        # Banks come first: standards of pins are theirs.
        for place in sorted(self.tiles, key=lambda place: place not in banks):
            self.decode(place, place not in banks)
        self.cells = self.module.primitives
        for name in self.tables:
            self.adder(name)
        self.roots = self.joined()
        self.drivers = {self.named(to): by for to, by in self.module.assigns}
        self.long_wires()
        self.makers = {}
        for name, cell in self.cells.items():
            if cell.typ == "RAM16SDP4":
                # Apycula has a fifth output, which there is not.
                cell.portmap["DO"] = cell.portmap["DO"][-4:]
            for port in outputs(cell):
                self.makers.update((self.named(wire), name) for wire in bits(cell.portmap[port]))

    def decode(self, place, is_plain):
        (row, column), tile = place, self.tiles[place]
        bels, pips, clock_pips = unpack.parse_tile_(self.db, row, column, tile, self.tiles, noiostd=not is_plain)
        for index in [bel[3:] for bel in bels if bel.startswith("ALU")]:
            zeros = bels.get(f"LUT{index}", ())
            self.tables[row + 1, column + 1, int(index)] = sum(1 << k for k in range(16) if k not in zeros)
        unpack.removeLUTs(bels)
        unpack.ram16_remove_bels(bels)
        for tap, source in clock_pips.items():
            spine = re.fullmatch(r"SPINE(\d+)", source)
            if spine and re.fullmatch(r"GT\d0", tap):
                # The four spines of a group have one bit: it is the column of the tap that chooses.
                clock_pips[tap] = f"SPINE{int(spine[1]) // 4 * 4 + 3 - column % 4}"
        unpack.tile2verilog(row, column, bels, pips, clock_pips, self.module, codegen.Constraints(), self.db)

    def adder(self, place):
        """Sum and carry are by the table of the cell, in whatever mode it is."""
        row, column, index = place
        tile = f"R{row}C{column}"
        cell = self.cells[f"{tile}_ALU_{index}"] = codegen.Primitive("GOWIN_ADDER", f"{tile}_ALU_{index}")
        cell.params["INIT"] = f"16'h{self.tables[place]:04x}"
        cell.portmap.update({port: f"{tile}_{port}{index}" for port in "ABCD"})
        carry = f"{tile}_CIN{index + 1}" if index < 5 else f"R{row}C{column + 1}_CIN0"
        cell.portmap.update(CIN=f"{tile}_CIN{index}", SUM=f"{tile}_F{index}", COUT=carry)

    def joined(self):
        """One name for all wires of a node, and for what two neighbours call a wire between them."""
        roots = {}
        for _, wires in self.db.nodes.values():
            names = [f"R{row + 1}C{column + 1}_{wire}" for row, column, wire in sorted(wires)]
            roots.update((name, names[0]) for name in names)
        for row in range(self.db.rows):
            for column in range(self.db.cols):
                ends = [(row, column + 1, "N1", "SN"), (row + 2, column + 1, "S1", "SN"),
                        (row + 1, column, "W1", "EW"), (row + 1, column + 2, "E1", "EW")]
                for at_row, at_column, wire, name in ends:
                    for k in "12":
                        end = chipdb.wire2global(at_row, at_column, self.db, f"{wire}{k}1")
                        roots[end] = f"R{row + 1}C{column + 1}_{name}{k}0"
        return roots

    def long_wires(self):
        """A column wire, driven at one end, goes to a row where there is a tap, and there to the tiles beside it."""
        for (_, column, index), segment in self.db.segments.items():
            ends = [f"R{segment[f'{end}_row'] + 1}C{column + 1}_{segment[f'{end}_wire']}" for end in ("top", "bottom")]
            driven = [end for end in ends if end in self.drivers]
            tap = "LBO0" if index < 4 else "LBO1"
            for row in range(segment["min_y"] + 1, segment["max_y"] + 2):
                if driven and f"R{row}C{column + 1}_{tap}" in self.drivers:
                    for beside in range(segment["min_x"] + 1, segment["max_x"] + 2):
                        self.drivers[f"R{row}C{beside}_LB{index}1"] = driven[0]

    def named(self, wire):
        wire = self.roots.get(wire, wire)
        spine = re.fullmatch(r"R\d+C\d+_(SPINE\d+)", wire)
        return spine[1] if spine else wire

    def source(self, wire):
        wire = self.named(wire)
        while wire in self.drivers:
            wire = self.named(self.drivers[wire])
        return {"VCC": "1'b1", "VSS": "1'b0"}.get(wire, wire)

    def settings(self, kind, names):
        """Names and values of all settings of a kind of cell."""
        for place, tile in chipdb.tile_bitmap(self.db, self.bitmap, empty=True).items():
            table = self.db.shortval.get(self.db[place].ttyp, {}).get(kind)
            if table:
                yield from unpack.parse_attrvals(tile, self.db.rev_logicinfo(kind), table, names, kind).items()

    def division(self):
        """What the divider of the fast clock divides by."""
        found = [value for key, value in self.settings("HCLK", attrids.hclk_attrids) if key.endswith("_DIV")]
        names = {number: name for name, number in attrids.hclk_attrvals.items()}
        return names[one(found, "dividers of a fast clock")]

    def pll(self):
        """Parameters of the PLL."""
        found = list(self.settings("PLL", attrids.pll_attrids))

        def setting(name):
            return one([value for key, value in found if key == name], f"PLLs with {name}")

        divider, feedback, output = map(setting, ("IDIV", "FDIV", "ODIV"))
        return f".IDIV_SEL({divider - 1}), .FBDIV_SEL({feedback - 1}), .ODIV_SEL({output})"

    def pad(self, site):
        """The tile of a pad, and its letter."""
        side, number, letter = re.fullmatch(r"IO([TBLR])(\d+)([AB])", site).groups()
        row = {"T": 1, "B": self.db.rows}.get(side, number)
        column = {"L": 1, "R": self.db.cols}.get(side, number)
        return f"R{row}C{column}", letter


class Writer:
    """Cells, from what is asked for backwards."""

    def __init__(self, part, clock):
        self.part, self.clock = part, clock
        self.wires, self.left, self.seen, self.lines = {clock}, [], set(), []

    def read(self, wire):
        source = self.part.source(wire)
        maker = self.part.makers.get(source)
        if maker and maker not in self.seen:
            self.seen.add(maker)
            self.left.append(maker)
        if not maker and re.fullmatch(r"R\d+C\d+_F\d", source):
            # No bit of the bitstream stands for a table of ones.
            return "1'b1"
        if not maker and source != self.clock and not re.fullmatch(r"1'b[01]|R\d+C\d+_CIN\d", source):
            sys.exit(f"nothing drives {source}")
        if not source.startswith("1'b"):
            self.wires.add(source)
        return source

    def made(self, wire):
        self.wires.add(self.part.named(wire))
        return self.part.named(wire)

    def cell(self, name):
        cell, ports = self.part.cells[name], []
        for port, wires in cell.portmap.items():
            through = self.made if port in outputs(cell) else self.read
            ports.append(f".{port}({{{', '.join(map(through, bits(wires)))}}})")
        values = ", ".join(f".{key}({value})" for key, value in cell.params.items())
        self.lines.append(f"{cell.typ} {f'#({values}) ' if values else ''}cell_{name} ({', '.join(ports)});")

    def text(self, ports):
        while self.left:
            self.cell(self.left.pop())
        wires = [f"wire {wire};" for wire in sorted(self.wires)]
        body = "".join(f"    {line}\n" for line in ["wire fast_clock;"] + wires + self.lines)
        return f"module board_top (\n    input  wire clock,\n    output wire {', '.join(ports)}\n);\n{body}endmodule\n"


def one(found, what):
    if len(found) != 1:
        sys.exit(f"the bitstream has {len(found)} {what}, not one")
    return found[0]


def main():
    device, number, bitstream, constraints, verilog = sys.argv[1:]
    part = Part(device, bitstream)
    series, package = re.fullmatch(r"(GW\w+)-[LU][VX]\d+([A-Z]+\d+P?)C\d/I\d", number).groups()
    sites = part.db.pinout[f"{series}-{device.split('-')[1]}"][package.replace("QN", "QFN")]
    with open(constraints) as file:
        pins = re.findall(r'IO_LOC "(channel_\d)" (\d+);', file.read())
    serialisers = [cell for cell in part.cells.values() if cell.typ == "OSER10"]
    clock = one(list({part.source(cell.portmap["PCLK"]) for cell in serialisers}), "clocks of words")
    writer = Writer(part, clock)
    writer.lines += [
        f"rPLL #({part.pll()}) pll (.CLKIN(clock), .CLKOUT(fast_clock));",
        f'CLKDIV #(.DIV_MODE("{part.division()}")) divider (.HCLKIN(fast_clock), .CLKOUT({clock}));',
    ]
    for port, pin in pins:
        tile, letter = part.pad(sites[pin][0])
        pad = [cell for name, cell in part.cells.items() if re.fullmatch(f"{tile}_[ET]LVDS_\\w+_{letter}", name)]
        serialiser = part.cells.get(f"{tile}_OSER10_{letter}")
        if not pad or not serialiser or part.source(pad[0].portmap["I"]) != part.source(serialiser.portmap["Q"]):
            sys.exit(f"no serialiser leads to pin {pin}")
        inputs = ["RESET"] + [f"D{k}" for k in range(10)]
        inputs = ", ".join(f".{name}({writer.read(serialiser.portmap[name])})" for name in inputs)
        writer.lines.append(f"OSER10 out_{port} (.FCLK(fast_clock), .PCLK({clock}), {inputs}, .Q({port}));")
    with open(verilog, "w") as file:
        file.write(writer.text([port for port, _ in pins]))


main()
