"""Writes the machine parts of machine/: `python3 machine_parts.py FOLDER`, with cadquery 2.8.0 (OpenCASCADE 7.9.3).

26 parts of 10 to 200 mm whose round edges are tori, spheres and cylinders. Every run writes the same bytes. For each
part it prints what OpenCASCADE sees when it reads the file back: solids, faces by kind of surface, the bounding box;
faces.json beside the parts has the same. Tests count on it.

Only the saddle of `branch` (a rolling ball between two cylinders) is a B-spline; all other faces are planes,
cylinders, cones, spheres and tori.
"""

import json
import math
import pathlib
import sys

import cadquery as cq
from OCP.Bnd import Bnd_Box
from OCP.BRepBndLib import BRepBndLib
from OCP.STEPControl import STEPControl_Reader

from step_output import assembly, solid

Vector, Workplane = cq.Vector, cq.Workplane


def cylinder(radius, foot, axis, height):
    return cq.Solid.makeCylinder(radius, height, Vector(*foot), Vector(*axis))


def ball(radius, centre):
    return cq.Solid.makeSphere(radius, Vector(*centre), angleDegrees1=-90, angleDegrees2=90)


def tube(radius, start, middle, end, normal):
    """A round bar bent along an arc from `start` over `middle` to `end`; `normal` is along its start."""
    arc = cq.Workplane(obj=cq.Edge.makeThreePointArc(Vector(*start), Vector(*middle), Vector(*end)))
    disc = cq.Workplane(cq.Plane(start, normal=normal)).circle(radius)
    return disc.sweep(cq.Workplane(obj=cq.Wire.assembleEdges([arc.val()]))).val()


def turned(outline):
    """An outline turned about the z axis.

    (radius, height) is a corner, (radius, height, r, h) the end of an arc about (r, h).
    """
    x, y = outline[0]
    work = Workplane("XY").moveTo(x, y)
    for corner in outline[1:]:
        if len(corner) == 2:
            work = work.lineTo(*corner)
        else:
            to, centre = Vector(*corner[:2]), Vector(*corner[2:])
            middle = centre + ((Vector(x, y) - centre) + (to - centre)).normalized() * (to - centre).Length
            work = work.threePointArc((middle.x, middle.y), corner[:2])
        x, y = corner[:2]
    return work.close().revolve(360, (0, 0, 0), (0, 1, 0)).rotate((0, 0, 0), (1, 0, 0), 90).val()


def around(n, radius, phase=0):
    angles = [math.radians(phase + 360 * k / n) for k in range(n)]
    return [(radius * math.cos(a), radius * math.sin(a)) for a in angles]


def angle_bracket():
    """Two legs with a fillet in the corner, rounded upper corners and four holes."""
    body = Workplane("XZ").polyline([(0, 0), (60, 0), (60, 6), (6, 6), (6, 50), (0, 50)]).close().extrude(40)
    body = body.edges("|Y").edges(cq.NearestToPointSelector((6, -20, 6))).fillet(5)
    body = body.edges("|X").edges(">Z").fillet(10).edges("|Z").edges(">X").fillet(8)
    for y in (-12, -28):
        body = body.cut(Workplane(obj=cylinder(4, (45, y, -1), (0, 0, 1), 10)))
        body = body.cut(Workplane(obj=cylinder(4, (-1, y, 38), (1, 0, 0), 10)))
    return body.val()


def neck_flange():
    """A flange with a fillet of 5 at its neck, a rounded rim and eight holes."""
    body = turned([(25, 0), (80, 0), (80, 12), (77, 15, 77, 12), (40, 15), (35, 20, 40, 20), (35, 45), (25, 45)])
    for x, y in around(8, 62, 22.5):
        body = body.cut(cylinder(6, (x, y, -1), (0, 0, 1), 20))
    return body


