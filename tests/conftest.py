"""Tests of PyTorch are deselected, and said to be, where it is not installed."""

from __future__ import annotations

import importlib.util

import pytest

TORCH = importlib.util.find_spec("torch") is not None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    left_out = [] if TORCH else [item for item in items if item.get_closest_marker("torch")]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in left_out]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if not TORCH:
        terminalreporter.write_line("deselected: tests marked torch, for PyTorch is not installed (extra 'torch')")
