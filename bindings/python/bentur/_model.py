"""The tables of a case file as classes, under the file's own names (docs/case-file.md says what each key means).

What is left out is left to the case's defaults. Nothing is checked here: making the case checks all of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Numbers = float | Sequence[float] | NDArray[np.floating[Any]]
Table = Mapping[str, Any]


@dataclass(kw_only=True)
class Units:
    """``[units]``: length m cm mm in ft; force N kN MN kgf tf lbf kip; time is in s."""

    length: Literal["m", "cm", "mm", "in", "ft"] = "m"
    force: Literal["N", "kN", "MN", "kgf", "tf", "lbf", "kip"] = "N"
    gravity: float | None = None


@dataclass(kw_only=True)
class Section:
    """A section of a frame's members: width and depth, or area and inertia; and one of mass, density, unit_weight."""

    width: float | None = None
    depth: float | None = None
    area: float | None = None
    inertia: float | None = None
    mass: float | None = None
    density: float | None = None
    unit_weight: float | None = None


@dataclass(kw_only=True)
class Frame:
    """``[building.frame]``: a plane frame."""

    elastic_modulus: float
    storey_heights: Numbers
    bay_widths: Numbers
    columns: Sequence[Section | Table]
    beams: Sequence[Section | Table]
    floor_masses: Numbers | None = None
    floor_load: Table | None = None
    mass_matrix: Literal["consistent", "lumped"] | None = None
    condensation: Literal["static", "dynamic", "none"] | None = None
    base_coupling: bool | None = None


@dataclass(kw_only=True)
class Stick:
    """``[building.stick]``: a shear building; storeys with `yield_forces` yield."""

    storey_heights: Numbers
    masses: Numbers
    stiffnesses: Numbers
    yield_forces: Numbers | None = None
    hardening: Numbers | None = None
    hysteresis: Literal["bilinear", "peak-oriented"] | None = None
    unloading_exponent: float | None = None


@dataclass(kw_only=True)
class Matrices:
    """``[building.matrices]``: mass and stiffness from another program, floors × floors."""

    elevations: Numbers
    mass: ArrayLike
    stiffness: ArrayLike
    damping: ArrayLike | None = None


@dataclass(kw_only=True)
class Modal:
    """``[building.modal]``: known by its modes. `shapes` is modes × floors, or `shapes_file` a table floors × modes."""

    elevations: Numbers
    masses: Numbers
    periods: Numbers
    shapes: ArrayLike | None = None
    shapes_file: str | PathLike[str] | None = None


@dataclass(kw_only=True)
class Generic:
    """``[building.generic]``: known by little."""

    storeys: int
    storey_height: Numbers
    floor_mass: Numbers
    period: float | None = None
    period_formula: Table | None = None
    stiffness_ratio: float | None = None
    system: Literal["wall", "dual", "frame"] | None = None
    yield_base_shear: float | None = None
    hardening: float | None = None


@dataclass(kw_only=True)
class Isolation:
    """``[building.isolation]``: bearings below a slab."""

    mass: float
    stiffness: float | None = None
    characteristic_strength: float | None = None
    yield_displacement: float | None = None
    friction_pendulum: Table | None = None
    damping: float | None = None


@dataclass(kw_only=True)
class Soil:
    """``[building.soil]``: sway and rocking of the foundation."""

    foundation: Table
    sway: Table | None = None
    rocking: Table | None = None
    half_space: Table | None = None


@dataclass(kw_only=True)
class Building:
    """``[[building]]``: exactly one of frame, stick, matrices, modal, generic, or ``rigid=True``."""

    name: str
    damping: float | Table | None = None
    damping_stiffness: Literal["initial", "tangent"] | None = None
    frame: Frame | Table | None = None
    stick: Stick | Table | None = None
    matrices: Matrices | Table | None = None
    modal: Modal | Table | None = None
    generic: Generic | Table | None = None
    rigid: bool | None = None
    elevations: Numbers | None = None
    isolation: Isolation | Table | None = None
    soil: Soil | Table | None = None
    p_delta: bool | None = None
    gravity_loads: Numbers | None = None
    calibrate_period: float | None = None
    base_elevation: float | None = None
    width: float | None = None


