#!/usr/bin/env python3
"""Compares what `imogene import` makes of STEP files with what OpenCASCADE makes of them, file by file.

    pip install cadquery-ocp numpy         # once; written for cadquery-ocp 7.9.3 (OpenCASCADE 7.9.3)
    scripts/step_witness.py --imogene target/release/imogene parts/*.step parts/machine/*.step

OpenCASCADE counts solids, shells and faces, each placed instance for itself, and faces by kind of surface. Faces on
splines, extrusions, revolutions and offsets are counted again if they are a plane, cylinder, cone, sphere or torus
within 1e-5 of the diagonal of the box of all parts ("recognised").

The picture of the scene, by the golden model, is compared with the triangles of OpenCASCADE, seen through the camera
of the scene and through a second one that looks from the other side (the eye reflected in the target). The triangles
stay within `--deflection` of the surfaces. Pixel (i, j) is sampled at (i - width/2, j - height/2) of the screen plane,
as docs/scene-format.md says. The worse of both views is printed:

    IoU     pixels that both cover, divided by those that one of them covers
    depth   share of common pixels whose distances from the eye agree within 1e-3 of the diagonal
    holes   pixels of the OpenCASCADE silhouette, eroded by one pixel, that the picture leaves empty
    strays  pixels of the picture outside the OpenCASCADE silhouette grown by one pixel

Faces that OpenCASCADE cannot mesh, though it has them, are counted ("not meshed"): where there are some, what differs
may be its fault. A ghost is a face that the importer has beyond those of OpenCASCADE. Each file is read in a process of
its own.
The table, in Markdown, goes to standard output and to `--table FILE` (witness.md in the folder for temporary files);
`--json FILE` has all that was found.

Exit code 1: a file in which OpenCASCADE finds a solid is refused, a ghost appears, or IoU is below 0.999 for a file
without rejected faces (and, with --strict-holes, has holes or strays). 2: usage.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from fractions import Fraction

import numpy as np

SURFACES = ["plane", "cylinder", "cone", "sphere", "torus", "bezier", "bspline", "revolution", "extrusion", "offset", "other"]
ANALYTIC = set(SURFACES[:5])
RECOGNISED_WITHIN = 1e-5
SAME_DEPTH = 1e-3
LEAST_IOU = 0.999


# What OpenCASCADE sees ---------------------------------------------------------------------------------------------


def read_step(path):
    """The shape of a file, in millimetres, with every instance placed; None if there is none."""
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.Message import Message, Message_Gravity
    from OCP.STEPControl import STEPControl_Reader

    for printer in Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(Message_Gravity.Message_Fail)
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_RetDone or not reader.TransferRoots():
        return None
    shape = reader.OneShape()
    return None if shape is None or shape.IsNull() else shape


def explore(shape, kind):
    from OCP.TopExp import TopExp_Explorer

    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def box_of(shape):
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib

    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box, True, False)
    if box.IsVoid():
        return None
    corners = box.Get()
    return [list(corners[:3]), list(corners[3:])]


def surface_kind(face):
    from OCP.BRepAdaptor import BRepAdaptor_Surface

    name = BRepAdaptor_Surface(face, False).GetType().name.removeprefix("GeomAbs_")
    names = {"BSplineSurface": "bspline", "BezierSurface": "bezier", "SurfaceOfRevolution": "revolution",
             "SurfaceOfExtrusion": "extrusion", "OffsetSurface": "offset", "OtherSurface": "other"}
    return names.get(name, name.lower())


def recognised_kind(face, tolerance):
    """The kind of analytic surface that a face's surface is, within a tolerance, or None."""
    from OCP.BRepTools import BRepTools
    from OCP.BRep import BRep_Tool
    from OCP.Geom import (Geom_ConicalSurface, Geom_CylindricalSurface, Geom_Plane, Geom_SphericalSurface,
                          Geom_ToroidalSurface)
    from OCP.GeomConvert import GeomConvert, GeomConvert_SurfToAnaSurf

    kinds = {Geom_Plane: "plane", Geom_CylindricalSurface: "cylinder", Geom_ConicalSurface: "cone",
             Geom_SphericalSurface: "sphere", Geom_ToroidalSurface: "torus"}
    try:
        surface = BRep_Tool.Surface_s(face)
        # OpenCASCADE 7.9 crashes where the bounds of a face are a rounding error beyond those of its spline.
        limits = surface.Bounds()
        bounds = [min(max(v, limits[k // 2 * 2]), limits[k // 2 * 2 + 1]) for k, v in enumerate(BRepTools.UVBounds_s(face))]
        found = GeomConvert_SurfToAnaSurf(surface).ConvertToAnalytical(tolerance, *bounds)
        if found is None:
            from OCP.Geom import Geom_RectangularTrimmedSurface

            trimmed = Geom_RectangularTrimmedSurface(surface, *bounds, True, True)
            spline = GeomConvert.SurfaceToBSplineSurface_s(trimmed)
            found = GeomConvert_SurfToAnaSurf(spline).ConvertToAnalytical(tolerance, *spline.Bounds())
        return kinds.get(type(found))
    except Exception:  # Standard_Failure: OpenCASCADE gives up
        return None


def opencascade_counts(shape):
    from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
    from OCP.TopoDS import TopoDS

    box = box_of(shape)
    diagonal = float(np.linalg.norm(np.subtract(*box))) if box else 0.0
    kinds, recognised = Counter(), Counter()
    for item in explore(shape, TopAbs_FACE):
        face = TopoDS.Face_s(item)
        kind = surface_kind(face)
        kinds[kind] += 1
        if kind not in ANALYTIC:
            recognised[recognised_kind(face, RECOGNISED_WITHIN * diagonal) or "none"] += 1
    return {
        "solids": sum(1 for _ in explore(shape, TopAbs_SOLID)),
        "shells": sum(1 for _ in explore(shape, TopAbs_SHELL)),
        "faces": sum(kinds.values()),
        "kinds": dict(kinds),
        "recognised": dict(recognised),
        "box": box,
        "diagonal": diagonal,
    }


def mesh_of(face, deflection):
    """The triangles of a face, meshed anew after repair if OpenCASCADE left it out; None if it does so again."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.ShapeFix import ShapeFix_Shape
    from OCP.TopAbs import TopAbs_FACE
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    place = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(face, place)
    for coarser in (1, 10):
        if mesh is not None:
            break
        spline = BRepBuilderAPI_NurbsConvert(face, True).Shape()
        repair = ShapeFix_Shape(spline)
        repair.Perform()
        BRepMesh_IncrementalMesh(repair.Shape(), coarser * deflection, False, 0.3, True)
        for part in explore(repair.Shape(), TopAbs_FACE):
            mesh = BRep_Tool.Triangulation_s(TopoDS.Face_s(part), place)
    return mesh, place.Transformation()


def triangles_of(shape, deflection):
    """Corners of all triangles, an array (n, 3, 3) in millimetres, and the number of faces without any."""
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.TopAbs import TopAbs_FACE
    from OCP.TopoDS import TopoDS

    BRepMesh_IncrementalMesh(shape, deflection, False, 0.5, True)
    pieces, without = [np.zeros((0, 3, 3))], 0
    for item in explore(shape, TopAbs_FACE):
        mesh, move = mesh_of(TopoDS.Face_s(item), deflection)
        if mesh is None:
            without += 1
            continue
        nodes = [mesh.Node(k).Transformed(move) for k in range(1, mesh.NbNodes() + 1)]
        points = np.array([(p.X(), p.Y(), p.Z()) for p in nodes])
        corners = np.array([mesh.Triangle(k).Get() for k in range(1, mesh.NbTriangles() + 1)], dtype=int) - 1
        pieces.append(points[corners.reshape(-1, 3)])
    return np.concatenate(pieces), without


# The camera and the picture of the triangles -----------------------------------------------------------------------


def camera_of(scene):
    text = pathlib.Path(scene).read_text()
    camera = tomllib.loads(text[: text.index("\n[[")])["camera"]
    assert camera["kind"] == "perspective"
    return camera


def from_behind(scene, other):
    """Writes the scene with the eye reflected in the target."""
    text = pathlib.Path(scene).read_text()
    camera = camera_of(scene)
    eye = [2 * t - e for t, e in zip(camera["target"], camera["eye"])]
    head, tail = text.split("\neye = ", 1)
    pathlib.Path(other).write_text(f"{head}\neye = {json.dumps(eye)}\n{tail.split(chr(10), 1)[1]}")


def project(points, camera, width, height):
    """Columns, lines and distances along the view of points (n, 3)."""
    eye, target, up = (np.array(camera.get(key, (0, 1, 0)), dtype=float) for key in ("eye", "target", "up"))
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, up)
    right /= np.linalg.norm(right)
    down = np.cross(ahead, right)
    away = (points - eye) @ np.stack([right, down, ahead], axis=1)
    scale = camera["viewer_distance"] * height / camera["view_height"]
    distance = away[:, 2]
    safe = np.where(distance > 0, distance, np.nan)
    return scale * away[:, 0] / safe + width / 2, scale * away[:, 1] / safe + height / 2, distance


def spread(counts):
    """For each item k counts[k] times: k, and 0, 1, .. counts[k] - 1."""
    owner = np.repeat(np.arange(len(counts)), counts)
    return owner, np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)


def draw(triangles, camera, width, height, chunk=200_000):
    """The least distance along the view at every pixel, infinite where nothing is."""
    picture = np.full(width * height, np.inf)
    for start in range(0, len(triangles), chunk):
        part = triangles[start : start + chunk]
        x, y, z = (v.reshape(-1, 3) for v in project(part.reshape(-1, 3), camera, width, height))
        good = np.isfinite(x).all(axis=1)
        draw_some(picture, x[good], y[good], 1 / z[good], width, height)
    return picture.reshape(height, width)


def draw_some(picture, x, y, inverse, width, height):
    """Line by line: where a line meets two sides of a triangle, and the pixels between. 1/distance is linear there."""
    first = np.clip(np.ceil(y.min(axis=1)), 0, height).astype(int)
    last = np.clip(np.floor(y.max(axis=1)), -1, height - 1).astype(int)
    owner, step = spread(np.maximum(last - first + 1, 0))
    line = first[owner] + step
    x, y, inverse = x[owner], y[owner], inverse[owner]
    left, right = np.full(len(owner), np.inf), np.full(len(owner), -np.inf)
    at_left, at_right = np.zeros(len(owner)), np.zeros(len(owner))
    for a, b in ((0, 1), (1, 2), (2, 0)):
        # Both triangles at a side take its ends in the same order, so that no pixel falls between them.
        swap = (y[:, a] > y[:, b]) | ((y[:, a] == y[:, b]) & (x[:, a] > x[:, b]))
        low, high = np.where(swap, b, a)[:, None], np.where(swap, a, b)[:, None]
        take = lambda values, which: np.take_along_axis(values, which, axis=1)[:, 0]
        y0, y1 = take(y, low), take(y, high)
        meets = (y0 <= line) & (line <= y1)
        with np.errstate(divide="ignore", invalid="ignore"):
            t = np.where(y1 > y0, (line - y0) / (y1 - y0), 0.0)
        for share in (t, np.where(y1 > y0, t, 1.0)):
            at = take(x, low) * (1 - share) + take(x, high) * share
            value = take(inverse, low) * (1 - share) + take(inverse, high) * share
            lower, higher = meets & (at < left), meets & (at > right)
            left, at_left = np.where(lower, at, left), np.where(lower, value, at_left)
            right, at_right = np.where(higher, at, right), np.where(higher, value, at_right)
    some = left <= right
    line, left, right, at_left, at_right = (v[some] for v in (line, left, right, at_left, at_right))
    begin = np.clip(np.ceil(left - 1e-9), 0, width).astype(int)
    end = np.clip(np.floor(right + 1e-9), -1, width - 1).astype(int)
    owner, step = spread(np.maximum(end - begin + 1, 0))
    column = begin[owner] + step
    extent = (right - left)[owner]
    t = np.clip(np.where(extent > 0, (column - left[owner]) / np.where(extent > 0, extent, 1), 0), 0, 1)
    distance = 1 / (at_left[owner] * (1 - t) + at_right[owner] * t)
    np.minimum.at(picture, line[owner] * width + column, distance)


# What imogene sees -------------------------------------------------------------------------------------------------


def run(command, seconds):
    """Exit code, the JSON document and the message of a command; exit code -1 if it takes too long."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return -1, {}, f"no end after {seconds} s"
    try:
        document = json.loads(done.stdout)
    except json.JSONDecodeError:
        document = {}
    message = document.get("error", {}).get("message", "") or (done.stderr.strip() if done.returncode else "")
    return done.returncode, document, message


def imported(options, path, scene):
    code, document, message = run([options.imogene, "--allow-missing", "import", path, "-o", scene, "--json"], options.timeout)
    report = document.get("report", {})
    faces = report.get("faces", [])
    total = report.get("total", {})
    names = Counter((face.get("solid"), face.get("name")) for face in faces)
    rejected = [face for face in faces if face["verdict"] == "rejected"]
    return {
        "code": code,
        "message": message,
        "objects": document.get("objects"),
        "solids": report.get("solids"),
        "faces": len(faces) if report else None,
        **{verdict: total.get(verdict) for verdict in ("exact", "approximated", "rejected")},
        "twice": sum(n - 1 for n in names.values()),
        "reasons": dict(Counter(f"{face['surface']}: {face.get('reason', '')}" for face in rejected)),
        "left_out": report.get("step", {}).get("left_out", {}),
    }


def rendered(options, scene, folder):
    """Distances along the view, infinite where the picture is empty; or None and why."""
    ids, depth = os.path.join(folder, "ids.npy"), os.path.join(folder, "depth.npy")
    command = [options.imogene, "--allow-missing", "render", scene, "--json", "--allow-missing", "--size", f"{options.width}x{options.height}"]
    command += ["-o", os.path.join(folder, "picture.png"), "--ids", ids, "--depth", depth]
    code, document, message = run(command, options.timeout)
    if code:
        return None, f"render, exit code {code}: {message}"
    farthest = 2**23 - 1
    words = np.load(depth).astype(float)
    near = float(Fraction(document["range"]["near"]))
    with np.errstate(divide="ignore"):
        distance = 2 * near * farthest / (farthest - words)
    return np.where(np.load(ids) >= 0, distance, np.inf), ""


# The comparison ----------------------------------------------------------------------------------------------------


def grown(mask):
    wide = np.pad(mask, 1)
    return np.any([wide[a : a + mask.shape[0], b : b + mask.shape[1]] for a in range(3) for b in range(3)], axis=0)


def compared(picture, truth, diagonal):
    ours, theirs = np.isfinite(picture), np.isfinite(truth)
    both = ours & theirs
    with np.errstate(invalid="ignore"):
        same = np.abs(picture - truth)[both] <= SAME_DEPTH * diagonal
    return {
        "iou": float(both.sum() / max(1, (ours | theirs).sum())),
        "depth": float(same.mean()) if both.any() else 0.0,
        "holes": int((~grown(~theirs) & ~ours).sum()),
        "strays": int((ours & ~grown(theirs)).sum()),
        "pixels": int(theirs.sum()),
    }


def witness(options, path):
    """Everything about one file."""
    result = {"file": path, "occ": None, "views": [], "trouble": []}
    shape = read_step(path)
    if shape is not None:
        result["occ"] = opencascade_counts(shape)
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "scene.toml")
        result["imogene"] = imported(options, path, scene)
        if result["imogene"]["code"] == 0 and result["occ"] and result["occ"]["diagonal"] > 0:
            diagonal = result["occ"]["diagonal"]
            triangles, without = triangles_of(shape, options.deflection * diagonal)
            result["triangles"], result["without_triangles"] = len(triangles), without
            behind = os.path.join(folder, "behind.toml")
            from_behind(scene, behind)
            for view in (scene, behind):
                picture, why = rendered(options, view, folder)
                if picture is None:
                    result["trouble"].append(why)
                    continue
                truth = draw(triangles, camera_of(view), options.width, options.height)
                result["views"].append(compared(picture, truth, diagonal))
                if options.keep:
                    kept = os.path.join(options.keep, f"{pathlib.Path(path).stem}-{len(result['views'])}.npz")
                    np.savez_compressed(kept, imogene=picture, opencascade=truth)
    return result


def verdicts(options, result):
    """What is wrong with a file, in words."""
    occ, own = result["occ"], result["imogene"]
    wrong = list(result["trouble"])
    if own["code"] != 0:
        if occ and occ["solids"]:
            wrong.append("refused")
        return wrong
    result["ghosts"] = max(0, own["faces"] - occ["faces"]) if occ else 0
    if result["ghosts"]:
        wrong.append(f"{result['ghosts']} ghosts")
    if own["rejected"] == 0 and result["views"]:
        if worst(result, "iou", min) < LEAST_IOU:
            wrong.append("IoU")
        if options.strict_holes and worst(result, "holes", max) + worst(result, "strays", max):
            wrong.append("holes or strays")
    return wrong


def worst(result, key, choose):
    return choose(view[key] for view in result["views"])


def table(results):
    head = ["file", "solids", "faces", "by surface (recognised)", "imogene solids", "faces", "exact", "appr.", "rej.",
            "objects", "IoU", "depth", "holes", "strays", "wrong"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for result in results:
        occ, own = result["occ"], result["imogene"]
        kinds = "none"
        if occ:
            kinds = ", ".join(f"{occ['kinds'][k]} {k}" for k in SURFACES if occ["kinds"].get(k))
            found = ", ".join(f"{n} {k}" for k, n in sorted(occ["recognised"].items()))
            kinds += f" ({found})" if found else ""
            kinds += f"; {result['without_triangles']} not meshed" if result.get("without_triangles") else ""
        row = [pathlib.Path(result["file"]).name, occ and occ["solids"], occ and occ["faces"], kinds]
        if own["code"]:
            row += [f"exit code {own['code']}: {own['message'][:160]}"] + [""] * 9
        else:
            row += [own[key] for key in ("solids", "faces", "exact", "approximated", "rejected", "objects")]
            if result["views"]:
                row += [f"{worst(result, 'iou', min):.5f}", f"{worst(result, 'depth', min):.4f}",
                        worst(result, "holes", max), worst(result, "strays", max)]
            else:
                row += [""] * 4
        row.append("; ".join(result["wrong"]))
        lines.append("| " + " | ".join(str("" if cell is None else cell).replace("|", "/").replace("\n", " ") for cell in row) + " |")
    return "\n".join(lines)


def apart(options, path):
    """One file in a process of its own, so that a crash or an endless loop in either program costs one line."""
    command = [sys.executable, __file__, "--one", "--imogene", options.imogene, "--timeout", str(options.timeout)]
    command += ["--deflection", str(options.deflection), "--size", options.size, path]
    command += ["--keep", options.keep] if options.keep else []
    code, _, message = 0, None, ""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=4 * options.timeout)
        for line in reversed(done.stdout.splitlines()):
            if line.startswith('{"file"'):
                return json.loads(line)
        code, message = done.returncode, done.stderr.strip().splitlines()[-1:] or [""]
    except subprocess.TimeoutExpired:
        code, message = -1, [f"no end after {4 * options.timeout} s"]
    blank = {key: None for key in ("objects", "solids", "faces", "exact", "approximated", "rejected")}
    own = {"code": code or -1, "message": f"the witness itself: {message}", "reasons": {}, "left_out": {}, **blank}
    return {"file": path, "occ": None, "views": [], "trouble": ["witness failed"], "imogene": own}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", help="STEP files")
    parser.add_argument("--imogene", default="target/release/imogene", help="the program")
    parser.add_argument("--size", default="640x480", help="of the pictures")
    parser.add_argument("--deflection", type=float, default=5e-5, help="of the triangles, in diagonals")
    parser.add_argument("--timeout", type=float, default=120, help="seconds for one run of imogene")
    parser.add_argument("--jobs", type=int, default=2, help="files at a time")
    parser.add_argument("--json", help="file to write all results to")
    table_file = os.path.join(tempfile.gettempdir(), "witness.md")
    parser.add_argument("--table", default=table_file, help="file to write the table to")
    parser.add_argument("--keep", help="folder for the distances of both programs, NAME-VIEW.npz")
    parser.add_argument("--strict-holes", action="store_true", help="holes and strays are failures too")
    parser.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    options.width, options.height = map(int, options.size.split("x"))
    return options


def main():
    options = arguments()
    if options.one:
        print("\n" + json.dumps(witness(options, options.files[0])))
        return 0
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda path: apart(options, path), options.files))
    for result in results:
        result["wrong"] = verdicts(options, result)
    text = table(results)
    bad = sum(1 for result in results if result["wrong"])
    print(text + f"\n\n{len(results)} files, {bad} with something wrong.")
    if options.table:
        pathlib.Path(options.table).write_text(text + "\n")
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(results, indent=1) + "\n")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
