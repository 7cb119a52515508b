# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in files of every format, and pictures: as the program reads, writes and draws them."""

import base64
import os
import pathlib
import subprocess
import warnings

import cgal_l0
import numpy
import pytest

data = pathlib.Path(os.environ["L0_SOURCE"]) / "data"
formats = ["ply", "pcd", "off", "xyz", "npy"]


@pytest.fixture
def cloud(cube, cube_normals):
    """Points whose coordinates single precision holds, so that every format does."""
    points = numpy.float32(cube).astype(float)
    return (
        points,
        cube_normals,
        {
            "red": numpy.arange(6000, dtype=numpy.uint8),
            "green": numpy.full(6000, 7, numpy.uint8),
            "blue": numpy.zeros(6000, numpy.uint8),
            "intensity": numpy.linspace(0, 1, 6000),
        },
    )


@pytest.mark.parametrize("format", formats)
def test_what_is_written_is_read_again(tmp_path, cloud, format):
    points, normals, properties = cloud
    path = tmp_path / f"cloud.{format}"
    held = {"ply": list(properties), "pcd": list(properties), "off": ["red", "green", "blue"]}.get(
        format, []
    )
    with warnings.catch_warnings(record=True) as complaints:
        warnings.simplefilter("always")
        cgal_l0.write_points(path, points, normals, properties)
    assert [str(c.message).split("property ")[1] for c in complaints] == [
        repr(n) for n in properties if n not in held
    ]
    found = cgal_l0.read_points(path)
    assert numpy.array_equal(found.points, points) and numpy.array_equal(found.normals, normals)
    assert sorted(found.properties) == sorted(held)
    for name in held:
        assert numpy.array_equal(found.properties[name], properties[name]), name
        assert found.properties[name].dtype == properties[name].dtype, name


@pytest.mark.parametrize("format", formats)
def test_the_program_reads_the_same(tmp_path, cloud, format):
    path = tmp_path / f"cloud.{format}"
    cgal_l0.write_points(path, *cloud[:2])
    subprocess.run(
        [os.environ["L0_RESAMPLE"], "--convert-only", "--quiet", path, tmp_path / "other.xyz"],
        check=True,
    )
    table = numpy.loadtxt(tmp_path / "other.xyz")
    # of PCD single precision, in as few digits as that needs
    assert numpy.array_equal(table.astype(numpy.float32), numpy.float32(numpy.hstack(cloud[:2])))


def test_a_table_is_read_and_not_written(tmp_path, cube):
    path = tmp_path / "cloud.csv"
    with pytest.raises(ValueError, match="cloud.csv: CSV and OBJ are read, but not written"):
        cgal_l0.write_points(path, cube)
    path.write_text("X;Y;Z;class\n1;2;3;4\n5;6;7;8\n")
    found = cgal_l0.read_points(path)
    assert found.points.tolist() == [[1, 2, 3], [5, 6, 7]]
    assert found.properties["class"].tolist() == [4, 8]


def test_number_types(tmp_path, cube):
    for number_type in (numpy.float32, numpy.float64):
        cgal_l0.write_points(tmp_path / "cloud.ply", cube.astype(number_type))
        found = cgal_l0.read_points(str(tmp_path / "cloud.ply"))
        assert (
            found.points.dtype == number_type and found.normals is None and found.properties == {}
        )
        assert numpy.array_equal(found.points, cube.astype(number_type))
    columns = {
        "a": numpy.arange(6000),
        "b": -numpy.arange(6000),
        "c": numpy.arange(6000) % 2 == 0,
        "d": numpy.arange(6000, dtype=">i2"),
        "e": numpy.ones(6000, numpy.float16),
    }
    cgal_l0.write_points(tmp_path / "cloud.ply", cube[::-1], properties=columns)
    found = cgal_l0.read_points(tmp_path / "cloud.ply")
    assert numpy.array_equal(found.points, cube[::-1])
    for name, values in columns.items():
        assert numpy.array_equal(found.properties[name], values), name
    for wrong, error in (
        (numpy.full(6000, 2**40), ValueError),
        (numpy.zeros(6000, complex), TypeError),
        (numpy.zeros(5), ValueError),
        (numpy.zeros((6000, 2)), ValueError),
    ):
        with pytest.raises(error, match="the property 'a'"):
            cgal_l0.write_points(tmp_path / "cloud.ply", cube, properties={"a": wrong})


