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
    """``[units]``: length m cm mm in ft; force N kN MN kgf tf lbf kip; time is in s.

    Keys:

    - ``length``: ``"m"`` ``"cm"`` ``"mm"`` ``"in"`` ``"ft"``; default ``"m"``
    - ``force``: ``"N"`` ``"kN"`` ``"MN"`` ``"kgf"`` ``"tf"`` ``"lbf"`` ``"kip"``; default ``"N"``
    - ``gravity``: > 0 [length/s²]; turns g and unit weights into accelerations and masses; default 9.80665 m/s²,
      converted
    """

    length: Literal["m", "cm", "mm", "in", "ft"] = "m"
    force: Literal["N", "kN", "MN", "kgf", "tf", "lbf", "kip"] = "N"
    gravity: float | None = None


@dataclass(kw_only=True)
class Section:
    """A section of a frame's members: width and depth, or area and inertia; and one of mass, density, unit_weight.

    From ``structure/plane_frame.h``:

    A prismatic member: one column of one storey, one beam of one bay.

    Keys:

    - ``width``, ``depth``: > 0 [length], depth in the plane of the frame; or
    - ``area``, ``inertia``: > 0 [length²], > 0 [length⁴]; exactly one of the two pairs
    - ``mass``: ≥ 0 [mass] of the whole member: one column of one storey, one beam of one bay; or
    - ``density``: ≥ 0 [mass/length³]; or
    - ``unit_weight``: ≥ 0 [force/length³]; exactly one of the three
    """

    width: float | None = None
    depth: float | None = None
    area: float | None = None
    inertia: float | None = None
    mass: float | None = None
    density: float | None = None
    unit_weight: float | None = None


@dataclass(kw_only=True)
class Frame:
    """``[building.frame]``: a plane frame.

    From ``structure/plane_frame.h``:

    A plane frame of `storeys × bays` rectangular cells, fixed at the base, members axially rigid: one sway per floor,
    one rotation per joint (monograph 2.5, 4.1).

    Keys:

    - ``elastic_modulus``: > 0 [force/length²]
    - ``storey_heights``: list, > 0 [length], bottom to top
    - ``bay_widths``: list, > 0 [length], left to right
    - ``columns``: list of sections: one for all, or one per storey
    - ``beams``: list of sections: one for all, or one per floor
    - ``floor_masses``: number or list, ≥ 0 [mass], one per floor, added to the floor's sway (slab, live load);
      default zeros
    - ``floor_load``: ``{ pressure, width }``: a load q ≥ 0 [force/length²] on a strip w > 0 [length] of every
      floor, each a number or a list with one per floor; default none
    - ``mass_matrix``: ``"consistent"`` or ``"lumped"`` (half of each column to the floors it joins, rotations
      without mass); default ``"consistent"``
    - ``condensation``: ``"static"``, ``"dynamic"`` (first mode exact) or ``"none"`` (joint rotations stay); default
      ``"static"``
    - ``base_coupling``: ``true``: the mass coupling between base and ground storey counts; ``false``: it is
      dropped; default ``true``
    """

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
    """``[building.stick]``: a shear building; storeys with `yield_forces` yield.

    From ``structure/stick.h``:

    A shear building: one mass and one lateral spring per storey.

    Keys:

    - ``storey_heights``: list, > 0 [length], one per storey, bottom to top
    - ``masses``: list, > 0 [mass], one per floor
    - ``stiffnesses``: list, > 0 [force/length], one per storey
    - ``yield_forces``: number or list, > 0 [force], one per storey: V_y, the shear at which the storey yields;
      ``inf``: it stays elastic; default none yields
    - ``hardening``: number or list, in [0, 1), one per storey: stiffness after yielding over that before; default 0
    - ``hysteresis``: ``"bilinear"``: kinematic hardening; ``"peak-oriented"``: unloads, then heads for the largest
      drift so far (concrete); default ``"bilinear"``
    - ``unloading_exponent``: in [0, 1], of ``"peak-oriented"`` only: it unloads with k (Δ_y/Δ_max)^a, a this
      exponent; default 0
    """

    storey_heights: Numbers
    masses: Numbers
    stiffnesses: Numbers
    yield_forces: Numbers | None = None
    hardening: Numbers | None = None
    hysteresis: Literal["bilinear", "peak-oriented"] | None = None
    unloading_exponent: float | None = None


