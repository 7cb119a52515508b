#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the formulas of the manual readable without a network:

  place_formulas.py HTML_DIRECTORY [MATHJAX_DIRECTORY]

With MATHJAX_DIRECTORY, an installed MathJax 2, the parts of it that draw formulas are copied beside
the pages, where Doxygen was told to look for them; pages that have no formula do not load them.
Without it the pages show each formula as text, with Greek letters, indices and exponents, and ask
for no script.
"""

import html
import re
import shutil
import sys
from pathlib import Path

# What the pages load: TeX in, SVG out
MATHJAX_PARTS = ("MathJax.js", "extensions", "jax/element", "jax/input/TeX",
                 "jax/output/SVG/jax.js", "jax/output/SVG/config.js", "jax/output/SVG/autoload",
                 "jax/output/SVG/fonts/TeX")

MATHJAX_SCRIPT = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\n?'
                            r'|<script [^>]*MathJax\.js"[^>]*></script>\n?', re.DOTALL)
MACRO = re.compile(r'^\s*(\w+): "\{(.*)\}",?$', re.MULTILINE)
FORMULA = re.compile(r"\\\((.*?)\\\)|\\\[(.*?)\\\]", re.DOTALL)


SYMBOLS = {
    "alpha": "α", "beta": "β", "delta": "δ", "eta": "η", "theta": "θ", "kappa": "κ", "lambda": "λ",
    "mu": "μ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "chi": "χ", "psi": "ψ",
    "omega": "ω", "Delta": "Δ", "pm": "±", "mp": "∓",
    "sum": "Σ", "int": "∫", "nabla": "∇", "in": "∈", "notin": "∉", "le": "≤", "leq": "≤", "ge": "≥",
    "neq": "≠", "cdot": "·", "times": "×", "circ": "°", "leftarrow": "←", "Rightarrow": "⇒",
    "Leftrightarrow": "⇔", "lfloor": "⌊", "rfloor": "⌋", "min": "min", "max": "max", "cos": "cos",
    "sin": "sin", "exp": "exp", "quad": " ", "qquad": " ", "left": "", "right": "", "Big": ""}
GROUPS = [(r"\\t?frac\{([^{}]*)\} *\{([^{}]*)\}", r"(\1)/(\2)"),
          (r"\\sqrt\[(\w)\]\{([^{}]*)\}", r"<sup>\1</sup>√(\2)"),
          (r"\\sqrt\{([^{}]*)\}", r"√(\1)"),
          (r"\\(?:bar|overline) *\{?(\\[a-z]+|\w)\}?", "\\1\u0304"),
          (r"\\overline\{([^{}]*)\}", r"⟨\1⟩"),
          (r"\\hat *\{?(\\[a-z]+|\w)\}?", "\\1\u0302"),
          (r"\\begin\{\w+\}", "{ "), (r"\\end\{\w+\}", ""), (r" *&amp; *", " "),
          (r"\\(?:mathrm|text)\{([^{}]*)\}", r"\1"),
          (r"_\{([^{}]*)\}", r"<sub>\1</sub>"), (r"\^\{([^{}]*)\}", r"<sup>\1</sup>")]


def as_letters(formula):
    """A formula of TeX in HTML, without what draws fractions and roots."""
    for short, braced in ((r"([_^])(\\[A-Za-z]+|[\w+])", r"\1{\2}"),
                          (r"\\sqrt (\w)", r"\\sqrt{\1}"), (r"\\t?frac(\d)(\d)", r"\\frac{\1}{\2}"),
                          (r"\\\{", "\x01"), (r"\\\}", "\x02")):    # braces that are shown
        formula = re.sub(short, braced, formula)
    before = None
    while before != formula:    # from the innermost braces to the outer ones
        before = formula
        for pattern, text in GROUPS:
            formula = re.sub(pattern, text, formula)
    formula = re.sub(r"\\([A-Za-z]+)", lambda m: SYMBOLS.get(m[1], m[0]), formula)
    for command, text in ((r"\\\\", ";"), (r"\\\|", "‖"), (r"\\[,; ]", " "), (r"\\!", ""),
                          (r"\\_", "_"), ("\x01", "{"), ("\x02", "}")):
        formula = re.sub(command, text, formula)
    return formula


def copy_mathjax(mathjax, pages):
    target = pages / "mathjax"
    for part in MATHJAX_PARTS:
        source = mathjax / part
        (target / part).parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target / part, dirs_exist_ok=True)
        else:
            shutil.copyfile(source, target / part)


def with_formulas_as_text(page):
    """The page without MathJax, with the numbers of the code in their place."""
    settings = "".join(MATHJAX_SCRIPT.findall(page))
    macros = {name: html.escape(value) for name, value in MACRO.findall(settings)}

    def as_text(match):
        formula = match[1] if match[1] is not None else match[2]
        formula = re.sub(r"\\([A-Za-z]+)(?:\{\})?",
                         lambda m: macros.get(m[1], m[0]), " ".join(formula.split()))
        block = " l0DisplayedFormula" if match[1] is None else ""
        return f'<code class="l0Formula{block}">{as_letters(formula)}</code>'

    return FORMULA.sub(as_text, MATHJAX_SCRIPT.sub("", page))


def main():
    pages = Path(sys.argv[1])
    draw = len(sys.argv) > 2
    if draw:
        copy_mathjax(Path(sys.argv[2]), pages)
    for path in pages.glob("*.html"):
        page = path.read_text(encoding="utf-8")
        without_mathjax = MATHJAX_SCRIPT.sub("", page)
        if without_mathjax != page and not (draw and FORMULA.search(without_mathjax)):
            path.write_text(without_mathjax if draw else with_formulas_as_text(page),
                            encoding="utf-8")


if __name__ == "__main__":
    main()
