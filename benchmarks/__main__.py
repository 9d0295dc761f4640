"""Page of speeds: ``python -m benchmarks -o docs/benchmarks.md``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from benchmarks import forms, kernels, libraries, motion, native, page, propagate
from benchmarks.timing import ROUNDS

SECTIONS = {"kernels": kernels.section, "native": native.section, "libraries": libraries.section,
            "motion": motion.section, "propagate": propagate.section}


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure the kernels against peers.")
    parser.add_argument("-o", "--output", type=Path, help="also write the tables there, as Markdown")
    what = "measure these, and keep what is written of the others"
    parser.add_argument("--section", choices=SECTIONS, nargs="+", default=list(SECTIONS), help=what)
    options = parser.parse_args()
    output, kept = options.output, {}
    if output and output.exists():
        kept = page.sections(output.read_text(encoding="utf-8"))
    how = (
        f"NumPy {np.__version__}: medians of {ROUNDS} interleaved rounds, or of "
        f"{kernels.ROUNDS_OF_LARGE} for {kernels.LARGE:,} poses or more. SymPy, JAX in forward mode and complex "
        "steps differentiate the same maps as our derivatives. `called` is JAX without compilation, traced at every "
        "call. Ours fill one result; SymPy's functions return separate arrays of components, none for zeros and one "
        "for equal components. The copy floor is the time of a copy that fills such a result, a lower bound. A dash: "
        f"nothing to compare with, or SymPy needs minutes, or more than {forms.ROOM / 1e9:g} GB."
    )
    for name, measure in SECTIONS.items():
        if name in options.section:
            kept[name] = measure().rstrip()
            print(kept[name], end="\n\n", flush=True)
    if output:
        output.parent.mkdir(exist_ok=True)
        output.write_text(page.joined(f"{page.INTRODUCTION}\n{how}", kept), encoding="utf-8")


if __name__ == "__main__":
    main()
