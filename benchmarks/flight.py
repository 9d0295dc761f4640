"""Stack, code size and deviations from MISRA C of the headers: ``python -m benchmarks.flight -o docs/howto/flight.md``.

The tables stand between two marks in the page. A cross compiler for Arm is taken where it is installed.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

from derive.codegen.build import print_package
from derive.codegen.rows import Table, inside
from derive.codegen.signatures import POSES, ROTATIONS
from derive.codegen.targets.c import C
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley
from derive.output import files

CHART = Cayley(2)
REAL = "float"
FLAGS = ("-std=c99", "-Os", "-fstack-usage", f"-DDUALCAY_REAL={REAL}")
ARM = ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16")
BEGIN, END = "<!-- measured by python -m benchmarks.flight -->\n", "<!-- end of what is measured -->\n"
MISRA = ("--addon=misra", "--std=c99", "--language=c", "--quiet", "--template={id}", "--max-configs=2")
"""Two configurations, hosted and freestanding; the others are of other compilers and languages, and show no more."""


def headers(folder: Path) -> None:
    """Write the headers of the chart, and a file for each table in which every function is external."""
    files.write(folder, print_package((CHART,), C(), tested=False).texts)
    for table in (POSES, ROTATIONS):
        text = f'#define DUALCAY_FUNCTION\n#include "{inside(table, f"{CHART.name}.h")}"\n'
        _source(folder, table).write_text(text, encoding="utf-8")


def _source(folder: Path, table: Table) -> Path:
    return folder / f"{table.name or 'poses'}.c"


def run(*command: object, folder: Path) -> str:
    return subprocess.run([*map(str, command)], cwd=folder, capture_output=True, text=True, check=True).stdout


def measured(folder: Path) -> str:
    """Return the table of stack and code size of each function, with the compiler and the symbols from outside."""
    arm = shutil.which("arm-none-eabi-gcc") is not None
    tools = "arm-none-eabi-" if arm else ""
    sizes: dict[str, dict[str, tuple[int, int]]] = {}
    outside: set[str] = set()
    static = 0
    for table in (POSES, ROTATIONS):
        source, flags = _source(folder, table), (*FLAGS, *(ARM if arm else ()))
        run(f"{tools}gcc", *flags, "-c", source.name, folder=folder)
        frames = dict(re.findall(r":(\w+)\t(\d+)\t\w+$", source.with_suffix(".su").read_text(), re.MULTILINE))
        symbols = run(f"{tools}nm", "-S", source.with_suffix(".o"), folder=folder)
        outside |= set(re.findall(r" U (\w+)$", symbols, re.MULTILINE))
        _, counted = run(f"{tools}size", source.with_suffix(".o"), folder=folder).splitlines()
        static += sum(map(int, counted.split()[1:3]))
        bytes_of = {name: int(size, 16) for size, name in re.findall(r"^\w+ (\w+) \w (\w+)$", symbols, re.MULTILINE)}
        for row in (*table.public.values(), *table.composed.values()):
            name = f"{prefix(CHART, table)}_{row.name}"
            sizes.setdefault(row.source, {})[table.name] = (bytes_of[name], int(frames[name]))
    compiler = run(f"{tools}gcc", "--version", folder=folder).splitlines()[0]
    lines = [
        f"`{CHART.name}`, {REAL}, {compiler}, `{' '.join((*FLAGS[:2], *(ARM if arm else ())))}`. From outside: "
        f"{', '.join(f'`{name}`' for name in sorted(outside))}. Static data: {static} bytes. These "
        "functions of the library need stack of their own. A function of the table calls no other, so its frame is all "
        "that it uses.\n",
        "| function | poses: code | stack | rotations: code | stack |", "|---|---|---|---|---|",
    ]  # fmt: skip
    for name, found in sizes.items():
        cells = (f"{found[key][0]} | {found[key][1]}" if key in found else " | " for key in ("", "rotation"))
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join([*lines, ""])


def deviations(folder: Path) -> Counter[str]:
    """Return the rules of MISRA C:2012 that cppcheck's addon reports, with the number of places."""
    done = subprocess.run(["cppcheck", *MISRA, "poses.c"], cwd=folder, capture_output=True, text=True, check=True)
    return Counter(re.findall(r"misra-c2012-([\d.]+)", done.stderr))


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure the C headers for flight software.")
    parser.add_argument("-o", "--output", type=Path, help="replace the tables of this page")
    output = parser.parse_args().output
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        headers(folder)
        found = ", ".join(f"{rule} ({count})" for rule, count in deviations(folder).most_common())
        text = f"{measured(folder)}\nPlaces by rule of MISRA C:2012 in the headers for poses: {found}.\n"
    print(text)
    if output:
        before, rest = output.read_text(encoding="utf-8").split(BEGIN)
        files.put(output, before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1])


if __name__ == "__main__":
    main()
