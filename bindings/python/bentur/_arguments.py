"""Arguments of functions, checked before they are handed on: what is wrong is named as the caller named it."""

from __future__ import annotations

import numbers
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray


def path(name: str, value: Any) -> str:
    """The name of a file or folder."""
    try:
        text = os.fspath(value)
    except TypeError:
        raise TypeError(f"{name} is a {_kind(value)}, must be the name of a file (text or os.PathLike)") from None
    if isinstance(text, bytes):
        text = os.fsdecode(text)
    if not text:
        raise ValueError(f'{name} = "", must be the name of a file')
    return str(text)


def number(name: str, value: Any) -> float:
    if isinstance(value, bool) or not (isinstance(value, numbers.Real) or hasattr(value, "__float__")):
        raise TypeError(f"{name} is a {_kind(value)}, must be a number")
    return float(value)


def positive(name: str, value: Any) -> float:
    found = number(name, value)
    if not 0 < found < float("inf"):
        raise ValueError(f"{name} = {found:g}, must be > 0")
    return found


def whole(name: str, value: Any, least: int, most: int = 2**63 - 1) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name} is a {_kind(value)}, must be a whole number")
    found = int(value)
    if not least <= found <= most:
        raise ValueError(f"{name} = {found}, must be from {least} to {most}")
    return found


def listed(name: str, value: Any) -> list[float]:
    """A list of numbers."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        raise TypeError(f"{name} is a {_kind(value)}, must be a list of numbers")
    return [number(f"{name}[{i}]", one) for i, one in enumerate(value)]


def accelerations(name: str, value: Any) -> tuple[NDArray[np.float64] | None, str, str]:
    """The numbers of a record, straight from an array, or nothing, what they are and the rule that this breaks.

    A table is none: which of its columns is meant is not known, and read row by row it would be another record.

    :raises TypeError: where they are no numbers.
    :raises ValueError: where texts are no numbers.
    """
    found = np.asanyarray(value)
    if np.iscomplexobj(found):
        raise TypeError(f"{name} is complex, must be numbers")
    masked = int(np.count_nonzero(getattr(found, "mask", False)))  # of a MaskedArray
    if masked:
        return None, f"{masked} masked values", "must be one list of accelerations: fill them in"
    given = np.asarray(found, dtype=np.float64)
    if given.ndim == 2 and given.shape[1] == 1:
        given = given[:, 0]  # a column
    if given.ndim != 1:
        shape = " × ".join(map(str, given.shape)) or "a single number"
        hint = f": give one column, as {name.rpartition('.')[2]}[:, 1]" if given.ndim == 2 else ""
        return None, shape, "must be one list of accelerations" + hint
    return np.ascontiguousarray(given), "", ""


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is a {_kind(value)}, must be a text")
    return value


def mapping(name: str, value: Any, of: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise TypeError(f"{name} is a {_kind(value)}, must be {of}")
    return value


def one_of(name: str, value: Any, allowed: Sequence[str]) -> str:
    if text(name, value) not in allowed:
        raise ValueError(f'{name} = "{value}", must be one of: {", ".join(allowed)}')
    return str(value)


def _kind(value: Any) -> str:
    return "None" if value is None else type(value).__name__