@dataclass(kw_only=True)
class Matrices:
    """``[building.matrices]``: mass and stiffness from another program, floors × floors.

    Keys:

    - ``elevations``: list, > 0 and ascending [length], of the floors above the own base
    - ``mass``: n rows of n numbers [mass], or a list of n: the diagonal
    - ``stiffness``: n rows of n numbers [force/length]
    - ``damping``: n rows of n numbers [force·s/length]; in place of ``building.damping``
    """

    elevations: Numbers
    mass: ArrayLike
    stiffness: ArrayLike
    damping: ArrayLike | None = None


@dataclass(kw_only=True)
class Modal:
    """``[building.modal]``: known by its modes. `shapes` is modes × floors, or `shapes_file` a table floors × modes.

    From ``structure/known/modal.h``:

    A building known by its modes: from another program, or from a vibration test.

    Shapes made M-orthonormal in the symmetric way, Φ ← Φ (ΦᵀMΦ)^−½ after scaling each to unit modal mass; K = M Φ Ω²
    Φᵀ M. With fewer modes than floors the building moves in these alone. (L-4)

    Keys:

    - ``elevations``: list, > 0 and ascending [length], of the floors above the own base
    - ``masses``: list, > 0 [mass], one per floor
    - ``periods``: list, > 0 [s], of as many modes as are known, at most one per floor
    - ``shapes``: one list per mode, floors bottom to top, of any scale; or
    - ``shapes_file``: a table beside the case, named relative to it: a row per floor, a column per mode; exactly
      one of the two
    """

    elevations: Numbers
    masses: Numbers
    periods: Numbers
    shapes: ArrayLike | None = None
    shapes_file: str | PathLike[str] | None = None


@dataclass(kw_only=True)
class Generic:
    """``[building.generic]``: known by little.

    From ``structure/known/generic.h``:

    A building of which little is known: a cantilever of flexural and shear stiffness [MirandaTaghavi2005], lumped at
    its floors.

    K of a prismatic cantilever beam (rotations condensed) of bending stiffness EI, and of a chain of shear springs
    GA/h_j with α² = GA H²/EI, scaled so that the first period is T₁.

    Keys:

    - ``storeys``: whole number, 1 to 1000
    - ``storey_height``: number or list, > 0 [length], one per storey
    - ``floor_mass``: number or list, > 0 [mass], one per floor
    - ``period``: > 0 [s]: the first period; or
    - ``period_formula``: ``{ coefficient, exponent }``, both > 0: T₁ = coefficient · H^exponent with the height H
      in metres, as codes have it; exactly one of the two
    - ``stiffness_ratio``: α = H √(GA/EI) ≥ 0: 0 bends only, 30 and more shears only; or
    - ``system``: ``"wall"`` (α = 1), ``"dual"`` (4), ``"frame"`` (12); exactly one of the two
    - ``yield_base_shear``: > 0, share of the weight: the shear springs yield, each in proportion to its shear in
      the first mode; needs ``stiffness_ratio`` ≥ 30; default none yields
    - ``hardening``: in [0, 1), goes with ``yield_base_shear``; default 0
    """

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
    """``[building.isolation]``: bearings below a slab.

    From ``structure/support.h``:

    Bearings below a slab: one more floor, at the base, the first of all lists.

    ::

        V = (L-1) with k = stiffness + Q/Δ_y, r = stiffness/k, V_y = Q + stiffness Δ_y; linear where Q = 0.

    Keys:

    - ``mass``: > 0 [mass] of the slab; the lower halves of a frame's lowest columns join it
    - ``stiffness``: > 0 [force/length] after yielding; alone, of a linear bearing
    - ``characteristic_strength``: Q ≥ 0 [force]: the force where the yielding branch crosses zero displacement;
      default 0: linear
    - ``yield_displacement``: Δ_y > 0 [length], goes with Q: the stiffness before yielding is ``stiffness`` + Q/Δ_y
    - ``friction_pendulum``: ``{ coefficient, radius, yield_displacement }``, all > 0, in place of these three: Q =
      μW, stiffness W/R, W all weight above, the slab's too
    - ``damping``: ≥ 0 [force·s/length] of a dashpot beside them; default 0
    """

    mass: float
    stiffness: float | None = None
    characteristic_strength: float | None = None
    yield_displacement: float | None = None
    friction_pendulum: Table | None = None
    damping: float | None = None


