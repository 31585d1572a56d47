"""Writes the STEP files of this folder: `python3 write_step.py FOLDER`, with cadquery 2.8.0 (OpenCASCADE 7.9.3).

Nobody needs it to use them; it says what they are, and tests count on these numbers. The colours of the assembly come in another order in every run.
"""

import math
import sys

import cadquery as cq

from step_output import assembly, solid

FOLDER = sys.argv[1]


def cylinder(radius, foot, axis, height):
    return cq.Solid.makeCylinder(radius, height, cq.Vector(*foot), cq.Vector(*axis))


def flange():
    """As flange.faces.toml."""
    body = cylinder(50, (0, 0, 0), (0, 1, 0), 10).fuse(cylinder(22, (0, 0, 0), (0, 1, 0), 30))
    body = body.cut(cylinder(12, (0, -1, 0), (0, 1, 0), 40))
    for k in range(6):
        angle = math.radians(30 + 60 * k)
        body = body.cut(cylinder(4.5, (38 * math.cos(angle), -1, 38 * math.sin(angle)), (0, 1, 0), 12))
    return body.clean()


def fillet():
    """As fillet.faces.toml: a shaft on a foot, a fillet of 4 and a chamfer of 3."""
    foot = cylinder(30, (0, 0, 0), (0, 1, 0), 8).fuse(cylinder(12, (0, 0, 0), (0, 1, 0), 39)).clean()
    work = cq.Workplane(obj=foot)
    at = lambda y, r: [e for e in work.edges("%CIRCLE").vals() if abs(e.Center().y - y) < 1e-6 and abs(e.radius() - r) < 1e-6]
    shape = foot.fillet(4, at(8, 12))
    work = cq.Workplane(obj=shape)
    return shape.chamfer(3, None, at(39, 12))


def cross_drilled():
    """As cross-drilled.faces.toml."""
    return cylinder(20, (0, -30, 0), (0, 1, 0), 60).cut(cylinder(8, (0, 0, -30), (0, 0, 1), 60))


def fixture():
    """A block with a countersunk hole, a socket of a sphere, a cone with its apex and a sector of 250 degrees of a shaft with a flat end; z is up."""
    block = cq.Solid.makeBox(60, 40, 12, cq.Vector(-30, -20, 0))
    block = block.cut(cylinder(4, (-18, 0, -1), (0, 0, 1), 20))
    block = block.cut(cq.Solid.makeCone(4, 8, 4, cq.Vector(-18, 0, 8), cq.Vector(0, 0, 1)))
    block = block.cut(cq.Solid.makeSphere(7, cq.Vector(0, 0, 14), angleDegrees1=-90, angleDegrees2=90))
    block = block.cut(cq.Solid.makeCone(0, 5, 6, cq.Vector(0, -14, 6), cq.Vector(0, 0, 1)))
    sector = cq.Solid.makeCylinder(9, 16, cq.Vector(18, 0, 12), cq.Vector(0, 0, 1), 250)
    return block.fuse(sector).clean()


def nut():
    """A hexagonal nut, chamfered by a cone of 30 degrees: its edges are hyperbolas."""
    body = cq.Workplane("XY").polygon(6, 20 / math.cos(math.pi / 6)).extrude(8).val()
    body = body.cut(cylinder(5, (0, 0, -1), (0, 0, 1), 10))
    cone = cq.Solid.makeCone(20, 0, 20 * math.tan(math.radians(30)), cq.Vector(0, 0, 2), cq.Vector(0, 0, 1))
    return body.intersect(cq.Solid.makeCylinder(19.9, 20, cq.Vector(0, 0, -1), cq.Vector(0, 0, 1)).intersect(cone.fuse(cylinder(20, (0, 0, -1), (0, 0, 1), 3)).clean())).clean()


def hollow():
    """A block with two cavities: a ball and a cylinder."""
    block = cq.Solid.makeBox(30, 20, 10, cq.Vector(0, 0, 0))
    block = block.cut(cq.Solid.makeSphere(4, cq.Vector(8, 10, 5), angleDegrees1=-90, angleDegrees2=90))
    return block.cut(cylinder(3, (20, 10, 2), (0, 0, 1), 6))


def stand():
    """Three coloured parts in inches, one of them placed three times: in place, moved and turned."""
    inch = 25.4
    plate = cq.Solid.makeBox(3 * inch, 2 * inch, 0.25 * inch, cq.Vector(-1.5 * inch, -inch, 0))
    plate = plate.cut(cylinder(0.375 * inch, (0, 0, -1), (0, 0, 1), inch))
    pin = cylinder(0.25 * inch, (0, 0, 0), (0, 0, 1), 0.75 * inch)
    pin = pin.fuse(cq.Solid.makeCone(0.25 * inch, 0.125 * inch, 0.25 * inch, cq.Vector(0, 0, 0.75 * inch), cq.Vector(0, 0, 1)))
    ball = cq.Solid.makeSphere(0.5 * inch, cq.Vector(0, 0, 0), angleDegrees1=-90, angleDegrees2=90)
    where = lambda x, y, z, angle=0: cq.Location(cq.Vector(x * inch, y * inch, z * inch), cq.Vector(0, 1, 0), angle)
    pins = cq.Assembly(name="pins")
    steel = cq.Color(0.5, 0.55, 0.6)
    pins.add(pin, name="pin", color=steel)
    pins.add(pin, name="pin moved", loc=where(2, 0, 0), color=steel)
    pins.add(pin, name="pin turned", loc=where(1, 0.75, 0.5, 90), color=steel)
    parts = cq.Assembly(name="stand")
    parts.add(plate, name="plate", color=cq.Color(0.15, 0.3, 0.6))
    parts.add(ball, name="ball", loc=where(0, 0, 0.5), color=cq.Color(0.8, 0.2, 0.1))
    parts.add(pins, loc=where(-1, 0, 0.25))
    return parts


solid(FOLDER, "flange", flange())
solid(FOLDER, "fillet", fillet())
solid(FOLDER, "cross-drilled", cross_drilled())
solid(FOLDER, "fixture", fixture(), pcurves=1)
solid(FOLDER, "nut", nut())
solid(FOLDER, "hollow", hollow())
assembly(FOLDER, "stand", stand(), unit="INCH")