def test_las(tmp_path, cloud):
    points, normals, properties = cloud
    path = tmp_path / "cloud.las"
    columns = {
        **properties,
        "classification": numpy.arange(6000) % 7,
        "classification_flags": numpy.arange(6000) // 5999 * 4,   # the last one is withheld
        "gps_time": numpy.linspace(1e8, 2e8, 6000),
        "roughness": numpy.linspace(-1, 1, 6000, dtype=numpy.float32),
    }
    cgal_l0.write_points(path, points + [637000, 5849000, 0], normals, columns)
    with pytest.warns(UserWarning, match="cloud.las: 1 points are left out, .* as withheld"):
        found = cgal_l0.read_points(path)
    assert len(found.points) == 5999 and found.points.dtype == numpy.float64
    spacing = 1 / 32   # of 6000 points on a cube
    assert abs(found.points - points[:-1] - [637000, 5849000, 0]).max() < 1e-3 * spacing
    assert numpy.array_equal(found.normals, numpy.float32(normals[:-1]))
    for name, values in columns.items():
        assert numpy.array_equal(found.properties[name], values[:-1]), name
    assert found.properties["red"].dtype == numpy.uint8
    assert found.properties["classification"].dtype == numpy.uint8
    packed = path.read_bytes()
    (tmp_path / "cloud.laz").write_bytes(packed[:104] + b"\x87" + packed[105:])
    with pytest.raises(ValueError, match="LAZ is not read: give a command with decompress"):
        cgal_l0.read_points(tmp_path / "cloud.laz")
    (tmp_path / "it's.laz").write_bytes(base64.b64encode(packed))
    with pytest.warns(UserWarning, match="as withheld"):
        unpacked = cgal_l0.read_points(tmp_path / "it's.laz", decompress="base64 -d {}")
    assert numpy.array_equal(unpacked.points, found.points)
    with pytest.raises(ValueError, match="'exit 7' ended with status 7"):
        cgal_l0.read_points(tmp_path / "it's.laz", decompress="exit 7")


def test_the_format_may_be_said(tmp_path, cube):
    cgal_l0.write_points(tmp_path / "cloud.dat", cube, format="xyz")
    assert numpy.array_equal(numpy.loadtxt(tmp_path / "cloud.dat"), cube)
    assert numpy.array_equal(cgal_l0.read_points(tmp_path / "cloud.dat", format="xyz").points, cube)
    with pytest.raises(ValueError, match="format= tells what the file is"):
        cgal_l0.read_points(tmp_path / "cloud.dat")
    with pytest.raises(ValueError, match="format is 'doc'"):
        cgal_l0.write_points(tmp_path / "cloud.dat", cube, format="doc")


def test_odd_names(tmp_path, cube):
    header = b"ply\nformat ascii 1.0\nelement vertex 1\n"
    header += b"property float x\nproperty float y\nproperty float z\n"
    path = os.path.join(os.fsencode(tmp_path), b"name_\xff.ply")   # of the file too
    with open(path, "wb") as file:
        file.write(
            header
            + b"property uchar a\nproperty uchar a\nproperty uchar \xff\nend_header\n1 2 3 4 5 6\n"
        )
    found = cgal_l0.read_points(path)
    assert {name: values.tolist() for name, values in found.properties.items()} == {
        "a": [4],
        "a_2": [5],
        "\ufffd": [6],
    }
    with open(path, "wb") as file:
        file.write(header + b"end_header\n1 2\n")
    with pytest.raises(ValueError, match="line 7: 1 points are announced"):
        cgal_l0.read_points(os.fsdecode(path))
    cgal_l0.write_points(path, cube, properties={"gr\u00f6\u00dfe": cube[:, 0]})
    assert list(cgal_l0.read_points(path).properties) == ["gr\u00f6\u00dfe"]


@pytest.mark.parametrize("format", ["ply", "pcd", "las"])
@pytest.mark.parametrize("name", ["", " ", "two words", "a\nend_header", "tab\t", "\x1b[31m"])
def test_a_name_of_a_property_is_one_word(tmp_path, cube, format, name):
    path = tmp_path / f"cloud.{format}"
    with pytest.raises(ValueError, match="has no name that a file can hold"):
        cgal_l0.write_points(path, cube, properties={name: cube[:, 0]})
    assert list(tmp_path.iterdir()) == []