@dataclass(kw_only=True)
class Soil:
    """``[building.soil]``: sway and rocking of the foundation.

    From ``structure/support.h``:

    Sway and rocking of a foundation on springs and dashpots (L-3).

    G = ρ v_s², k_h = 8 G r/(2 − ν), c_h = 4.6 ρ v_s r²/(2 − ν), k_r = 8 G r³/(3(1 − ν)), c_r = 0.8 r⁴ √(ρ G)/((1 −
    ν)(1 + B_r)), B_r = 3(1 − ν) I_f/(8 ρ r⁵) [RichartHallWoods1970].

    Keys:

    - ``sway``: ``{ stiffness, damping }`` [force/length, force·s/length], > 0 and ≥ 0 (default 0)
    - ``rocking``: ``{ stiffness, damping }`` [force·length, force·length·s], likewise
    - ``half_space``: ``{ shear_wave_velocity, density, poisson, radius }``, in place of these two: a rigid disc on
      the surface of an elastic half-space (theory); ``poisson`` in [0, 0.5], the others > 0
    - ``foundation``: ``{ mass, inertia }``, both > 0 [mass, mass·length²]; the lower halves of a frame's lowest
      columns join it
    """

    foundation: Table
    sway: Table | None = None
    rocking: Table | None = None
    half_space: Table | None = None


