"""Laws of your own, and how values of Python become the tables of a case."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from os import PathLike, fspath
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from . import _arguments
from ._errors import CaseError

_Pointer: Any = ctypes.CFUNCTYPE(None).__mro__[1]  # the class of all functions of ctypes

Numbers = float | Sequence[float] | NDArray[np.floating[Any]]
Table = Mapping[str, Any]


@dataclass(kw_only=True, slots=True)
class ForceLaw:
    """A contact law of your own: a function F(δ, δ̇).

    δ [length] > 0 is the penetration, δ̇ [length/s] the closing speed, F [force] pushes the floors apart; what is below
    zero counts as zero. F is to be smooth while δ > 0, for it is integrated by an embedded Runge-Kutta pair: by
    ``solver="adaptive"`` all the time, by ``"exact"`` while the floors touch.

    :param force: a function of Python, or, many times as fast, a compiled one of the signature ``double (double,
        double)``: what ``numba.cfunc`` makes, a function of ctypes with its ``argtypes`` and ``restype``, or
        ``scipy.LowLevelCallable`` of one. The compiled code has to live as long as the case.
    :param energy: a function of δ, of either kind: what the contact would give back if it were unloaded slowly
        [force·length]; default the work of F(δ, 0). ``energy_lost`` is reckoned by it.
    """

    force: Callable[[float, float], float] | Any
    name: str = "own"
    energy: Callable[[float], float] | Any | None = None
    stands_for_law: ClassVar[bool] = True


@dataclass(kw_only=True, slots=True)
class Guard:
    """A branch lasts while ``constant + deformation·δ + speed·δ̇ + force·F ≥ 0``; then branch `then` follows, counted
    from 1 (0: floors apart)."""

    then: int
    constant: float = 0.0
    deformation: float = 0.0
    speed: float = 0.0
    force: float = 0.0


@dataclass(kw_only=True, slots=True)
class Branch:
    """F = base + stiffness·δ + damping·δ̇, while every guard holds.

    :param base: None: whatever lets F go on from where the branch before has ended, as where a storey unloads.
    :param touching: of a contact; ``False``: no force is to be counted as an impact, as of a surface come apart.
    :param unloading_stiffness: [force/length] by which energy is given back; 0: `stiffness`.
    """

    guards: Sequence[Guard] = ()
    base: float | None = 0.0
    stiffness: float = 0.0
    damping: float = 0.0
    touching: bool = True
    unloading_stiffness: float = 0.0


@dataclass(kw_only=True, slots=True)
class BranchLaw:
    """A law of your own made of straight branches, so that ``solver="exact"`` has no time step for it either: of a
    contact, a link or the storeys of a stick (``gap[0].contact``, ``link[0].law``, ``stick.hysteresis``).

    A contact begins in branch 1, the first of the list; branch 0 is the floors apart, and every branch has a guard to
    end it. A link or storey is in branch 1 from the start; δ > 0 is what brings a link's buildings closer.

    Storeys have one law, told in units of each one's yield force and yield deformation, ``yield_forces`` and
    ``yield_forces/stiffnesses``: branch 1 is F = δ, with base 0 and stiffness 1.
    """

    branches: Sequence[Branch]
    name: str = "own"
    stands_for_law: ClassVar[bool] = True


OwnLaw = ForceLaw | BranchLaw


def address_of(function: Any, arguments: int) -> int:
    """Where the compiled code of a function of so many numbers is; 0 of a function of Python.

    :raises TypeError: when it is compiled for other types.
    """
    wanted = f"double ({', '.join(['double'] * arguments)})"
    if isinstance(function, tuple) and hasattr(function, "signature"):  # scipy.LowLevelCallable: a capsule and more
        if function.signature != wanted:
            raise TypeError(f"the compiled function is {function.signature!r}, must be {wanted!r}")
        capsule = tuple.__getitem__(function, 0)
        name = _capsule("PyCapsule_GetName", ctypes.c_char_p, ctypes.py_object)(capsule)
        return int(_capsule("PyCapsule_GetPointer", ctypes.c_void_p, ctypes.py_object, ctypes.c_char_p)(capsule, name))
    function = getattr(function, "ctypes", function)  # numba.cfunc
    if not isinstance(function, _Pointer):
        return 0
    kinds = [ctypes.c_double] * arguments
    if list(function.argtypes or ()) != kinds or function.restype is not ctypes.c_double:
        raise TypeError(f"the compiled function must have the argtypes and the restype of {wanted!r}")
    return int(ctypes.cast(function, ctypes.c_void_p).value or 0)


def _capsule(name: str, result: Any, *arguments: Any) -> Any:
    """A function of Python's own library."""
    return ctypes.PYFUNCTYPE(result, *arguments)((name, ctypes.pythonapi))


class Samples:
    """Accelerations of a record: handed on as they are, without a list of Python's."""

    stands_for_numbers: ClassVar[bool] = True

    def __init__(self, values: NDArray[np.float64]) -> None:
        self.values = values


def _samples(value: Any, key: str) -> Any:
    """Of a key that ends in ``values``, of which the case has one: a record's."""
    name = key if "." in key else f"excitation.{key}"
    try:
        given, what, rule = _arguments.accelerations(name, value)
    except (TypeError, ValueError):
        return value if isinstance(value, list) else np.asarray(value).tolist()  # the case says what is wrong
    if given is None:
        raise CaseError([("", 0, 0, f"{name} is {what}, {rule}", name, what, rule, "")])
    return Samples(given)


def table_of(value: Any, key: str = "") -> Any:
    """What a case is read from at a key: classes become tables, keys that are None are left out."""
    if isinstance(value, OwnLaw):
        return {"law": value} if key.endswith("contact") else value
    if key == "values" or key.endswith(".values"):
        return _samples(value, key)
    if is_dataclass(value) and not isinstance(value, type):
        value = {f.name: getattr(value, f.name) for f in fields(value)}
    if isinstance(value, Mapping):
        return {name: table_of(one, str(name)) for name, one in value.items() if one is not None}
    if isinstance(value, PathLike):
        return fspath(value)
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [table_of(one, key) for one in value]
    return value
