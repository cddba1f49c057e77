#!/usr/bin/env python3
"""Regenerates datasets/data/{counties,coast}.txt from the npm package us-atlas, byte for byte.

    scripts/real_data/regenerate.py                     fetch the locked version with npm, write the files
    scripts/real_data/regenerate.py --package DIR       use an unpacked package instead of fetching
    scripts/real_data/regenerate.py --check             write nothing; exit 1 when the shipped files differ

The package holds TopoJSON: `arcs` are polylines on an integer lattice, each written as a first point and steps from
point to point; a ring is a list of arc numbers, ~k meaning arc k walked backwards; `transform` maps lattice to degrees.
Needs Python 3.9 or later and, without --package, npm. See datasets/data/PROVENANCE.md for what the files hold.
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import tarfile
import tempfile

PACKAGE = "us-atlas@3.0.1"
LOCK = {  # SHA-256 of the files of the package that are used
    "counties-10m.json": "145aaf5d1433352a6a1d8e86b5f149c7c653f9171baf14aaf75ee66575def1b0",
    "nation-10m.json": "8ca8af2285b3c25268850d49adbe15de186d388dd20340ccbac72f83e35b6fe8",
}
DATA = pathlib.Path(__file__).resolve().parents[2] / "datasets" / "data"
GULF = {"longitude": (-98.0, -80.5), "latitude": (24.3, 31.0)}


def fetch(folder):
    """Unpacks the locked package below `folder` and returns where its files are."""
    packed = subprocess.run(
        ["npm", "pack", PACKAGE, "--silent"], cwd=folder, check=True, capture_output=True, text=True
    ).stdout.split()[-1]
    with tarfile.open(folder / packed) as archive:
        archive.extractall(folder)
    return folder / "package"


def load(package, name):
    """A topology of the package, refused unless it is the locked one to the byte."""
    content = (package / name).read_bytes()
    found = hashlib.sha256(content).hexdigest()
    if found != LOCK[name]:
        sys.exit(f"{package / name}: SHA-256 is {found}, locked is {LOCK[name]}")
    return json.loads(content)


def rings(geometry):
    """The rings of a geometry as lists of arc numbers, in the order of the file."""
    if geometry["type"] == "GeometryCollection":
        for member in geometry["geometries"]:
            yield from rings(member)
    elif geometry["type"] == "Polygon":
        yield from geometry["arcs"]
    elif geometry["type"] == "MultiPolygon":
        for polygon in geometry["arcs"]:
            yield from polygon
    else:
        sys.exit(f"no rings in a {geometry['type']}")


def decode(arc):
    """The lattice points of an arc."""
    x = y = 0
    points = []
    for dx, dy in arc:
        x, y = x + dx, y + dy
        points.append((x, y))
    return points


def counties(package):
    """The county borders as the package has them: arcs, then the rings of all counties over these arcs."""
    topology = load(package, "counties-10m.json")
    ring_list = list(rings(topology["objects"]["counties"]))
    lines = [f"arcs {len(topology['arcs'])}"]
    lines += [" ".join(f"{dx} {dy}" for dx, dy in arc) for arc in topology["arcs"]]
    lines += [f"rings {len(ring_list)}"]
    lines += [" ".join(map(str, ring)) for ring in ring_list]
    return lines


def coast(package):
    """The border of the nation inside the Gulf's window: its points, and its segments with both ends inside."""
    topology = load(package, "nation-10m.json")
    arcs = [decode(arc) for arc in topology["arcs"]]
    scale, shift = topology["transform"]["scale"], topology["transform"]["translate"]

    def inside(point):
        longitude, latitude = (shift[axis] + scale[axis] * point[axis] for axis in (0, 1))
        return (GULF["longitude"][0] <= longitude <= GULF["longitude"][1]
                and GULF["latitude"][0] <= latitude <= GULF["latitude"][1])

    number = {}  # point -> index, in the order of first appearance
    segments = {}  # (smaller index, larger index) -> None: an ordered set
    for ring in rings(topology["objects"]["nation"]):
        previous = None
        for arc_number in ring:
            for point in arcs[arc_number] if arc_number >= 0 else reversed(arcs[~arc_number]):
                current = number.setdefault(point, len(number)) if inside(point) else None
                if current is not None and previous is not None and current != previous:
                    segments[min(current, previous), max(current, previous)] = None
                previous = current
    x0, y0 = (min(point[axis] for point in number) for axis in (0, 1))
    lines = [f"origin {x0} {y0}", f"points {len(number)}"]
    lines += [f"{x - x0} {y - y0}" for x, y in number]
    lines += [f"segments {len(segments)}"]
    lines += [f"{a} {b}" for a, b in segments]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--package", type=pathlib.Path, help="folder of the unpacked package")
    parser.add_argument("--check", action="store_true", help="compare with the shipped files instead of writing them")
    options = parser.parse_args()
    differing = []
    with tempfile.TemporaryDirectory() as folder:
        package = options.package or fetch(pathlib.Path(folder))
        for name, derive in (("counties.txt", counties), ("coast.txt", coast)):
            content = ("\n".join(derive(package)) + "\n").encode("ascii")
            file = DATA / name
            if not options.check:
                DATA.mkdir(parents=True, exist_ok=True)
                file.write_bytes(content)
            elif not file.exists() or file.read_bytes() != content:
                differing.append(str(file))
    if differing:
        sys.exit("differs from what the package gives: " + ", ".join(differing))


if __name__ == "__main__":
    main()