def pipe_elbow():
    """A bend of 90 degrees with straight ends and a flange at one of them."""
    s = 50 * math.sqrt(0.5)
    bend = lambda r: tube(r, (0, 0, 0), (50 - s, 0, s), (50, 0, 50), (0, 0, 1))
    outside = bend(20).fuse(cylinder(20, (0, 0, 0), (0, 0, -1), 30), cylinder(20, (50, 0, 50), (1, 0, 0), 20),
                            cylinder(35, (0, 0, -30), (0, 0, 1), 8))
    inside = bend(15).fuse(cylinder(15, (0, 0, 0), (0, 0, -1), 31), cylinder(15, (50, 0, 50), (1, 0, 0), 21))
    return outside.cut(inside).clean()


def ring_groove():
    """A cover with a half-round groove for an O-ring in its face and one around its spigot."""
    body = cylinder(45, (0, 0, 0), (0, 0, 1), 12).fuse(cylinder(28, (0, 0, 12), (0, 0, 1), 14)).clean()
    body = body.cut(cq.Solid.makeTorus(36, 2.5, Vector(0, 0, 12), Vector(0, 0, 1)))
    return body.cut(cq.Solid.makeTorus(28, 2, Vector(0, 0, 19), Vector(0, 0, 1)))


def stepped_shaft():
    """Four diameters, a fillet at each shoulder, a chamfer at each end."""
    return turned([(0, 0), (9, 0), (10, 1), (10, 28), (12, 30, 12, 28), (15, 30), (15, 67), (18, 70, 18, 67), (22, 70), (22, 110),
                   (14, 110), (12, 112, 14, 112), (12, 148), (10, 150), (0, 150)])


def ball_knob():
    """A ball on a conical neck, a rounded foot and a hole for a thread."""
    body = ball(18, (0, 0, 30)).fuse(cq.Solid.makeCone(13, 8, 18, Vector(0, 0, 0), Vector(0, 0, 1))).clean()
    body = Workplane(obj=body).faces("<Z").edges().fillet(2).val()
    return body.cut(cylinder(4, (0, 0, -1), (0, 0, 1), 20)).cut(cq.Solid.makeCone(4, 0, 3, Vector(0, 0, 19), Vector(0, 0, 1)))


def bearing_housing():
    """A foot with rounded corners, a body rounded on top, a bore with a wider seat and two slots."""
    foot = Workplane("XY").box(120, 40, 14, centered=(True, True, False)).edges("|Z").fillet(10)
    body = Workplane("XZ").moveTo(-30, 0).lineTo(30, 0).lineTo(30, 50).threePointArc((0, 80), (-30, 50)).close().extrude(15, both=True)
    body = foot.union(body).cut(Workplane(obj=cylinder(16, (0, -30, 50), (0, 1, 0), 60)))
    body = body.cut(Workplane(obj=cylinder(22, (0, -16, 50), (0, 1, 0), 22)))
    return body.cut(Workplane("XY").pushPoints([(-46, 0), (46, 0)]).slot2D(16, 9).extrude(20)).clean().val()


def lever():
    """Round ends of 18 and 10, sides tangent to both, bosses and two bores."""
    far, big, small = 90, 18, 10
    c = (big - small) / far
    s = math.sqrt(1 - c * c)
    body = (Workplane("XY").moveTo(big * c, big * s).lineTo(far + small * c, small * s)
            .threePointArc((far + small, 0), (far + small * c, -small * s)).lineTo(big * c, -big * s)
            .threePointArc((-big, 0), (big * c, big * s)).close().extrude(8).val())
    body = body.fuse(cylinder(14, (0, 0, 0), (0, 0, 1), 22), cylinder(8, (far, 0, 0), (0, 0, 1), 14)).clean()
    return body.cut(cylinder(8, (0, 0, -1), (0, 0, 1), 30)).cut(cylinder(4, (far, 0, -1), (0, 0, 1), 30))


def tray():
    """A box with rounded upright edges, and a pocket whose corners and floor edges are rounded."""
    body = Workplane("XY").box(80, 50, 25, centered=(True, True, False)).edges("|Z").fillet(8)
    pocket = Workplane("XY").workplane(offset=5).box(70, 40, 30, centered=(True, True, False)).edges("|Z").fillet(7)
    return body.cut(pocket.faces("<Z").edges().fillet(3)).val()


