# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Clouds with properties in several files, and whether samples got the right ones.

    colored_ribbon.py make                      whole.ply, the same points in parts/*.ply, and
                                                rotated.ply, where those of the last part are first
    colored_ribbon.py split FILE.las FOLDER     the points of a file of LAS 1.4 in three files,
                                                which tell a coordinate system
    colored_ribbon.py bytes FILE.las            of its colors, in place, the upper bytes alone
    colored_ribbon.py compare ONE.ply MANY.ply...
        rows of the others at places that ONE.ply has too: prints how many, and fails if a property
        of one of them is another one there
    colored_ribbon.py nearest MANY.ply...
        whether each of their rows has all labels of one point of whole.ply, and some of them those
        of the nearest one
    colored_ribbon.py values NAME MANY.ply...   the different values of a property
"""

import math
import pathlib
import random
import struct
import sys

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d"}
COLUMNS = [("double", "x"), ("double", "y"), ("double", "z"), ("uchar", "red"), ("uchar", "green"),
           ("uchar", "blue"), ("ushort", "intensity"), ("uchar", "classification"),
           ("float", "moisture"), ("int", "number")]


def ends_of_parts(size):
    return [0, size * 3 // 8, size * 3 // 8 + 100, size]


def write_ply(path, rows):
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}"]
    header += [f"property {kind} {name}" for kind, name in COLUMNS] + ["end_header\n"]
    packed = struct.Struct("<" + "".join(TYPES[kind] for kind, _ in COLUMNS))
    with open(path, "wb") as stream:
        stream.write("\n".join(header).encode())
        for row in rows:
            stream.write(packed.pack(*row))


def read_ply(path):
    """Names, and one tuple of numbers a point."""
    header, _, data = pathlib.Path(path).read_bytes().partition(b"end_header\n")
    columns = [line.split()[1:] for line in header.decode().splitlines()
               if line.startswith("property ")]
    packed = struct.Struct("<" + "".join(TYPES[kind] for kind, _ in columns))
    return [name for _, name in columns], list(packed.iter_unpack(data))


def make():
    """A long wavy ribbon, places that many points share, and strays, all in any order."""
    rand = random.Random(2)
    points = []
    for i in range(2400):
        for j in range(10):
            x, y = i + rand.uniform(-0.5, 0.5), j + rand.uniform(-0.5, 0.5)
            points.append((x, y, 2 * math.sin(x / 40) + rand.uniform(-0.05, 0.05)))
    for copies in (1, 3, 12):
        points += rand.sample(points[:24000], 100) * copies
    points += [(100.0 * i, 10.0, 60.0) for i in range(12)]
    rand.shuffle(points)
    rows = [(*point, rand.randrange(256), rand.randrange(256), rand.randrange(256),
             rand.randrange(65536), rand.randrange(30), rand.random(), number)
            for number, point in enumerate(points)]
    write_ply("whole.ply", rows)
    pathlib.Path("parts").mkdir()
    ends = ends_of_parts(len(rows))
    for name, begin, end in zip("abc", ends, ends[1:]):
        write_ply(f"parts/{name}.ply", rows[begin:end])
    write_ply("rotated.ply", rows[ends[2]:] + rows[:ends[2]])


def split(path, folder):
    data = pathlib.Path(path).read_bytes()
    offset, = struct.unpack_from("<I", data, 96)
    size, = struct.unpack_from("<H", data, 105)
    number, = struct.unpack_from("<Q", data, 247)
    end_of_header, = struct.unpack_from("<H", data, 94)
    number_of_records, = struct.unpack_from("<I", data, 100)
    system = b'LOCAL_CS["a town"]'
    record = struct.pack("<H16sHH32s", 0, b"LASF_Projection", 2112, len(system), b"") + system
    pathlib.Path(folder).mkdir()
    ends = ends_of_parts(number)
    for name, begin, end in zip("abc", ends, ends[1:]):
        header = bytearray(data[:end_of_header] + record + data[end_of_header:offset])
        struct.pack_into("<I", header, 96, offset + len(record))
        struct.pack_into("<I", header, 100, number_of_records + 1)
        struct.pack_into("<Q", header, 247, end - begin)
        points = data[offset + begin * size:offset + end * size]
        pathlib.Path(folder, f"{name}.las").write_bytes(header + points)


def bytes_of(path):
    data = bytearray(pathlib.Path(path).read_bytes())
    offset, = struct.unpack_from("<I", data, 96)
    size, = struct.unpack_from("<H", data, 105)
    assert data[104] == 7, "the point format"
    for begin in range(offset + 30, len(data), size):
        struct.pack_into("<3H", data, begin,
                         *(value >> 8 for value in struct.unpack_from("<3H", data, begin)))
    pathlib.Path(path).write_bytes(data)


def compare(one, many):
    names, rows = read_ply(one)
    normals = [names.index(name) for name in ("nx", "ny", "nz")]  # whose sides may differ
    def without_normals(row):
        return struct.pack(f"{len(row)}d", *(0 if k in normals else value
                                             for k, value in enumerate(row)))
    known = {row[:3]: without_normals(row) for row in rows}
    found = wrong = total = 0
    for path in many:
        same_names, others = read_ply(path)
        assert same_names == names, f"{path}: {same_names} instead of {names}"
        total += len(others)
        for row in others:
            if row[:3] in known:
                found += 1
                wrong += known[row[:3]] != without_normals(row)
    print(f"{found} of {total}")
    sys.exit(f"{wrong} rows have other properties" if wrong else 0)


def nearest(many):
    _, points = read_ply("whole.ply")
    names, rows = None, []
    for path in many:
        names, others = read_ply(path)
        rows += others
    labels = [names.index(name) for name in ("intensity", "classification", "number")]
    for i, row in enumerate(rows):
        intensity, classification, number = (row[k] for k in labels)
        point = points[number]
        assert (point[6], point[7], point[9]) == (intensity, classification, number), row
        if i % 100 == 0:
            assert number == min(points, key=lambda p: (math.dist(p[:3], row[:3]), p[9]))[9], row


def values(name, many):
    found = set()
    for path in many:
        names, rows = read_ply(path)
        found.update(row[names.index(name)] for row in rows)
    print(*sorted(found))


if __name__ == "__main__":
    {"make": make, "split": split, "bytes": bytes_of,
     "compare": lambda one, *many: compare(one, many),
     "nearest": lambda *many: nearest(many),
     "values": lambda name, *many: values(name, many)}[sys.argv[1]](*sys.argv[2:])