def test_columns_have_names(tmp_path):
    path = tmp_path / "cloud.xyz"
    path.write_text("1 2 3 255 128 0\n4 5 6 1 2 3\n")
    with pytest.warns(UserWarning, match="columns 4 to 6 are no unit vectors") as complaints:
        assert cgal_l0.read_points(path).properties == {}
    assert "--" not in str(complaints[0].message)   # no option of the program
    for columns in ("x,y,z,red,-,blue", ["x", "y", "z", "red", "-", "blue"]):
        found = cgal_l0.read_points(path, columns=columns)
        assert found.points.tolist() == [[1, 2, 3], [4, 5, 6]]
        assert {name: v.tolist() for name, v in found.properties.items()} == {
            "red": [255, 1],
            "blue": [0, 3],
        }
    for columns, message in [
        ("x,y,red,a,b,c", "^columns x,y,red,a,b,c: x, y and z have to be among the names"),
        ("x,y,z", "line 1: columns names 3, found 6"),
        (["x", "y", "z", "a b", "c", "d"], "'a b' is not a name"),
    ]:
        with pytest.raises(ValueError, match=message):
            cgal_l0.read_points(path, columns=columns)
    cgal_l0.write_points(tmp_path / "cloud.ply", found.points)
    with pytest.raises(ValueError, match="cloud.ply is no text"):
        cgal_l0.read_points(tmp_path / "cloud.ply", columns="x,y,z")
    with pytest.raises(ValueError, match="decimal_comma is given, but .*cloud.ply is no text"):
        cgal_l0.read_points(tmp_path / "cloud.ply", decimal_comma=True)


def test_arrays_in_files(tmp_path):
    path = tmp_path / "cloud.npy"
    rows = numpy.array([[1, 2, 3, 255, 128, 0], [4, 5, 6, 1, 2, 3]], float)
    for order in "CF":
        numpy.save(path, numpy.array(rows, order=order))
        with pytest.warns(UserWarning, match="columns 4 to 6 are no unit vectors"):
            found = cgal_l0.read_points(path)
        assert found.points.tolist() == rows[:, :3].tolist() and found.normals is None
        found = cgal_l0.read_points(path, columns="x,y,z,red,green,blue")
        assert found.properties["green"].tolist() == [128, 2]
    numpy.save(path, numpy.float16(rows[:, :3]))
    assert cgal_l0.read_points(path).points.tolist() == rows[:, :3].tolist()
    records = numpy.zeros(
        2,
        numpy.dtype(
            [
                ("position", [("x", "f4"), ("y", "f4"), ("z", "f4")]),
                ("normal", "f4", (3,)),
                ("class", "u1"),
                ("label", "i8"),
                ("is_good", "?"),
            ],
            align=True,
        ),
    )
    for axis, name in enumerate("xyz"):
        records["position"][name] = rows[:, axis]
    records["normal"] = 0, 0, -1
    records["class"], records["label"] = [2, 6], [7, -8]
    for shape in ((2,), (1, 2)):
        numpy.save(path, records.reshape(shape))
        found = cgal_l0.read_points(path)
        assert found.points.tolist() == rows[:, :3].tolist()
        assert found.normals.tolist() == [[0, 0, -1]] * 2
        assert found.properties["class"].tolist() == [2, 6]
        assert found.properties["label"].tolist() == [7, -8]
        assert found.properties["is_good"].tolist() == [0, 0]


def test_files_of_strangers(tmp_path):
    path = tmp_path / "cloud.txt"
    path.write_text("X;Y;Z;Red\n1,5;2;3;4\n")
    with pytest.raises(ValueError, match="decimal_comma=True reads numbers such as 0,5"):
        cgal_l0.read_points(path)
    assert cgal_l0.read_points(path, decimal_comma=True).points.tolist() == [[1.5, 2, 3]]
    with pytest.warns(UserWarning, match="x and y look like degrees"):
        path.write_text("7.1 50.7 100\n7.101 50.701 120\n")
        cgal_l0.read_points(path)
    path = tmp_path / "cloud.obj"
    path.write_text("v 1 2 3\nv 4 5 6\nvn 0 0 1\nvn 0 1 0\nf 1//2 2//1 2//1\n")
    assert cgal_l0.read_points(path).normals.tolist() == [[0, 1, 0], [0, 0, 1]]


def test_bad_files(tmp_path):
    with pytest.raises(FileNotFoundError):
        cgal_l0.read_points(tmp_path / "none.ply")
    (tmp_path / "bad.xyz").write_text("1 2 3\n4 5\n")
    with pytest.raises(ValueError, match="bad.xyz: line 2"):
        cgal_l0.read_points(tmp_path / "bad.xyz")
    (tmp_path / "bad.xyz").write_text("1 2 3\nnan 5 6\n")
    with pytest.raises(ValueError, match="drop_non_finite=True leaves such points out"):
        cgal_l0.read_points(tmp_path / "bad.xyz")
    found = cgal_l0.read_points(tmp_path / "bad.xyz", drop_non_finite=True)
    assert found.points.tolist() == [[1, 2, 3]] and found.number_of_dropped_points == 1