def rounded_box():
    """All edges rounded: cylinders, and eighths of spheres at the corners."""
    return Workplane("XY").box(40, 30, 20).edges().fillet(4).val()


def cup():
    """A beaker with a rounded foot inside and outside and a round rim."""
    return turned([(0, 0), (22, 0), (30, 8, 22, 8), (30, 58), (28.5, 59.5, 28.5, 58), (27, 58, 28.5, 58), (27, 8), (22, 3, 22, 8), (0, 3)])


def pulley():
    """A rope pulley: a round groove, a rim with rounded edges, a hub, a bore with a keyway and six holes."""
    body = turned([(0, 4), (44, 4), (44, 0), (58, 0), (60, 2, 58, 2), (60, 4), (52, 12, 60, 12), (60, 20, 60, 12), (60, 22), (58, 24, 58, 22),
                   (44, 24), (44, 20), (20, 20), (18, 22, 20, 22), (18, 28), (0, 28)])
    body = body.cut(cylinder(10, (0, 0, -1), (0, 0, 1), 40)).cut(cq.Solid.makeBox(6, 13, 40, Vector(-3, 0, -1)))
    for x, y in around(6, 31):
        body = body.cut(cylinder(6, (x, y, -1), (0, 0, 1), 40))
    return body


def hook():
    """A shank, a quarter and a half of a ring the other way, and a ball at the end."""
    s = math.sqrt(0.5)
    quarter = tube(6, (0, 0, 0), (20 - 20 * s, 0, -20 * s), (20, 0, -20), (0, 0, -1))
    half = tube(6, (20, 0, -20), (50, 0, -50), (20, 0, -80), (1, 0, 0))
    last = tube(6, (20, 0, -80), (20 - 30 * s, 0, -50 - 30 * s), (-10, 0, -50), (-1, 0, 0))
    shank = cylinder(6, (0, 0, 0), (0, 0, 1), 40)
    return shank.fuse(quarter, half, last, ball(8, (-10, 0, -50))).clean()


def cross_drilled_pin():
    """A pin with rounded ends and two holes across, at a right angle to each other."""
    body = Workplane(obj=cylinder(10, (0, 0, 0), (0, 0, 1), 80)).edges("%CIRCLE").fillet(3).val()
    return body.cut(cylinder(3, (-20, 0, 20), (1, 0, 0), 40)).cut(cylinder(5, (0, -20, 55), (0, 1, 0), 40))


def pipe_tee():
    """Two pipes that meet at a right angle, the branch thinner, with collars."""
    outside = cylinder(24, (-60, 0, 0), (1, 0, 0), 120).fuse(cylinder(18, (0, 0, 0), (0, 0, 1), 60))
    outside = outside.fuse(cylinder(30, (-60, 0, 0), (1, 0, 0), 10), cylinder(30, (50, 0, 0), (1, 0, 0), 10), cylinder(25, (0, 0, 50), (0, 0, 1), 10))
    inside = cylinder(20, (-61, 0, 0), (1, 0, 0), 122).fuse(cylinder(14, (0, 0, 0), (0, 0, 1), 61))
    return outside.cut(inside).clean()


def counterbore_plate():
    """Counterbores at the corners, countersinks between them, rounded corners and upper edges."""
    plate = Workplane("XY").box(100, 60, 12, centered=(True, True, False)).edges("|Z").fillet(9).faces(">Z").edges().fillet(2)
    plate = plate.faces(">Z").workplane(origin=(0, 0, 0)).pushPoints([(x, y) for x in (-38, 38) for y in (-18, 18)]).cboreHole(7, 12, 6)
    return plate.faces(">Z").workplane(origin=(0, 0, 0)).pushPoints([(0, -18), (0, 18), (0, 0)]).cskHole(6, 12, 90).val()


