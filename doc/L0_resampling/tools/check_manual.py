#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds the manual to the code: check_manual.py PRINT_DEFAULTS SOURCE_DIRECTORY, with the program
print_defaults

- The docstring of l0_resample_point_set() quotes the defaults that the code has.
- The pages type no decimal number and no default, as these are generated, and no code, as all of it
  is an example.
- The formula of neighbor_radius, in the docstring and on each page that has it, gives the radius
  that the code takes.
- Formulas use only macros that are generated; every figure exists and is used; every named
  parameter is explained.
- The tests that the page of promises names exist, and tests run the examples that pages show.
- The page of constants has a row for each.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NUMBER = r"\d+(?:\.\d+)?"
FORMULA = re.compile(r"\\f\$.*?\\f\$|\\f\[.*?\\f\]", re.DOTALL)
OUR_MACRO = re.compile(r"\\((?:default|lor|alor|constant|quality|speed|solver|device)"
                       r"[A-Z_]\w*)")


def braced(text, begin):
    """What stands between the brace at `begin` and the one that closes it."""
    depth = 0
    for i in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return text[begin + 1:i]
    raise ValueError("a brace is not closed")


def docstring_parameters(header):
    """The documentation of each named parameter of l0_resample_point_set(), and what it says of the
    default."""
    parameters = {}
    for block in re.findall(r"\\cgalParamNBegin(.*?)\\cgalParamNEnd", header, re.DOTALL):
        default = block.index(r"\cgalParamDefault") + len(r"\cgalParamDefault")
        parameters[braced(block, 0)] = (re.sub(r"\s+", " ", block), braced(block, default))
    return parameters


def wrong_defaults(parameters, values):
    default, lor, constant = values["default"], values["lor"], values["constant"]
    for name in default:
        quoted = [float(n) for n in re.findall(NUMBER, parameters[name][1])]
        expected = [lor[name]] if lor[name] == default[name] else [lor[name], default[name]]
        if quoted != expected:
            yield f"the docstring of {name} quotes {quoted} as default, the code has {expected}"
        if values["alor"][name] != lor[name]:
            yield f"LOR and ALOR have different defaults of {name}: the manual takes them for one"
    radius = (f"({constant['radius_per_spacing']:g}s)^{{3/2}} + "
              f"({constant['radius_per_noise']:g}\\sigma)^{{3/2}}")
    phrases = [("neighbor_radius", radius),
               ("neighbor_radius", f"r_p / {1 / constant['self_neighbor_radius_factor']:g} "),
               ("neighbor_radius",
                f"within {constant['self_neighbor_radius_per_spacing']:g} spacings"),
               ("normal_weight", f"r_p / {1 / constant['sparsity_unit_factor']:g} ")]
    for name, phrase in phrases:
        if phrase not in parameters[name][0]:
            yield f"the docstring of {name} does not say '{phrase}', as the code has it"


def radius_by_formula(formula, constants, spacing, noise):
    """The value of a formula in LaTeX with the spacing s and the noise sigma."""
    text = re.sub(r"\\constant([A-Za-z]+)\{\}",
                  lambda m: repr(constants[re.sub(r"(?<!^)(?=[A-Z])", "_", m[1]).lower()]), formula)
    text = text.replace(r"\left", "").replace(r"\right", "").replace(r"\sigma", " sigma")
    text = re.sub(r"\\sqrt\{(.*)\}", r"(\1)^{1/2}", text)
    text = re.sub(r"\^\{(\d+)/(\d+)\}", r"**(\1/\2)", text)
    text = re.sub(r"\^(\d)", r"**\1", text)
    text = re.sub(r"(\d)\s*(s\b|sigma\b)", r"\1 * \2", text)
    return eval(text, {"__builtins__": {}}, {"s": spacing, "sigma": noise})    # of our own pages


def wrong_radii(print_defaults, constants, texts):
    """Compares the formulas in `texts`, a text by its name, with what the code computes."""
    for name, text in texts.items():
        formulas = [f for f in FORMULA.findall(text)
                    if r"\constantRadiusPerSpacing" in f or re.search(r"\ds\)", f)]
        if len(formulas) != 1:
            yield f"{name} has {len(formulas)} formulas of the default neighbor_radius, expected 1"
            continue
        formula = formulas[0][3:-3].split(",")[0].split("=")[-1]
        for spacing, noise in ((1, 0), (0, 1), (1, 0.5), (1, 1), (0.3, 2)):
            printed = subprocess.run([print_defaults, str(spacing), str(noise)], check=True,
                                     capture_output=True, text=True).stdout
            by_code = float(printed)
            by_formula = radius_by_formula(formula, constants, spacing, noise)
            # which is rounded in steps of 0.2 to 0.4 %
            if abs(by_formula - by_code) > 0.003 * by_code:
                yield (f"the formula of {name} gives the radius {by_formula:g} at spacing "
                       f"{spacing} and noise {noise}, the code {by_code:g}")


