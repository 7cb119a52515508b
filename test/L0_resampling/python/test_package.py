# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What cgal_l0 says about itself is true: the stubs, the example, the README."""

import ast
import dataclasses
import inspect
import os
import pathlib
import pydoc
import re
import runpy
import subprocess
import sys

import cgal_l0
import numpy
import pytest
from cgal_l0 import _core

root = pathlib.Path(os.environ["L0_SOURCE"])
package = pathlib.Path(cgal_l0.__file__).parent


def test_the_stub_of_the_function_is_its_signature():
    actual = inspect.signature(cgal_l0.l0_resample_point_set).parameters
    stub = ast.parse((package / "__init__.pyi").read_text())
    functions = [node for node in stub.body if isinstance(node, ast.FunctionDef)]
    overloads = [node for node in functions if node.name == "l0_resample_point_set"]
    assert len(overloads) == 3
    for function in functions[3:]:   # the overloads of others differ in the types only
        arguments = function.args
        own = inspect.signature(getattr(cgal_l0, function.name)).parameters
        assert [a.arg for a in arguments.args + arguments.kwonlyargs] == list(own), function.name
    assert {function.name for function in functions} == set(cgal_l0.__all__)
    for overload in overloads:
        arguments = overload.args
        assert [a.arg for a in arguments.args + arguments.kwonlyargs] == list(actual)
        for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
            if argument.arg != "report":
                assert ast.literal_eval(default) == actual[argument.arg].default, argument.arg
    assert (package / "py.typed").exists()


def test_help_begins_with_the_functions_and_explains_every_parameter():
    text = pydoc.render_doc(cgal_l0, renderer=pydoc.plaintext)
    lines = text.splitlines()
    first, second = (i for i, line in enumerate(lines)
                     if re.match("    l0_(orient_normals|resample_point_set)[(]", line))
    assert first < 30 < second   # in the order of the alphabet
    assert not re.search(r"__\w+__\(", text)
    assert "CGAL::" not in text and "C++" not in text and "std::" not in text
    for name in cgal_l0.__all__:
        function = getattr(cgal_l0, name)
        explained = set()
        for names in re.findall(r"^    ([\w, ]+): ", function.__doc__, re.MULTILINE):
            explained |= set(names.split(", "))
        parameters = set(inspect.signature(function).parameters)
        assert parameters <= explained, (name, parameters - explained)
        assert max(map(len, function.__doc__.splitlines())) <= 100, name


def test_help_says_the_defaults():
    function = cgal_l0.l0_resample_point_set
    for name, parameter in inspect.signature(function).parameters.items():
        if type(parameter.default) in (int, float):
            (said,) = re.findall(rf"\b{name}\b[^:]*: (?:[^\n]|\n(?!    \S|\n))*", function.__doc__)
            assert re.search(rf"[Dd]efault:? {parameter.default}\b", said), said


def test_help_explains_what_is_returned():
    reports = [cgal_l0.Report, cgal_l0.StageReport, cgal_l0.IterationReport, cgal_l0.SolverReport]
    for kind in [*reports, cgal_l0.PointCloud]:
        for field in dataclasses.fields(kind):
            explanation = re.compile(rf"^    (\w+, )*{field.name}(, \w+)*: ", re.MULTILINE)
            assert explanation.search(kind.__doc__), (kind, field.name)