def chamfered_block():
    """Every edge of the block chamfered, and both ends of its holes."""
    block = Workplane("XY").box(50, 40, 30).edges().chamfer(2).val()
    for x, radius in ((-12, 6), (12, 4)):
        block = block.cut(cylinder(radius, (x, 0, -20), (0, 0, 1), 40))
        for z, up in ((15, -1), (-15, 1)):
            block = block.cut(cq.Solid.makeCone(radius + 1.5, radius, 1.5, Vector(x, 0, z), Vector(0, 0, up)))
    return block


def eyebolt():
    """A ring on a shank, with a collar between and a chamfer at the end."""
    body = cq.Solid.makeTorus(20, 5, Vector(0, 0, 28), Vector(0, 1, 0)).fuse(cylinder(6, (0, 0, -40), (0, 0, 1), 46))
    body = body.fuse(cylinder(11, (0, 0, 0), (0, 0, 1), 5)).clean()
    return Workplane(obj=body).faces("<Z").edges().chamfer(1.5).val()


def handwheel():
    """A ring, a hub and three spokes."""
    body = cq.Solid.makeTorus(85, 9, Vector(0, 0, 0), Vector(0, 0, 1)).fuse(cylinder(18, (0, 0, -14), (0, 0, 1), 28))
    for x, y in around(3, 1, 90):
        body = body.fuse(cylinder(6, (0, 0, 0), (x, y, 0), 85))
    return body.cut(cylinder(8, (0, 0, -20), (0, 0, 1), 40)).clean()


def spacer_ring():
    """A ring whose four edges are rounded, each by another radius."""
    return turned([(19.5, 0), (29, 0), (30, 1, 29, 1), (30, 7), (27, 10, 27, 7), (20, 10), (18, 8, 20, 8), (18, 1.5), (19.5, 0, 19.5, 1.5)])


def clevis():
    """A fork with round ends, a round root, a bore through both tines and a round shank with a fillet."""
    side = Workplane("XZ").moveTo(-14, 0).lineTo(14, 0).lineTo(14, 45).threePointArc((0, 59), (-14, 45)).close().extrude(15, both=True)
    body = side.cut(Workplane("YZ").moveTo(-7, 60).lineTo(-7, 24).threePointArc((0, 17), (7, 24)).lineTo(7, 60).close().extrude(20, both=True))
    body = body.cut(Workplane(obj=cylinder(6, (0, -20, 45), (0, 1, 0), 40))).union(Workplane(obj=cylinder(9, (0, 0, -35), (0, 0, 1), 36)))
    ring = [e for e in body.edges("%CIRCLE").vals() if abs(e.Center().z) < 1e-6 and abs(e.radius() - 9) < 1e-6]
    return body.newObject(ring).fillet(3).val()


def ball_stud():
    """A ball, a conical neck with fillets, a flange with rounded edges and a shank."""
    body = ball(10, (0, 0, 34)).fuse(cq.Solid.makeCone(9, 5, 22, Vector(0, 0, 8), Vector(0, 0, 1)),
                                     cylinder(16, (0, 0, 0), (0, 0, 1), 8), cylinder(8, (0, 0, -30), (0, 0, 1), 30)).clean()
    work = Workplane(obj=body)
    rings = lambda z, r: [e for e in work.edges("%CIRCLE").vals() if abs(e.Center().z - z) < 1e-6 and abs(e.radius() - r) < 1e-6]
    body = body.fillet(1.5, rings(8, 16) + rings(0, 16) + rings(8, 9))
    work = Workplane(obj=body)
    return body.fillet(2, rings(0, 8)).chamfer(1, None, rings(-30, 8))


def gas_bottle():
    """A torispherical dome, a flat foot with a round edge, a neck with a fillet."""
    crown, knuckle, radius = 70, 15, 50
    # The crown's centre is on the axis; the knuckle touches it and the wall.
    lean = math.asin((radius - knuckle) / (crown - knuckle))
    low = 120 - (crown - knuckle) * math.cos(lean)
    touch = (crown * math.sin(lean), low + crown * math.cos(lean))
    neck, fillet = 12, 6
    across = neck + fillet
    above = math.sqrt((crown + fillet) ** 2 - across**2)
    foot = crown / (crown + fillet)
    body = turned([(0, 0), (42, 0), (50, 8, 42, 8), (50, 120), (*touch, radius - knuckle, 120), (foot * across, low + foot * above, 0, low),
                   (neck, low + above, across, low + above), (neck, 165), (0, 165)])
    return body.cut(cylinder(7, (0, 0, 110), (0, 0, 1), 60))