@dataclass(kw_only=True)
class Building:
    """``[[building]]``: exactly one of frame, stick, matrices, modal, generic, or ``rigid=True``.

    Keys:

    - ``name``: text of one line, not empty, different from the others
    - ``damping``: see Damping
    - ``damping_stiffness``: ``"initial"`` or ``"tangent"``, where storeys yield: see Damping; default ``"initial"``
    - ``frame``, ``stick``, ``matrices``, ``modal``, ``generic``: exactly one
    - ``rigid``: ``true``: a wall that moves with the ground, with no other key but ``elevations`` and
      ``base_elevation``; default ``false``
    - ``elevations``: of a wall alone: list, ascending [length], where it can be struck
    - ``isolation``: bearings below a slab; default none
    - ``soil``: soil that lets the foundation sway and rock; not with ``isolation``; default none
    - ``p_delta``: ``true``: the floors' weights soften the building; default ``false``
    - ``gravity_loads``: list, ≥ 0 [force], one per floor (of the structure: none for a slab), in place of
      ``p_delta``; default none
    - ``calibrate_period``: > 0 [s]: the stiffness is scaled until the first period is this, on a fixed base and
      without gravity loads; ``axial`` contact stiffness is not scaled; default none
    - ``base_elevation``: [length] of the base above the common datum; default 0
    - ``width``: > 0 [length], for ``wave_velocity`` only; not for a frame, whose width is the sum of its bays;
      default none
    """

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
    """``contact`` of a gap: one of the nine laws, with the keys it takes.

    From ``contact/laws/linear.h``:

    Linear spring across a gap.

    ::

        F = k δ for δ > 0,   F = 0 for δ ≤ 0.   (3-3)

    k [force/length] contact stiffness, > 0. Stores and returns: e = 1, no energy is lost. A free impact of masses m₁,
    m₂ lasts π √(m_e/k), m_e = m₁ m₂/(m₁ + m₂), and peaks at F = v₀ √(k m_e). Branches: 0 apart | 1 pushing. Source:
    monograph (3-3), with (3-4) for k (axial_stiffness.h).

    From ``contact/laws/kelvin_voigt.h``:

    Linear spring and dashpot in parallel.

    ::

        F = k δ + c δ̇,   c = 2 ξ √(k m_e).   (C-11)

    k [force/length] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0. c [force·s/length].
    The force jumps to c v₀ when the bodies meet. Since the dashpot would pull in the end, a contact ends in one of
    three ways:

    ::

        zero_force  F = max(0, k δ + c δ̇), without memory.
          0 apart | 1 pushing | 2 released: δ > 0, F = 0, not touching; a new push begins where k δ + c δ̇ > 0.
        separation  at δ = 0; F < 0 before. Needs ξ < 1: with more damping free bodies never come apart (C-15).
          0 apart | 1 touching
        creep       at F = 0; the dented surface then recovers, δ_s = δ_s0 exp(−k t/c) (3.16), and contact begins again
                    where the bodies meet it.
          0 apart | 1 touching | 2 receding | 3 nearing the surface. 2 and 3 are both apart from it: while k δ + c δ̇ ≤ 0
          (2) the bodies cannot catch up with it (C-14), so it is watched in 3 alone. memory = δ_s at the start of 2 or 3
          [length]; once the dent is less than the round-off of its start, 0 follows 2.
        Without damping all three are the linear spring, and 2 and 3 are never reached.

    e of a free impact follows from ξ alone: (C-13) for zero_force and creep, (C-15) for separation. Calibrations,
    given e: exact, and published (C-16). Source: [Anagnostopoulos1988]; monograph (3.8)-(3.18); max(0, ·) is ours.

    From ``contact/laws/kelvin_voigt_approach.h``:

    Linear spring, with a dashpot while the bodies close.

    ::

        F = k δ + c δ̇ while δ̇ > 0,   F = k δ after,   c = 2 ξ √(k m_e).   (C-7)

    k [force/length] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0. e of a free impact
    follows from ξ alone: (C-9) with n = 1. Calibrations, given e: exact (C-9), published (C-17). The force jumps to c
    v₀ when the bodies meet; it never pulls. Branches: 0 apart | 1 closing | 2 rebound. 1 and 2 follow one another
    within one impact as the bodies are driven. Source: [MahmoudJankowski2011].

    From ``contact/laws/darmawan.h``:

    Linear spring whose stiffness grows with the closing speed.

    ::

        F = k δ (1 + α δ̇), cut at 0.   (3.19)

    k [force/length] stiffness, > 0. α [s/length] ≥ 0. The force has no jump at either end of an impact. e of a free
    impact depends on its closing speed: (C-6) with d = α v₀. Branches: 0 apart | 1 pushing | 2 cut: parting faster
    than 1/α, still touching, F = 0. A free impact never gets to 2. 1 is nonlinear unless α = 0. Beyond its guards
    force() goes on as the same polynomial. Source: monograph (3.19); the cut is ours.

    From ``contact/laws/hertz.h``:

    Elastic contact of curved surfaces.

    ::

        F = β δ^1.5 for δ > 0,   F = 0 for δ ≤ 0.   (C-3)

    β [force/length^1.5] stiffness, > 0. Stores and returns: e = 1, no energy is lost. A free impact reaches δ_max =
    (5 m_e v₀²/(4 β))^(2/5) and lasts 2.94328 δ_max/v₀ (C-4). Branches: 0 apart | 1 pushing, nonlinear. Source:
    [Hertz1882]; as a law of pounding [MuthukumarDesRoches2006].

    From ``contact/laws/hertz_damp.h``:

    Hertz contact with a damping force that grows with the penetration.

    ::

        F = β δ^1.5 (1 + d δ̇/v₀), cut at 0.   (C-5)

    β [force/length^1.5] stiffness, > 0. d [-] damping factor, ≥ 0. v₀ [length/s] closing speed at the start of this
    contact, or the least that a solver tells of (needs_closing_speed()); where it gives no scale (v₀ ≤ 0, or d/v₀
    beyond the largest number) the contact is the plain Hertz one. e of a free impact follows from d alone (C-6).
    Calibrations, given e: exact (C-6), muthukumar-desroches (C-19), ye (C-20). Branches: 0 apart | 1 pushing,
    nonlinear | 2 cut: parting faster than v₀/d, still touching, F = 0. A free impact never gets to 2. Beyond its
    guards force() goes on by the same formula, and as 0 where δ < 0. Not bounded: a contact that begins at a crawl
    and is then driven fast has d δ̇/v₀ ≫ 1, and a force to match. Source: [LankaraniNikravesh1990],
    [MuthukumarDesRoches2006]; the cut is ours.

    From ``contact/laws/jankowski.h``:

    Nonlinear viscoelastic contact: Hertz, with a dashpot while the bodies close.

    ::

        F = β δ^1.5 + c̄ δ̇ while δ̇ > 0,   F = β δ^1.5 after,   c̄ = 2 ξ √(β √δ m_e).   (C-8)

    β [force/length^1.5] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0. e of a free
    impact follows from ξ alone: (C-9) with n = 3/2. Calibrations, given e: exact (C-9), published (C-18). The force
    has no jump, but it leaves zero as δ^¼, with a vertical tangent. Branches: 0 apart | 1 closing, nonlinear | 2
    rebound, nonlinear. 1 and 2 follow one another within one impact as the bodies are driven. Beyond its guards
    force() goes on by the same formula, and as 0 where δ < 0. Source: [Jankowski2005], [Jankowski2006].

    From ``contact/laws/bilinear.h``:

    Spring that yields: k₁ up to a penetration δ_y, k₂ beyond; it unloads along k₁ down to the line k₂ δ.

    ::

        F = k₂ δ + f,   ḟ = (k₁ − k₂) δ̇ inside, 0 at, the limits of   0 ≤ f ≤ (k₁ − k₂) δ_y.   (C-22)

    k₁ [force/length] stiffness, > 0. k₂ [force/length] second stiffness, 0 < k₂ ≤ k₁. δ_y [length] yield penetration,
    > 0. A free impact that gets to δ_max > δ_y loses (k₁ − k₂) δ_y (δ_max − δ_y) (C-23). f is forgotten when contact
    ends. Branches: 0 apart | 1 elastic: f = memory + (k₁ − k₂) δ | 2 yielding: f at its upper limit | 3 on the line
    k₂ δ: f = 0. memory [force] ≤ 0. With k₂ = k₁ it is the linear spring, and 2 and 3 are never reached. Source:
    [Muthukumar2003] for loading and unloading; the closed parallelogram, which also says what becomes of a reversal
    part-way, is our reading.

    From ``contact/laws/restitution.h``:

    An impact that takes no time: the stereomechanical law.

    ::

        δ̇⁺ = −e δ̇⁻, momentum kept.   (C-24)

    e [-] coefficient of restitution, 0 < e ≤ 1. The law has no force of its own. A solver changes the velocities when
    a contact closes; the force of a contact that stays closed is what keeps its opening at zero. Branches: 0 apart |
    1 resting: touching, without guards; the solver finds the force, and takes next() when it would have to pull. From
    branch 0 next() leads to rest; a solver that lets the bodies rebound leaves the state as it is. Source:
    [Goldsmith1960].

    Keys:

    - ``"linear"``: k δ; ``stiffness`` k
    - ``"kelvin-voigt"``: k δ + c δ̇, c = 2ξ√(k m_e); ``stiffness`` k and one of ``restitution``, ``damping_ratio``
      ξ, ``damping`` c
    - ``"kelvin-voigt-approach"``: k δ + c δ̇ while closing, k δ after; ``stiffness`` k and one of ``restitution``,
      ``damping_ratio`` ξ
    - ``"darmawan"``: k δ (1 + α δ̇); ``stiffness`` k, ``alpha`` α
    - ``"hertz"``: β δ^1.5; ``stiffness`` β
    - ``"hertz-damp"``: β δ^1.5 (1 + d δ̇/v₀); ``stiffness`` β and one of ``restitution``, ``damping_factor`` d
    - ``"jankowski"``: β δ^1.5 + 2ξ√(β√δ m_e) δ̇ while closing, β δ^1.5 after; ``stiffness`` β and one of
      ``restitution``, ``damping_ratio`` ξ
    - ``"bilinear"``: slope k₁ up to δ_y, k₂ beyond; unloads along k₁ down to k₂ δ; ``stiffness`` k₁,
      ``second_stiffness`` k₂, ``yield_penetration`` δ_y
    - ``"restitution"``: an impact takes no time: δ̇ becomes −e δ̇, momentum is kept; ``restitution`` e
    - ``stiffness``: k, k₁ > 0 [force/length], or β > 0 [force/length^1.5]; ``"axial"``, for k and k₁ between two
      frames: 1/k = 1/K₁ + 1/K₂ with K = EA/(L/2) of the floor beams next to the gap
    - ``restitution``: e in (0, 1]: the separation speed of a free impact over its closing speed
    - ``damping_ratio``: ξ ≥ 0; below 1 with ``release = "separation"``
    - ``damping``: c ≥ 0 [force·s/length]; below the critical 2√(k m_e) with ``release = "separation"``
    - ``damping_factor``: d ≥ 0 [-]
    - ``alpha``: α ≥ 0 [s/length]
    - ``second_stiffness``: k₂ [force/length], > 0 and at most ``stiffness``
    - ``yield_penetration``: δ_y > 0 [length]
    - ``release``: says when a Kelvin-Voigt contact ends: ``"zero-force"`` (default: when the force has come down to
      zero, F = max(0, k δ + c δ̇)), ``"separation"`` (when the floors come apart, δ = 0; before that the dashpot
      pulls), or ``"creep"`` (the force ends at zero, then the surface recovers as exp(−k t/c), and a new contact
      begins where the floors meet it)
    - ``calibration``: goes with ``restitution`` and says how the law's parameter follows from it: ``"exact"``
      (default: a free impact has just this restitution), or a formula of the literature: ``"published"`` for
      ``kelvin-voigt`` (Anagnostopoulos 1988), ``kelvin-voigt-approach`` (Mahmoud & Jankowski 2011) and
      ``jankowski`` (Jankowski 2006), ``"muthukumar-desroches"`` or ``"ye"`` for ``hertz-damp``
    """

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


