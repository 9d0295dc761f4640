"""What a package takes that it had to refuse, or refuses in other words, is found before it is published."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from derive.codegen.validation.refusals import refuse

from derive.codegen.signatures import PUBLIC
from derive.codegen.validation.errors import ValidationFailed
from dualcay import cayley3


def without(name: str, error: type[Exception], words: str) -> Any:
    """cayley3 with a function that takes what raises this error with these words."""
    module = SimpleNamespace(**{function: getattr(cayley3, function) for function in PUBLIC})
    right: Callable[..., Any] = getattr(cayley3, name)

    def tolerant(*arguments: Any, **options: Any) -> Any:
        try:
            return right(*arguments, **options)
        except error as raised:
            if words not in str(raised):
                raise
            return np.zeros(6)

    tolerant.__signature__ = inspect.signature(right)  # type: ignore[attr-defined]
    setattr(module, name, tolerant)
    return module


def test_the_kernels_refuse_what_is_wrong() -> None:
    assert refuse(cayley3) > 100


@pytest.mark.parametrize(("name", "error", "words"), [
    ("pose", ValueError, "axis must be"),
    ("pose", ValueError, "v must have shape (..., 6)"),
    ("pose", ValueError, "v must have shape (6, ...)"),
    ("twist", ValueError, "v_dot must have shape"),
    ("twist", ValueError, "broadcast together"),
    ("compose", TypeError, "v1 must be real"),
    ("shadow", TypeError, "branch must be an integer"),
    ("from_quaternion", ValueError, "[0] is no "),
    ("from_tensor", ValueError, "[0] is no "),
    ("pose", TypeError, "out must be an array"),
    ("pose", ValueError, "out must have shape"),
    ("pose", TypeError, "out must be able to hold"),
])  # fmt: skip
def test_what_is_taken_for_right_is_noticed(name: str, error: type[Exception], words: str) -> None:
    with pytest.raises(ValidationFailed, match=f"{name} takes what it has to refuse"):
        refuse(without(name, error, words))


def test_other_words_are_noticed() -> None:
    module = without("pose", ZeroDivisionError, "")
    right = module.pose

    def silent(*arguments: Any, **options: Any) -> Any:
        try:
            return right(*arguments, **options)
        except ValueError:
            raise ValueError("no") from None

    silent.__signature__ = inspect.signature(right)  # type: ignore[attr-defined]
    module.pose = silent
    with pytest.raises(ValidationFailed, match="'axis must be' is not in 'no'"):
        refuse(module)