def test_an_old_file_outlives_an_error(tmp_path, cube):
    with pytest.raises(OSError, match="cannot be written"):
        cgal_l0.write_points(tmp_path / "no_folder" / "cloud.ply", cube)
    path = tmp_path / "cloud.xyz"
    path.write_text("1 2 3\n")
    with pytest.raises(ValueError):
        cgal_l0.write_points(path, cube[:, :2])
    assert path.read_text() == "1 2 3\n"
    cgal_l0.write_points(path, cube)   # which replaces it
    assert len(path.read_text().splitlines()) == 6000
    assert list(tmp_path.iterdir()) == [path]


def test_reading_can_be_cancelled(tmp_path, cube):
    path = tmp_path / "cloud.xyz"
    cgal_l0.write_points(path, numpy.tile(cube, (20, 1)))
    shares = []
    cgal_l0.read_points(path, callback=shares.append)
    assert shares and all(0 <= a <= b <= 1 for a, b in zip(shares, shares[1:]))
    with pytest.raises(cgal_l0.Cancelled):
        cgal_l0.read_points(path, callback=lambda share: False)


def test_snapshot(tmp_path, cube, cube_normals):
    positions, normals, confidences = cgal_l0.l0_resample_point_set(cube, feature_confidences=True)
    image = cgal_l0.snapshot(cube, positions, normals, path=tmp_path / "picture.png")
    assert image.dtype == numpy.uint8 and image.ndim == 3 and image.shape[2] == 3
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")

    def colored_shares(picture):
        """How much of each half is not gray."""
        return [(half.std(axis=2) > 5).mean() for half in numpy.split(picture, 2, axis=1)]

    left, right = colored_shares(image)
    assert left == 0
    assert right < 0.002   # what is seen of it faces the eye
    assert not numpy.array_equal(image, cgal_l0.snapshot(cube, positions, normals, view=(1, 0, 0)))
    upright = cgal_l0.snapshot(cube, positions, normals, view=(1, 0, 0), up=(0, 0, 1))
    lying = cgal_l0.snapshot(cube, positions, normals, view=(1, 0, 0), up=(0, 1, 1))
    assert not numpy.array_equal(upright, lying)
    rows = cgal_l0.snapshot(cube, positions, normals, views=4)
    assert rows.shape == (4 * image.shape[0], *image.shape[1:])
    assert numpy.array_equal(rows[: len(image)], image)
    assert colored_shares(cgal_l0.snapshot(cube, positions, -normals))[1] > 0.2   # blue
    colored = cgal_l0.snapshot(
        cube, positions, normals, input_normals=cube_normals, colors="normals"
    )
    assert min(colored_shares(colored)) > 0.2
    marked = numpy.split(
        cgal_l0.snapshot(cube, positions, normals, feature_confidences=confidences), 2, axis=1
    )[1]
    red, green = marked[..., 0], marked[..., 1]
    assert (red < green).mean() < 0.002 < (red > green).mean()
    for view in ((0, 0, 0), (1, 2), (1, 2, float("nan"))):
        with pytest.raises(ValueError, match="view is"):
            cgal_l0.snapshot(cube, positions, normals, view=view)
        with pytest.raises(ValueError, match="up is"):
            cgal_l0.snapshot(cube, positions, normals, up=view)
    with pytest.raises(ValueError, match="normals is a float64 array"):
        cgal_l0.snapshot(cube, positions, normals[1:])
    with pytest.raises(ValueError, match="views is 5, expected 1, 2, 3 or 4"):
        cgal_l0.snapshot(cube, positions, normals, views=5)
    with pytest.raises(ValueError, match="colors is 'red', expected 'shaded' or 'normals'"):
        cgal_l0.snapshot(cube, positions, normals, colors="red")
    with pytest.raises(ValueError, match="feature_confidences need colors='shaded'"):
        cgal_l0.snapshot(
            cube, positions, normals, colors="normals", feature_confidences=confidences
        )


def test_the_picture_is_that_of_the_program(tmp_path, cube):
    source, result, picture = (tmp_path / name for name in ("in.ply", "out.ply", "program.png"))
    cgal_l0.write_points(source, cube)
    subprocess.run(
        [
            os.environ["L0_RESAMPLE"],
            source,
            result,
            "--device",
            "cpu",
            "--quiet",
            "--snapshot",
            picture,
        ],
        check=True,
    )
    found = cgal_l0.read_points(result)
    cgal_l0.snapshot(cube, found.points, found.normals, path=tmp_path / "own.png")
    assert picture.read_bytes() == (tmp_path / "own.png").read_bytes()


def test_the_data_of_the_package():
    for path in sorted(data.glob("*.ply")):
        assert len(cgal_l0.read_points(path).points) > 0, path
