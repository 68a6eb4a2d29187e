"""Contact laws of your own, and how values of Python become the tables of a case."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core

Numbers = float | Sequence[float] | NDArray[np.floating[Any]]
Table = Mapping[str, Any]


@dataclass(kw_only=True)
class ForceLaw:
    """A contact law of your own: a function F(δ, δ̇).

    δ [length] > 0 is the penetration, δ̇ [length/s] the closing speed, F [force] pushes the floors apart; what is below
    zero counts as zero. F is to be smooth while δ > 0, for it is integrated by an embedded Runge-Kutta pair: by
    ``solver="adaptive"`` all the time, by ``"exact"`` while the floors touch.

    :param energy: a function of δ: what the contact would give back if it were unloaded slowly [force·length]; default
        the work of F(δ, 0). ``energy_lost`` is reckoned by it.
    """

    force: Callable[[float, float], float]
    name: str = "own"
    energy: Callable[[float], float] | None = None

    def _made(self) -> _core.ContactLaw:
        return _core.ForceLaw(self.name, self.force, self.energy)


@dataclass(kw_only=True)
class Guard:
    """A branch lasts while ``constant + deformation·δ + speed·δ̇ ≥ 0``; then branch `then` follows (0: apart)."""

    then: int
    constant: float = 0.0
    deformation: float = 0.0
    speed: float = 0.0


@dataclass(kw_only=True)
class Branch:
    """F = base + stiffness·δ + damping·δ̇, while every guard holds.

    :param touching: ``False``: no force is to be counted as an impact, as of a surface that has come apart.
    :param unloading_stiffness: [force/length] by which energy is given back; 0: `stiffness`.
    """

    guards: Sequence[Guard]
    base: float = 0.0
    stiffness: float = 0.0
    damping: float = 0.0
    touching: bool = True
    unloading_stiffness: float = 0.0


@dataclass(kw_only=True)
class BranchLaw:
    """A contact law of your own made of straight branches, so that ``solver="exact"`` has no time step for it either.

    A contact begins in branch 1, the first of the list; branch 0 is the floors apart.
    """

    branches: Sequence[Branch]
    name: str = "own"

    def _made(self) -> _core.ContactLaw:
        return _core.BranchLaw(self.name, list(self.branches))


OwnLaw = ForceLaw | BranchLaw


def table_of(value: Any) -> Any:
    """What a case is read from: classes become tables, keys that are None are left out."""
    if is_dataclass(value) and not isinstance(value, type):
        return {f.name: table_of(getattr(value, f.name)) for f in fields(value) if getattr(value, f.name) is not None}
    if isinstance(value, Mapping):
        return {key: table_of(one) for key, one in value.items() if one is not None}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [table_of(one) for one in value]
    return value