def typed_by_hand(name, page):
    text = FORMULA.sub("", page)
    for number in re.findall(r"(?<![\w.-])\d+\.\d+(?!\.?\w)", text):
        yield f"{name} types the number {number}: quote it by an alias that generate_text.py makes"
    for sentence in re.split(r"(?<=[.;:])\s", re.sub(r"\\\w+", "", text)):
        names_default = re.search(r"\bdefault (?:is|of)\b|\b[Bb]y default\b", sentence)
        if names_default and re.search(r"\d", sentence):
            yield f"{name} types a default: {' '.join(sentence.split())}"
    for alias in re.findall(r"^[ \t]*(\\[a-z]+_\w+)\. ", text, re.MULTILINE):
        yield f"{name} begins a line with {alias} and a full stop, which makes it an item of a list"
    for command in re.findall(r"[\\@](?:code|verbatim)\b|```|~~~", text):
        yield f"{name} types code behind {command}: show an example with \\snippet"


def unknown_macros(name, page, macros):
    for formula in FORMULA.findall(page):
        for macro in OUR_MACRO.findall(formula):
            if macro not in macros:
                yield f"{name} has \\{macro} in a formula, which generate_text.py does not make"


def run_by_tests(source):
    """The names of the examples that tests run."""
    lists = (source / "examples" / "L0_resampling" / "CMakeLists.txt").read_text(encoding="utf-8")
    tests = "".join(path.read_text(encoding="utf-8") for path in
                    (source / "test" / "L0_resampling" / "python").glob("*.py"))
    in_python = re.search(r"ITEMS ([\w ]+)\)\s+add_test\(NAME python_\$", lists)[1].split()
    return {*(f"{name}.cpp" for name in re.findall(r"\b\w+_example\b(?!\.)", lists)),
            *(f"python_{name}_example.py" for name in in_python),
            *re.findall(r"\w+_example\.(?:sh|py)", lists + tests)}


def snippets_without_test(name, page, run):
    """The examples that a page shows and that no test runs."""
    for example in sorted(set(re.findall(r"\\snippet L0_resampling/(\S+)", page)) - run):
        yield f"{name} shows {example}, which no test runs"


def constants_without_row(page, constants):
    rows = re.findall(r"^<tr><td>\\constant_(\w+)</td><td>`(\w+)`:$", page, re.MULTILINE)
    for name in sorted(constants.keys() - {alias for alias, shown in rows if alias == shown}):
        yield f"Constants.txt has no row of {name}"


def unknown_tests(page, tests):
    lists = "".join(path.read_text(encoding="utf-8") for path in tests.rglob("CMakeLists.txt"))
    for name in sorted(set(re.findall(r"`(test_\w+)`", page))):
        if name not in lists and name.removeprefix("test_") not in lists:
            yield f"Promises.txt names {name}, which is no test"


def main():
    source = Path(sys.argv[2])
    manual = source / "doc" / "L0_resampling"
    defaults = subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout
    with tempfile.TemporaryDirectory() as scratch:
        (Path(scratch) / "defaults.json").write_text(defaults, encoding="utf-8")
        subprocess.run([sys.executable, manual / "tools" / "generate_text.py",
                        Path(scratch) / "defaults.json",
                        source, scratch], check=True)
        macros = set(re.findall(r"\\newcommand\{\\(\w+)\}",
                                (Path(scratch) / "formula_macros.tex").read_text(encoding="utf-8")))

    header = (source / "include" / "CGAL" / "l0_resample_point_set.h").read_text(encoding="utf-8")
    parameters = docstring_parameters(header)
    pages = {path.name: path.read_text(encoding="utf-8") for path in sorted(manual.glob("*.txt"))
             if path.name != "CMakeLists.txt"}

    values = json.loads(defaults)
    errors = list(wrong_defaults(parameters, values))
    texts = {name: pages[name] for name in ("L0_resampling.txt", "Mathematics.txt")}
    texts["the docstring of neighbor_radius"] = parameters["neighbor_radius"][1]
    errors += wrong_radii(sys.argv[1], values["constant"], texts)
    run = run_by_tests(source)
    for name, page in pages.items():
        errors += [*typed_by_hand(name, page), *unknown_macros(name, page, macros),
                   *snippets_without_test(name, page, run)]
    errors += [f"the user manual does not explain {name}"
               for name in parameters if name not in pages["L0_resampling.txt"]]

    errors += constants_without_row(pages["Constants.txt"], values["constant"])

    errors += unknown_tests(pages["Promises.txt"], source / "test" / "L0_resampling")

    shown = set(re.findall(r"[\w.]+\.png", "".join(pages.values())))
    drawn = {path.name for path in (manual / "fig").glob("*.png")}
    errors += [f"there is no figure fig/{name}" for name in sorted(shown - drawn)]
    errors += [f"no page shows fig/{name}" for name in sorted(drawn - shown)]

    for error in errors:
        print("check_manual:", error, file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
