#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a PLY file of big-endian numbers of all types: write_all_types.py FILE"""

import random
import struct
import sys

PROPERTIES = [("double", "x", "d"), ("double", "y", "d"), ("double", "z", "d"),
              ("float", "nx", "f"), ("float", "ny", "f"), ("float", "nz", "f"),
              ("uchar", "red", "B"), ("uchar", "green", "B"), ("uchar", "blue", "B"),
              ("ushort", "intensity", "H"), ("uchar", "classification", "B"),
              ("double", "gps_time", "d"), ("int", "label", "i"), ("short", "quality", "h"),
              ("char", "level", "b"), ("uint", "source", "I"), ("float", "range", "f")]
LIMITS = {"B": (0, 255), "H": (0, 65535), "I": (0, 2**32 - 1), "b": (-128, 127),
          "h": (-2**15, 2**15 - 1), "i": (-2**31, 2**31 - 1)}


def main():
    numbers = random.Random(0)
    header = ["ply", "format binary_big_endian 1.0", "element vertex 100"]
    header += [f"property {name_of_type} {name}" for name_of_type, name, _ in PROPERTIES]
    row_format = ">" + "".join(code for _, _, code in PROPERTIES)
    with open(sys.argv[1], "wb") as file:
        file.write("\n".join(header + ["end_header", ""]).encode())
        for _ in range(100):
            row = [numbers.randint(*LIMITS[code]) if code in LIMITS else numbers.uniform(-1, 1)
                   for _, _, code in PROPERTIES]
            file.write(struct.pack(row_format, *row))


if __name__ == "__main__":
    main()
