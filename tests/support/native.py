"""Build of the compiled NumPy functions of some charts, in a folder from which kernels can load them.

As a script with a folder as argument, this module builds the functions of all committed charts there.
"""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from unittest.mock import patch

import numpy as np

import dualcay
from derive.codegen import catalogue
from derive.codegen.build import print_package
from derive.codegen.package import Data, Target
from derive.codegen.rows import Table
from derive.codegen.targets import TARGETS
from derive.codegen.targets.native import Native
from derive.maps.chart import Chart
from derive.output import files
from tests.support.layouts import BATCHES, require_strides_of_one_ignored
from tests.support.signatures import components_first, components_last

PLAIN = ("optimization=0", "c_args=-DDUALCAY_CORE=static")
"""Options without vector code and inlined cores, which would make compilation forty times slower."""


class Few(Native):
    """Target with the loops of a few kernels, which compile in seconds."""

    def __init__(self, kernels: Collection[str]) -> None:
        self.kernels = kernels

    def loops(self, table: Table) -> Data:
        data = super().loops(table)
        return {**data, "loops": [each for each in data["loops"] if each["name"] in self.kernels]}


def build(
    place: Path, charts: Iterable[Chart], *options: str, only: str = "", native: Target = TARGETS["native"]
) -> None:
    """Build the package, for one table or all, with options of Meson; install it in the subfolder ``site``."""
    source = place / "source"
    texts = print_package([*charts], native, tested=False).texts  # the C target has the same differential test
    modules = (name for name in texts if name.endswith(".c"))
    for name in [name for name in modules if only and not name.startswith(f"{only}/")]:
        del texts[name]
    files.write(source, texts)
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-deps", "--no-index")
    setup = [f"-Csetup-args=-D{option}" for option in options]
    done = subprocess.run(
        [*pip, *setup, "--target", place / "site", source],
        env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


@contextmanager
def found(name: str, site: Path) -> Iterator[str]:
    """Import the committed kernels again under another name, with the compiled functions of a folder."""
    for kind in (dualcay, dualcay.rotation):
        kind.backend()  # looks for compiled functions in every module, without success
    with patch.object(sys, "path", [str(site), *sys.path]), patch.dict(os.environ, DUALCAY_NATIVE="1"):
        root = Path(dualcay.__file__).parent
        places = [str(root)]
        spec = importlib.util.spec_from_file_location(name, root / "__init__.py", submodule_search_locations=places)
        assert spec is not None
        assert spec.loader is not None
        sys.modules[name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[name])
        yield name
    for loaded in [key for key in sys.modules if key.split(".")[0] in (name, "dualcay_native")]:
        del sys.modules[loaded]


def require_one_in_all_layouts(function: Callable[..., np.ndarray], values: list[np.ndarray], shape: tuple[int, ...]):
    """Require equal results of gathered tiles, rows in place and single poses; all run one loop without contraction."""
    rank = len(shape)
    last = function(*values)
    first = function(*(components_first(a, a.ndim - 1) for a in values), axis=0)
    spread = function(*(np.repeat(a, 2, axis=0)[::2] for a in values))
    turned = function(*(a.reshape(10, 15, *a.shape[1:]).swapaxes(0, 1) for a in values))
    assert last.flags.c_contiguous
    assert turned.flags.c_contiguous  # by default NumPy keeps the layout of the argument
    np.testing.assert_array_equal(turned.swapaxes(0, 1).reshape(last.shape), last)
    np.testing.assert_array_equal(components_last(first, rank), last)
    np.testing.assert_array_equal(spread, last)
    np.testing.assert_array_equal(function(*(a[70] for a in values)), last[70])
    for batch in BATCHES:
        given = [np.resize(a, batch + a.shape[1:]) for a in values]
        turned = [components_first(a, a.ndim - len(batch)) for a in given]
        require_strides_of_one_ignored(function, given, np.testing.assert_array_equal)
        require_strides_of_one_ignored(partial(function, axis=0), turned, np.testing.assert_array_equal)


if __name__ == "__main__":
    build(Path(sys.argv[1]), catalogue.committed(), *PLAIN)