@dataclass(kw_only=True)
class Contact:
    """``contact`` of a gap: one of the nine laws, with the keys it takes."""

    law: Literal[
        "linear",
        "kelvin-voigt",
        "kelvin-voigt-approach",
        "darmawan",
        "hertz",
        "hertz-damp",
        "jankowski",
        "bilinear",
        "restitution",
    ]
    stiffness: Numbers | Literal["axial"] | None = None
    restitution: Numbers | None = None
    damping_ratio: Numbers | None = None
    damping: Numbers | None = None
    damping_factor: Numbers | None = None
    alpha: Numbers | None = None
    second_stiffness: Numbers | None = None
    yield_penetration: Numbers | None = None
    release: Literal["zero-force", "separation", "creep"] | None = None
    calibration: Literal["exact", "published", "muthukumar-desroches", "ye"] | None = None


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
    """A branch lasts while ``constant + penetration·δ + speed·δ̇ ≥ 0``; then branch `then` follows (0: apart)."""

    then: int
    constant: float = 0.0
    penetration: float = 0.0
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


@dataclass(kw_only=True)
class Gap:
    """``[[gap]]`` between two neighbours. `contact` is one of the nine laws, or one of your own."""

    between: Sequence[str]
    width: Numbers
    contact: Contact | ForceLaw | BranchLaw | Table | None = None
    elevations: Numbers | None = None
    level_tolerance: float | None = None
    strikes_columns: bool | None = None
    column_capacity: Table | None = None


@dataclass(kw_only=True)
class Link:
    """``[[link]]``: springs, dampers and cables between two buildings."""

    between: Sequence[str]
    elevations: Numbers
    law: Literal["spring-dashpot", "yielding", "cable"]
    stiffness: Numbers | None = None
    damping: Numbers | None = None
    yield_force: Numbers | None = None
    hardening: Numbers | None = None
    slack: Numbers | None = None
    level_tolerance: float | None = None


@dataclass(kw_only=True)
class Excitation:
    """``[excitation]``. In place of `file` a record may be given as `values` every `time_step`, in `unit`.

    ``kind="spectrum"`` is for :func:`bentur.minimum_gap` alone.
    """

    kind: Literal["record", "harmonic", "none", "spectrum"]
    file: str | PathLike[str] | None = None
    values: ArrayLike | None = field(default=None, repr=False)
    format: str | None = None
    unit: str | None = None
    time_step: float | None = None
    column: int | None = None
    channel: int | None = None
    skip_lines: int | None = None
    polarity: Literal["as-recorded", "reversed"] | None = None
    pga: float | None = None
    scale: float | None = None
    period: float | None = None
    displacement_amplitude: float | None = None
    acceleration_amplitude: float | None = None
    phase: Literal["sine", "cosine"] | None = None
    delays: Numbers | None = None
    wave_velocity: float | None = None
    shape: Literal["asce-7-22", "sni-1726-2019", "en-1998-1", "table"] | None = None
    short_period: float | None = None
    one_second: float | None = None
    long_period: float | None = None
    ground_acceleration: float | None = None
    spectrum_type: Literal[1, 2] | None = None
    ground_type: Literal["A", "B", "C", "D", "E"] | None = None
    periods: Numbers | None = None
    accelerations: Numbers | None = None
    damping_ratio: float | None = None
    damping_correction: Literal["en-1998-1", "none"] | None = None
    modal_combination: Literal["cqc", "srss"] | None = None
    reduction: Numbers | None = None
    kinematics: Literal["relative", "absolute"] | None = None


@dataclass(kw_only=True)
class Initial:
    """``[initial]``: lists with one value per floor, by names of buildings."""

    displacements: Mapping[str, Numbers] | None = None
    velocities: Mapping[str, Numbers] | None = None


@dataclass(kw_only=True)
class Analysis:
    """``[analysis]``."""

    duration: float | None = None
    solver: Literal["exact", "adaptive", "runge-kutta"] | None = None
    tolerance: float | None = None
    step: float | None = None
    output_step: float | None = None
    limits: Table | None = None
    collapse_drift: float | None = None
    energy_audit: bool | None = None


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
