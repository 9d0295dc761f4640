"""Wrapper that gives array-api kernels the interface of NumPy kernels: arguments and results are NumPy arrays."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from tests.support import traced

Convert = Callable[[np.ndarray], Any]


def _strict() -> Convert:
    import array_api_strict

    return array_api_strict.asarray


def _jax() -> Convert:
    import jax

    jax.config.update("jax_enable_x64", True)
    return jax.numpy.asarray


def _dask() -> Convert:
    import dask.array

    return lambda array: dask.array.from_array(array, chunks=2)


def _torch() -> Convert:
    import torch

    return lambda array: torch.asarray(np.array(array, order="C"))  # a writable copy, of a number too


def _torch_on_gpu() -> Convert:
    import torch

    return lambda array: torch.asarray(np.array(array, order="C"), device="cuda")


def _cupy() -> Convert:
    import cupy

    return cupy.asarray


LIBRARIES: dict[str, Callable[[], Convert]] = {
    "numpy": lambda: np.asarray,
    "array-api-strict": _strict,
    "jax": _jax,
    "jax traced": _jax,
    "dask": _dask,
    "torch": _torch,
    "torch on a GPU": _torch_on_gpu,
    "cupy": _cupy,
}


class Late:
    """Module that is imported at its first use, since JAX takes seconds in each process that collects tests."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # pytest asks every object of a test file for names of this kind
            raise AttributeError(name)
        return getattr(importlib.import_module(self._name), name)


jax, jaxlie, numba = Late("jax"), Late("jaxlie"), Late("numba")


def on_host(array: Any) -> np.ndarray:
    """Return an array of any library as a NumPy array, from the memory of a GPU too."""
    for copied in ("get", "cpu"):  # methods of CuPy and of PyTorch
        array = getattr(array, copied)() if hasattr(array, copied) else array
    return np.asarray(array)


QUICKLY = {"xla_backend_optimization_level": 0}
"""Options of XLA for quick compilation; tests do not need fast functions."""


class Through:
    """Kernel module that takes and returns NumPy arrays, but computes in another library."""

    def __init__(self, module: ModuleType, library: str) -> None:
        self.module, self.library, self.convert = module, library, LIBRARIES[library]()

    def __getattr__(self, name: str) -> Any:
        function = getattr(self.module, name)
        if not callable(function):
            return function

        def call(*values: Any, **options: Any) -> Any:
            if self.library == "jax traced":
                return traced.run(function, *values, **options)
            found = function(*(self.convert(v) if isinstance(v, np.ndarray) else v for v in values), **options)
            return tuple(map(on_host, found)) if isinstance(found, tuple) else on_host(found)

        return call
