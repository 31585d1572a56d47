"""What the structure files of this folder hold, counted by gemmi 0.7 (pip install gemmi), independently of the importer.

Bonds: pairs of atoms of the first model, all alternates, found by trying every pair; radii are those of B. Cordero et al., Dalton Trans. 2008, 2832.
"""

import math
import sys
from pathlib import Path

import gemmi

COVALENT = {"H": 0.31, "C": 0.76, "N": 0.71, "O": 0.66, "P": 1.07, "S": 1.05, "Zn": 1.22, "Se": 1.20, "Na": 1.66}


def bonds(atoms):
    count = 0
    for k, (element, place, altloc) in enumerate(atoms):
        for other, at, alternate in atoms[:k]:
            hydrogens = element == "H" and other == "H"
            apart = "\0" not in (altloc, alternate) and altloc != alternate
            distance = math.dist(place, at)
            most = COVALENT[element] + COVALENT[other] + 0.45
            count += not hydrogens and not apart and 0.4 <= distance <= most
    return count


def places(model):
    return [cra.atom.pos for cra in model.all()]


def mean(points):
    points = [p.tolist() for p in points]
    return ["%.3f" % (sum(p[k] for p in points) / len(points)) for k in range(3)]


print("# pip install gemmi; python import/tests/data/expected.py")
print("file\tatoms\tmodels\tfirst\tchains\tbonds\tassembly\tmean")
for path in sorted(Path(__file__).parent.iterdir()):
    if not any(end in path.name for end in (".cif", ".pdb")) or ".bcif" in path.name:
        continue
    structure = gemmi.read_structure(str(path))
    structure.setup_entities()
    first = structure[0]
    atoms = [(cra.atom.element.name.replace("D", "H"), cra.atom.pos.tolist(), cra.atom.altloc) for cra in first.all()]
    assembly, middle = "-", "-"
    if structure.assemblies:
        made = gemmi.make_assembly(structure.assemblies[0], first, gemmi.HowToNameCopiedChain.AddNumber)
        assembly, middle = str(len(places(made))), " ".join(mean(places(made)))
    row = [
        path.name,
        sum(len(places(model)) for model in structure),
        " ".join(str(model.num) for model in structure),
        len(atoms),
        " ".join(sorted({chain.name for chain in first})),
        bonds(atoms),
        assembly,
        middle,
    ]
    print(*row, sep="\t")
