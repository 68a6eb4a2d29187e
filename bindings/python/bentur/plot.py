"""Figures with matplotlib, to be changed further, in the palette and size of the program's own, which
:meth:`bentur.Result.plot` draws.

Each function draws into `ax`, or makes a figure of a journal's column, and returns the axes, to be changed further and
saved: ``bentur.plot.force(result).figure.savefig("force.pdf")``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import imported

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

    from ._case import Case
    from ._functions import Spectrum
    from ._result import Result

_palette = dict(_core.palette())
#: Of buildings, in their order, and of all that is not a building.
BUILDINGS = tuple(_core.building_colours())
BLACK, TEAL, GREY = TONES = tuple(_palette[name] for name in ("ink", "teal", "grey"))
LINES = ("-", "--", "-.", ":")
#: Width of a journal's column [in]; the figures of the program are 8.8 cm wide.
COLUMN = 8.8 / 2.54

STYLE: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.size": 8,
    "axes.linewidth": 0.6,
    "axes.labelsize": 8,
    "lines.linewidth": 0.9,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "legend.frameon": False,
    "legend.fontsize": 7,
    "savefig.bbox": "tight",
    "pdf.fonttype": 42,
}


def _of_building(number: int) -> str:
    """Colour of a building, by its number from 0 on."""
    return BUILDINGS[number % len(BUILDINGS)]


def _apart(number: int) -> dict[str, Any]:
    """Line and colour of one of several curves that are no buildings."""
    return {"linestyle": LINES[number % len(LINES)], "color": TONES[number % len(TONES)]}


def _axes(ax: Axes | None, height: float = 2.2) -> Axes:
    if ax is not None:
        return ax
    plt = imported("matplotlib.pyplot", "a figure")
    style: Any = STYLE
    with plt.rc_context(style):
        made: Axes = plt.subplots(figsize=(COLUMN, height), layout="constrained")[1]
    return made


def _legend(ax: Axes, **more: Any) -> None:
    if len(ax.get_legend_handles_labels()[0]) > 1:
        ax.legend(frameon=False, fontsize=7, **more)


def displacement(result: Result, floor: int = -1, *, ax: Axes | None = None) -> Axes:
    """Displacement of one floor of each building against time; -1: the highest. Impacts of the run along the top."""
    ax = _axes(ax)
    course = result._course
    for b, name in enumerate(result.case.buildings):
        ax.plot(course["time"], course["displacement"][b][:, floor], **_apart(b) | {"color": _of_building(b)}, label=name)
    starts = result.impact_arrays["start"]
    if len(starts):
        ax.plot(starts, np.full(len(starts), 0.98), "|", color=GREY, transform=ax.get_xaxis_transform(), ms=4)
    ax.set(xlabel="time $t$ [s]", ylabel=f"displacement $x$ [{result.case.length}]", xlim=_ends(course["time"]))
    _legend(ax)
    return ax


def force(result: Result, *, ax: Axes | None = None) -> Axes:
    """Contact force against time, a line for each contact point that is hit."""
    ax = _axes(ax)
    course = result._course
    elevations = [point["elevation"] for gap in result.summary["gaps"] for point in gap["points"]]
    shown = [i for i in range(len(elevations)) if course["force"][:, i].any()]
    for n, i in enumerate(reversed(shown)):
        label = f"{elevations[i]:g} {result.case.length}"
        ax.plot(course["time"], course["force"][:, i], **_apart(n), label=label)
    ax.set(xlabel="time $t$ [s]", ylabel=f"contact force $F$ [{result.case.force}]", xlim=_ends(course["time"]))
    ax.set_ylim(bottom=0)
    _legend(ax)
    return ax


def opening(result: Result, point: int = -1, *, ax: Axes | None = None) -> Axes:
    """Opening of one contact point against time, negative in contact; -1: the last, the highest of the last gap."""
    ax = _axes(ax)
    course = result._course
    ax.axhline(0, color=GREY, lw=0.6)
    ax.plot(course["time"], course["opening"][:, point], color=BLACK)
    ax.set(xlabel="time $t$ [s]", ylabel=f"opening $g$ [{result.case.length}]", xlim=_ends(course["time"]))
    return ax


def loop(result: Result, point: int = -1, *, ax: Axes | None = None) -> Axes:
    """Contact force against penetration of one contact point."""
    ax = _axes(ax)
    course = result._course
    penetration = -course["opening"][:, point]
    touching = penetration > 0
    touching[1:] |= touching[:-1].copy()  # from the start of each contact to its end
    touching[:-1] |= touching[1:].copy()
    ax.plot(np.where(touching, penetration, np.nan), course["force"][:, point], color=BLACK)
    ax.set(xlabel=f"penetration $δ$ [{result.case.length}]", ylabel=f"contact force $F$ [{result.case.force}]")
    ax.set_xlim(left=0)
    return ax


def envelope(result: Result, quantity: str = "peak_displacement", *, ax: Axes | None = None) -> Axes:
    """Peaks over the height of each building; of displacements also without contact (dashed)."""
    ax = _axes(ax, 2.8)
    for b, building in enumerate(result.summary["buildings"]):
        if building[quantity] is None:
            continue
        levels = building["elevations"]
        ax.plot(building[quantity], levels, "-o", ms=3, color=_of_building(b), label=building["name"])
        alone = building.get(quantity + "_no_contact")
        if alone:
            ax.plot(alone, levels, "--o", ms=3, mfc="white", color=_of_building(b), label=building["name"] + ", alone")
    unit = {"peak_displacement": f" [{result.case.length}]", "peak_storey_shear": f" [{result.case.force}]"}.get(quantity, "")
    if quantity == "peak_acceleration":
        unit = f" [{result.case.length}/s²]"
    ax.set(xlabel=quantity.replace("_", " ") + unit, ylabel=f"elevation $z$ [{result.case.length}]")
    ax.set_xlim(left=0)
    _legend(ax)
    return ax


def modes(case: Case, building: str | int = 0, count: int = 3, *, ax: Axes | None = None) -> Axes:
    """The first mode shapes of a building at its floors, the largest sway 1."""
    from ._functions import modes as modes_of

    ax = _axes(ax, 2.8)
    name = building if isinstance(building, str) else case.buildings[building]
    elevations = case.matrices(name)["elevations"]
    found = modes_of(case)[name]
    ax.axvline(0, color=GREY, lw=0.6)
    for n in range(min(count, len(found["periods"]))):
        shape = found["shapes"][n][: len(elevations)]
        shape = shape / np.abs(shape).max()
        label = f"{n + 1}: {found['periods'][n]:.3g} s"
        ax.plot([0, *shape], [elevations[0] * 0, *elevations], marker="o", ms=3, **_apart(n), label=label)
    ax.set(xlabel="sway, largest 1", ylabel=f"elevation $z$ [{case.length}]")
    ax.set_title(name, fontsize=8)
    _legend(ax)
    return ax


def spectrum(*found: Spectrum, labels: Sequence[str] = (), ax: Axes | None = None) -> Axes:
    """Pseudo-acceleration spectra over a logarithmic axis of periods."""
    ax = _axes(ax)
    for n, one in enumerate(found):
        label = labels[n] if n < len(labels) else f"damping {100 * one.damping_ratio:g} %"
        ax.semilogx(one.period, one.pseudo_acceleration, **_apart(n), label=label)
    ax.set(xlabel="period $T$ [s]", ylabel=f"pseudo-acceleration $S_a$ [{found[0].length}/s²]")
    ax.set_ylim(bottom=0)
    _legend(ax)
    return ax


def against(results: xarray.Dataset, quantity: str, along: str, *, ax: Axes | None = None) -> Axes:
    """A quantity of a study against one of its dimensions, the largest over places; a line for each other value."""
    ax = _axes(ax)
    values = results[quantity]
    places = [d for d in values.dims if str(d) in ("point", "gap", "link") or str(d).startswith("elevation_")]
    values = values.max(places, keep_attrs=True)
    others = [d for d in values.dims if d != along]
    lines = values.stack(other=others).transpose("other", along) if others else values.expand_dims("other")
    for n in range(lines.sizes["other"]):
        at = lines["other"].values[n]
        chosen = zip(others, at if isinstance(at, tuple) else (at,), strict=True) if others else ()
        label = ", ".join(f"{of} = {x}".replace("_", " ") for of, x in chosen) or None
        ax.plot(results[along], lines[n], **_apart(n), label=label)
    unit, of = values.attrs.get("units", ""), results[along].attrs.get("units", "")
    ax.set(
        xlabel=along.replace("_", " ") + (f" [{of}]" if of not in ("", "1") else ""),
        ylabel=quantity.replace("_", " ") + (f" [{unit}]" if unit not in ("", "1") else ""),
    )
    _legend(ax)
    return ax


def _intensity_label(name: str, unit: str) -> str:
    """``spectral acceleration at 1 s, 5 % damping [g]``, of what results call it."""
    return f"{name.replace(', period ', ' at ').replace('damping 5 %', '5 % damping')} [{unit}]"


def _logarithmic(ax: Axes) -> None:
    """Intensities by their logarithm, with numbers at 1, 2 and 5."""
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    ax.set_xscale("log")
    ax.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    ax.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    ax.xaxis.set_minor_formatter(NullFormatter())


def _bounds_label(found: dict[str, Any]) -> str:
    """What its bounds are of."""
    bootstrap = found.get("bootstrap")
    return "bounds" if bootstrap is None else f"{100 * bootstrap['confidence']:g} % bounds"


def _band(x: NDArray[np.float64], counts: Sequence[dict[str, Any]]) -> tuple[Any, Any, Any]:
    """Bounds of a probability at levels, and between them as straight lines of normal quantiles over ln x."""
    from statistics import NormalDist

    normal, least = NormalDist(), 1e-12
    at = np.log([c["intensity"] for c in counts])
    inside = x[(np.log(x) >= at[0] - 1e-9) & (np.log(x) <= at[-1] + 1e-9)]
    ends = []
    for end in (0, 1):
        z = [normal.inv_cdf(min(max(c["bounds"][end], least), 1 - least)) for c in counts]
        ends.append([normal.cdf(one) for one in np.interp(np.log(inside), at, z)])
    return inside, *ends


def fragility(found: dict[str, Any] | xarray.Dataset, *, ax: Axes | None = None) -> Axes:
    """Curves of :func:`bentur.fragility` with the fractions of runs they are fitted to; of a single curve also its bounds
    at the levels. Levels that grow by one factor stand on a logarithmic scale.

    :param found: what that gives; or the results of :func:`bentur.ida`: then the curves of pounding.
    """
    import re
    from math import erf, sqrt

    from ._study import fragility as curves_of

    if not isinstance(found, dict):
        found = curves_of(found)
    ax = _axes(ax)
    # Of records that are not scaled each has an intensity of its own.
    own = {count["intensity"] for curve in found["curves"] for count in curve["counts"]}
    levels = np.array(found["intensity"]["levels"] or sorted(own))
    steps = np.diff(np.log(levels))
    is_log = len(levels) > 2 and np.ptp(steps) < 1e-6 * steps[0]
    x = np.geomspace(levels[0], levels[-1], 400) if is_log else np.linspace(levels[-1] / 400, levels[-1], 400)
    if is_log:
        _logarithmic(ax)
    is_alone = len(found["curves"]) == 1
    bounded = [c for c in found["curves"][0]["counts"] if c.get("bounds")] if is_alone else []
    if bounded:
        ax.fill_between(*_band(x, bounded), color="0.85", linewidth=0, label=_bounds_label(found))
    for n, curve in enumerate(found["curves"]):
        label = ", ".join(f"{k} = {v:g}" if isinstance(v, float) else f"{k} = {v}" for k, v in curve["case"].items())
        if curve["median"] is not None:  # else no curve fits, and the fractions stand alone
            z = np.log(x / curve["median"]) / curve["dispersion"]
            probability = [0.5 * (1 + erf(one / sqrt(2))) for one in z]
            ax.plot(x, probability, **_apart(n), label=label or ("lognormal fit" if bounded else None))
        counts = [c for c in curve["counts"] if c["runs"] > 0]
        at, parts = [c["intensity"] for c in counts], [c["events"] / c["runs"] for c in counts]
        alone = label if curve["median"] is None else "observed" if bounded else None
        ax.plot(at, parts, "o", ms=2.5, mfc="white", color=_apart(n)["color"], label=alone or None)
    unit = re.sub(r"^gravity$|^[\d.]+ \w+ s-2$", "g", found["intensity"]["units"])  # a case's g may be its own
    ax.set(
        xlabel=_intensity_label(found["intensity"]["name"], unit),
        ylabel=f"P({found['event']})",
        ylim=(-0.02, 1.02),
    )
    _legend(ax)
    return ax


def risk(found: dict[str, Any], *, case: int = 0, axes: Sequence[Axes] | None = None) -> Sequence[Axes]:
    """Of :func:`bentur.risk`: the hazard curve with the event's rate, the fragility, and below which intensities the
    rate comes from, as rate in each segment per unit of ln x.

    :param case: which of ``found["cases"]``.
    :param axes: two; default: a figure with one above the other.
    :returns: both axes.
    """
    from math import erf, sqrt

    one, hazard = found["cases"][case], found["hazard"]
    if axes is None:
        pyplot = imported("matplotlib.pyplot", "a figure")
        with pyplot.rc_context(STYLE):
            _, axes = pyplot.subplots(2, 1, sharex=True, figsize=(COLUMN, 1.25 * COLUMN), layout="constrained")
    assert axes is not None
    upper, lower = axes[0], axes[1]
    x, rate = np.array(hazard["intensity"]), np.array(hazard["rate"])
    upper.loglog(x, rate, color=BLACK, label="hazard λ")
    upper.axhline(one["rate"], color=TEAL, linestyle="--", label=f"{found['event']}: {one['rate']:.3g} a year")
    upper.set(ylabel="mean annual frequency [1/year]")
    if one["median"] is not None:
        other = upper.twinx()
        fine = np.geomspace(x[0], x[-1], 300)
        z = np.log(fine / one["median"]) / one["dispersion"]
        other.plot(fine, [0.5 * (1 + erf(v / sqrt(2))) for v in z], color=GREY, linestyle="-.")
        upper.plot([], [], color=GREY, linestyle="-.", label="fragility P")
        other.set(ylim=(0, 1.02))
        other.set_ylabel("fragility P", fontsize=STYLE["axes.labelsize"])
        other.tick_params(labelsize=STYLE["font.size"], direction="in")
    # Above all curves: hazard and fragility cross, so that within them there is no corner that is free of both.
    upper.legend(frameon=False, fontsize=STYLE["legend.fontsize"], loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2)
    told = one["lognormal"] if one["by"] == "lognormal" else one["observed"]
    density = np.array(told["parts"][:-1]) / np.diff(np.log(x))
    lower.stairs(density, x, fill=True, color=TEAL, alpha=0.5)
    _logarithmic(lower)
    lower.set(xlabel=_intensity_label(found["intensity"]["name"], found["intensity"]["unit"]),
              ylabel="rate per unit of ln x [1/year]")
    return axes


def _ends(time: Any) -> tuple[float, float]:
    return float(time[0]), float(time[-1])