@dataclass(kw_only=True)
class Gap:
    """``[[gap]]`` between two neighbours. `contact` is one of the nine laws, or one of your own.

    Keys:

    - ``between``: the names of the two neighbours, left one first
    - ``width``: number or list, ≥ 0 [length], one per contact point
    - ``elevations``: list, ascending [length]: where the buildings can touch; both need a floor there; ``[]``: no
      contact is modelled; default every elevation where both have a floor
    - ``level_tolerance``: ≥ 0 [length]: floors this close in height meet, at the mean of their elevations; default
      a tenth of the smallest storey height at those floors
    - ``strikes_columns``: ``true``: ``elevations`` may name a floor that faces a column of the other building, a
      frame; default ``false``
    - ``column_capacity``: ``{ shear, moment }``, one or both, each a number or a list with one per contact point, >
      0 [force, force·length]: what the columns bear that are struck, for demand over capacity; with
      ``strikes_columns``. Where floors meet the number counts for nothing; default none
    - ``contact``: table, see below; may be left out with ``elevations = []``
    """

    between: Sequence[str]
    width: Numbers
    contact: Contact | ForceLaw | BranchLaw | Table | None = None
    elevations: Numbers | None = None
    level_tolerance: float | None = None
    strikes_columns: bool | None = None
    column_capacity: Table | None = None