def test_a_strict_type_checker_is_content(tmp_path):
    pytest.importorskip("mypy")

    def checked(*lines):
        script = tmp_path / "script.py"
        script.write_text("import cgal_l0, numpy\n" + "\n".join(lines) + "\n")
        run = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir",
                              str(tmp_path / "cache"), str(script)],
                             env={**os.environ, "MYPYPATH": str(package.parent)},
                             capture_output=True, text=True)
        return run.stdout

    assert checked("positions, normals, report = cgal_l0.l0_resample_point_set(",
                   "    numpy.zeros((9, 3)), report=True)",
                   "print(positions.shape, normals.shape, report.neighbor_radius + 1,",
                   "      report.stages[0].name.upper())"
                   ).startswith("Success")
    assert checked('cloud = cgal_l0.read_points("scan.ply")',
                   'positions, normals = cgal_l0.l0_resample_point_set(',
                   '    cloud.points, cloud.normals)',
                   'cgal_l0.write_points("out.ply", positions, normals, cloud.properties)',
                   'print(cgal_l0.snapshot(cloud.points, positions, normals, path="a.png").shape)',
                   'with cgal_l0.progress_bar() as callback:',
                   '    cgal_l0.l0_resample_point_set(',
                   '        cloud.points, callback=callback, device="auto")'
                   ).startswith("Success")
    assert "No overload" in checked(
        "cgal_l0.l0_resample_point_set(numpy.zeros((9, 3)), method='best')")
    assert 'has no attribute "speed"' in checked(
        "cgal_l0.l0_resample_point_set([], report=True)[2].speed")


def test_the_stub_of_the_core_has_its_names():
    def public(names):
        return {name for name in names
                if not name.startswith("_") and name not in ("name", "value")}

    stub = ast.parse((package / "_core.pyi").read_text())
    definitions = [node for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))]
    variables = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    assert {node.name for node in definitions} | public(variables) == public(dir(_core))
    for node in definitions:
        # The attributes of Parameters are the rows of a table.
        if isinstance(node, ast.ClassDef) and node.name != "Parameters":
            attributes = {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
            attributes |= {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            assert public(attributes) == public(dir(getattr(_core, node.name))), node.name


def test_the_version_is_the_project_s():
    project = (root / "CMakeLists.txt").read_text()
    assert f"project(CGAL_L0_resampling VERSION {cgal_l0.__version__} " in project


def test_the_report_has_the_members_of_the_cpp_report():
    header = (root / "include/CGAL/L0_resampling/Report.h").read_text()
    struct = header[header.index("struct Report\n"):]
    fields = [field.name for field in dataclasses.fields(cgal_l0.Report)]
    fields.remove("warnings")   # what the C++ function of that name says of the report
    assert [name for name in fields if f" {name}" not in struct] == []
    members = [line for line in struct.split("\n};")[0].splitlines() if re.match(r"  [^/]*;", line)]
    assert len(members) == len(fields) + 1   # the outcome, which is an exception here


def test_the_manual_says_which_names_differ():
    page = (root / "doc/L0_resampling/Python.txt").read_text()
    rows = re.search(r"\| in C\+\+ \| in Python \|\n(.*?)\n\n", page, re.DOTALL)[1].splitlines()[1:]
    cells = [[set(re.findall(r"`(\w+)`", cell)) for cell in row.split("|")[1:3]] for row in rows]
    arguments = set(inspect.signature(cgal_l0.l0_resample_point_set).parameters)
    assert set().union(*(python for _, python in cells)) <= arguments
    header = (root / "include/CGAL/l0_resample_point_set.h").read_text()
    in_cpp = set(re.findall(r"\\cgalParamNBegin\{(\w+)\}", header))
    assert set().union(*(cpp for cpp, _ in cells)) == in_cpp - arguments
    assert arguments - in_cpp - {"points"} == set().union(*(python for _, python in cells))


def example_code(name):
    """As the manual shows it."""
    code = (root / "examples/L0_resampling" / name).read_text()
    return re.split(r"# \[\w+\]\n", code)[1].strip()


def test_the_example_of_the_readme():
    code = example_code("l0_resample_example.py")
    assert f"```python\n{code}\n```" in (root / "README.md").read_text()


def test_the_shortest_example_runs(cube, tmp_path, monkeypatch):
    assert len(example_code("l0_resample_example.py").splitlines()) == 3
    monkeypatch.chdir(tmp_path)
    numpy.savetxt("scan.xyz", cube)
    names = runpy.run_path(str(root / "examples/L0_resampling/l0_resample_example.py"))
    assert names["positions"].shape == names["normals"].shape == (20000, 3)