def branch():
    """A round boss across a thicker bar with a rolling-ball fillet between them: its saddle is a B-spline."""
    body = cylinder(20, (-40, 0, 0), (1, 0, 0), 80).fuse(cylinder(10, (0, 0, 0), (0, 0, 1), 40)).clean()
    seam = [e for e in Workplane(obj=body).edges().vals() if e.geomType() == "BSPLINE"]
    return body.fillet(4, seam)


def u_bolt():
    """A bar bent by half a turn, with a plate across its legs and pointed ends."""
    bow = tube(5, (-25, 0, 0), (0, 0, 25), (25, 0, 0), (0, 0, 1))
    legs = [cylinder(5, (x, 0, -50), (0, 0, 1), 50) for x in (-25, 25)]
    ends = [cq.Solid.makeCone(2.5, 5, 5, Vector(x, 0, -55), Vector(0, 0, 1)) for x in (-25, 25)]
    plate = Workplane("XY").box(70, 20, 4).edges("|Z").fillet(6).translate((0, 0, -30)).val()
    return bow.fuse(*legs, *ends, plate).clean()


def mirrored_pair():
    """A handed clamp, its mirror image beside it, and both once more, turned; an assembly."""
    clamp = Workplane("XY").box(40, 24, 10, centered=(False, False, False)).edges("|Z and >X").fillet(6).faces(">Z").edges(">Y").fillet(3)
    clamp = clamp.cut(Workplane(obj=cylinder(4, (30, 10, -1), (0, 0, 1), 20))).cut(Workplane(obj=ball(5, (10, 8, 10))))
    image = clamp.mirror("YZ")
    parts = cq.Assembly(name="mirrored-pair")
    turn = lambda x, y, z: cq.Location(Vector(x, y, z), Vector(1, 0, 0), 180)
    for name, part, place in (("clamp", clamp, cq.Location(Vector(3, 0, 0))), ("image", image, cq.Location(Vector(-3, 0, 0))),
                              ("clamp turned", clamp, turn(3, 24, 30)), ("image turned", image, turn(-3, 24, 30))):
        parts.add(part, name=name, loc=place)
    return parts


PARTS = [angle_bracket, neck_flange, pipe_elbow, ring_groove, stepped_shaft, ball_knob, bearing_housing, lever, tray, rounded_box, cup,
         pulley, hook, cross_drilled_pin, pipe_tee, counterbore_plate, chamfered_block, eyebolt, handwheel, spacer_ring, clevis,
         ball_stud, gas_bottle, branch, u_bolt, mirrored_pair]


def seen(path):
    """What OpenCASCADE sees in a file: solids, faces by kind of surface, the box in millimetres."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    shape = cq.Shape.cast(reader.OneShape())
    assert shape.isValid(), path
    kinds = {}
    for face in shape.Faces():
        kind = face.geomType().lower()
        kinds[kind] = kinds.get(kind, 0) + 1
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape.wrapped, box, False, False)
    low, high = box.Get()[:3], box.Get()[3:]
    return {
        "solids": len(shape.Solids()),
        "faces": len(shape.Faces()),
        "surfaces": dict(sorted(kinds.items())),
        "box": [[round(v, 3) + 0.0 for v in corner] for corner in (low, high)],
    }


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    table = {}
    for make in PARTS:
        name = make.__name__.replace("_", "-")
        part = make()
        (assembly if isinstance(part, cq.Assembly) else solid)(folder, name, part)
        table[name] = seen(folder / f"{name}.step")
        print(name, table[name])
    lines = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in table.items())
    (folder / "faces.json").write_text("{\n" + lines + "\n}\n")


main(pathlib.Path(sys.argv[1]))
