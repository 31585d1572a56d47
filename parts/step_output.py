"""Writes STEP files that are the same in every run; what write_step.py and machine_parts.py share."""

import pathlib
import re

from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.IFSelect import IFSelect_RetDone
from OCP.Interface import Interface_Static
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer
from OCP.TCollection import TCollection_HAsciiString


def header(model, name):
    """A header without a path, a person or a time of day."""
    text = TCollection_HAsciiString
    head = APIHeaderSection_MakeHeader(model)
    head.SetName(text(name))
    head.SetTimeStamp(text("2026-01-01T00:00:00"))
    head.SetAuthorValue(1, text(""))
    head.SetOrganizationValue(1, text(""))
    head.SetOriginatingSystem(text("cadquery 2.8.0, OpenCASCADE 7.9.3"))
    head.SetPreprocessorVersion(text(""))
    head.SetAuthorisation(text(""))
    head.Apply(model)


def settings(unit="MM", pcurves=0):
    Interface_Static.SetCVal_s("write.step.unit", unit)
    Interface_Static.SetIVal_s("write.surfacecurve.mode", pcurves)
    Interface_Static.SetIVal_s("write.precision.mode", 0)


def finish(writer, folder, name):
    """Writes a file; the number that OpenCASCADE puts behind the name of a product goes."""
    path = pathlib.Path(folder) / f"{name}.step"
    assert writer.Write(str(path)) == IFSelect_RetDone
    path.write_text(re.sub(rf"'{name} \d+'", f"'{name}'", path.read_text()))


def solid(folder, name, shape, **kind):
    writer = STEPControl_Writer()
    settings(**kind)
    Interface_Static.SetCVal_s("write.step.product.name", name)
    writer.Transfer(shape.wrapped, STEPControl_AsIs)
    header(writer.Model(), name)
    finish(writer, folder, name)


def assembly(folder, name, parts, **kind):
    from cadquery.occ_impl.assembly import toCAF

    _, document = toCAF(parts, True)
    writer = STEPCAFControl_Writer()
    settings(**kind)
    writer.SetColorMode(True)
    writer.SetNameMode(True)
    writer.Transfer(document, STEPControl_AsIs)
    header(writer.ChangeWriter().Model(), name)
    finish(writer, folder, name)