@dataclass(kw_only=True)
class Link:
    """``[[link]]``: springs, dampers and cables between two buildings.

    From ``elements/link_laws.h``:

    Spring and dashpot side by side: F = k δ + c δ̇. k [force/length], c [force·s/length] ≥ 0, not both zero. One
    branch, which nothing ends.

    Cable: it pulls once the buildings are further apart than at rest by its slack, F = k (δ + slack) ≤ 0. k
    [force/length] > 0, slack [length] ≥ 0. Branches: 0 slack | 1 taut.

    From ``elements/kinematic_hardening.h``:

    Bilinear hysteresis with kinematic hardening, of a storey, a bearing or a link:

    ::

        V = k (Δ − p)  inside  |V − r k Δ| ≤ (1 − r) V_y,
        V = r k Δ + (1 − r) V_y while Δ̇ ≥ 0 on the upper line,  V = r k Δ − (1 − r) V_y while Δ̇ ≤ 0 on the lower one.
        (L-1)

    k [force/length] stiffness, > 0. V_y [force] yield force, > 0. r [-] hardening, 0 ≤ r < 1; r = 0 is elastic and
    perfectly plastic. Continuity fixes p where a line is left. Branches: 0 elastic, memory 0 = p [length] | 1 on the
    upper line | 2 on the lower one. It would give back ½ r k Δ² + (V − r k Δ)²/(2 (1 − r) k).

    Keys:

    - ``between``: the names of two buildings, the left one first
    - ``elevations``: list, ascending [length] above the common datum; both buildings need a floor there
    - ``level_tolerance``: ≥ 0 [length]: how far apart in height those two floors may be, as in a gap; default as in
      a gap
    - ``law``: one of the following
    - ``"spring-dashpot"``: k δ + c δ̇; ``stiffness`` k and ``damping`` c, both ≥ 0 and at no elevation both zero;
      one may be left out
    - ``"yielding"``: bilinear, as a storey that yields; a friction damper has ``hardening = 0``; ``stiffness`` > 0,
      ``yield_force`` > 0 [force], ``hardening`` in [0, 1), default 0
    - ``"cable"``: pulls with k (−δ − slack) once the buildings are ``slack`` further apart than at rest;
      ``stiffness`` k > 0, ``slack`` ≥ 0 [length], default 0
    """

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

    Keys:

    - ``kind``: ``"record"``, ``"harmonic"``, ``"none"`` (free vibration; then [initial] must move something), or
      ``"spectrum"``, for gaps alone
    - ``delays``: list, ≥ 0 [s], one per building: how much later the ground motion reaches it; default zeros
    - ``wave_velocity``: > 0 [length/s], in place of ``delays``; default none
    - ``kinematics``: ``"relative"``: openings from displacements relative to the bases; ``"absolute"``: with the
      ground displacement; default ``"relative"``

    Of ``kind = "record"``:

    - ``file``: name, relative to the case file
    - ``format``: ``"auto"`` ``"peer-at2"`` ``"two-column"`` ``"one-column"`` ``"values"`` ``"csv"`` ``"cosmos"``
      ``"csmip"`` ``"smc"`` ``"knet"`` ``"esm"``; default ``"auto"``
    - ``unit``: ``"g"`` ``"m/s2"`` ``"cm/s2"`` ``"mm/s2"`` ``"in/s2"`` ``"ft/s2"``; needed unless the file states
      it; ``"g"`` is the case's gravity
    - ``time_step``: > 0 [s]; needed where the file does not say it; default the file's
    - ``column``: whole number: the accelerations' column; needed where a file of columns has more than two; default
      2
    - ``channel``: whole number: which block of accelerations; needed where a ``cosmos`` or ``csmip`` file has
      several; default 1
    - ``skip_lines``: whole number ≥ 0: how many lines at the beginning are skipped; default 0; headings are found
    - ``polarity``: ``"as-recorded"``, or ``"reversed"``: every acceleration times −1, as if the pair of buildings
      stood mirrored; default ``"as-recorded"``
    - ``pga``: > 0 [length/s²], or a text with its unit, ``"0.35 g"``: scale to this peak; default not scaled
    - ``scale``: not 0: multiply by this; not together with ``pga``; default 1

    Of ``kind = "harmonic"``:

    - ``period``: > 0 [s]
    - ``displacement_amplitude``: A > 0 [length]; or
    - ``acceleration_amplitude``: Aω² > 0 [length/s²], or a text with its unit, ``"0.2 g"``; exactly one of the two
    - ``phase``: ``"sine"`` or ``"cosine"``, of the displacement; default ``"sine"``

    Of ``kind = "spectrum"``:

    - ``shape``: ``"asce-7-22"``, ``"sni-1726-2019"``, ``"en-1998-1"`` or ``"table"``
    - ``short_period``, ``one_second``: S_DS and S_D1, > 0 [g], of ``"asce-7-22"`` and ``"sni-1726-2019"``
    - ``long_period``: T_L [s], beyond S_D1/S_DS, of the same
    - ``ground_acceleration``: a_g > 0 [g], the importance factor in it, of ``"en-1998-1"``
    - ``spectrum_type``, ``ground_type``: 1 or 2; ``"A"`` to ``"E"``, of ``"en-1998-1"``: they give S, T_B, T_C, T_D
    - ``periods``, ``accelerations``: lists of a ``"table"``, ≥ 0, periods ascending [s]; or
    - ``file``: a table beside the case, periods in its first column; exactly one of the two
    - ``column``: whole number: the accelerations' column of ``file``; needed where it has more than two; default 2
    - ``unit``: of a table's accelerations, as of records; ``"g"`` is the case's gravity
    - ``damping_ratio``: in [0, 1), that the ordinates of a ``"table"`` are for; spectra of codes are for 0.05;
      default 0.05
    - ``damping_correction``: ``"en-1998-1"``: ordinates for other ratios by η = √(0.10/(0.05 + ζ)) ≥ 0.55;
      ``"none"``: the same for all; default ``"en-1998-1"``
    - ``modal_combination``: ``"cqc"`` or ``"srss"``: whose peaks the rules combine; both are printed; default
      ``"cqc"``
    - ``reduction``: > 0, number or list with one per building, such as R/I_e: the rules of codes take peaks divided
      by it; default 1
    """

    kind: Literal["record", "harmonic", "none", "spectrum"]
    file: str | PathLike[str] | None = None
    values: ArrayLike | None = field(default=None, repr=False)
    format: (
        Literal["auto", "peer-at2", "two-column", "one-column", "values", "csv", "cosmos", "csmip", "smc", "knet", "esm"] | None
    ) = None
    unit: Literal["g", "m/s2", "cm/s2", "mm/s2", "in/s2", "ft/s2"] | None = None
    time_step: float | None = None
    column: int | None = None
    channel: int | None = None
    skip_lines: int | None = None
    polarity: Literal["as-recorded", "reversed"] | None = None
    pga: float | str | None = None
    scale: float | None = None
    period: float | None = None
    displacement_amplitude: float | None = None
    acceleration_amplitude: float | str | None = None
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
    """``[initial]``: lists with one value per floor, by names of buildings.

    Keys:

    - ``displacements``: a table that maps names of buildings to lists, one value per floor, bottom to top [length],
      relative to the base; default zeros
    - ``velocities``: the same of velocities [length/s]; default zeros
    """

    displacements: Mapping[str, Numbers] | None = None
    velocities: Mapping[str, Numbers] | None = None


@dataclass(kw_only=True)
class Analysis:
    """``[analysis]``.

    Keys:

    - ``duration``: > 0 [s]; default the record's length, (count − 1) × step; needed for the other kinds
    - ``solver``: ``"exact"``, ``"adaptive"`` or ``"runge-kutta"``, see below; default ``"exact"``
    - ``tolerance``: in [1e-13, 1e-2], relative, of one step; for ``"adaptive"`` only; default 1e-9
    - ``step``: > 0 [s], in free flight; a third of it in contact; for ``"runge-kutta"`` only; default 0.006
    - ``output_step``: > 0 [s], of the histories only; at most 10⁷ samples; default 0.01
    - ``limits``: ``{ steps, memory }``, see What a run takes; default 2e7, 1000 MB
    - ``collapse_drift``: > 0: drift ratio at which a storey of a building with gravity loads has collapsed; default
      0.1
    - ``both_ways``: what the same ground motion the other way round needs is told beside what it needs as given;
      default ``true``
    - ``energy_audit``: ``true``: all energy is accounted for; what is missing is reported, and the curves stand in
      ``histories.nc``; default ``false``
    """

    duration: float | None = None
    solver: Literal["exact", "adaptive", "runge-kutta"] | None = None
    tolerance: float | None = None
    step: float | None = None
    output_step: float | None = None
    limits: Table | None = None
    collapse_drift: float | None = None
    both_ways: bool | None = None
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
