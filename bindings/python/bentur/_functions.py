"""What is done with a case or a record."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments, _core
from ._case import Case, as_case
from ._errors import RemarkWarning, imported
from ._result import Result

if TYPE_CHECKING:
    import xarray

Progress = bool | Callable[[float], object] | None


@contextmanager
def shown(progress: Progress, what: str) -> Iterator[Callable[[float], object] | None]:
    """A function to call with the fraction done: the caller's own, a bar of tqdm, or nothing."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield None
            return
        with tqdm(total=100, desc=what, unit="%", delay=1, leave=False) as bar:
            yield lambda fraction: bar.update(100 * fraction - bar.n)
    else:
        yield progress


def run(
    case: Case | str | PathLike[str],
    *,
    record: int | None = None,
    histories: bool | None = None,
    output_step: float | None = None,
    progress: Progress = None,
) -> Result:
    """Simulates a case, as ``bentur run`` does and with the same numbers.

    The interpreter's lock is released meanwhile, so that threads run side by side; Ctrl-C stops the run.

    :param case: a case, or the name of a case file.
    :param record: of a case with a suite of records the one that is run, counted from 1; :func:`run_suite` runs them
        all.
    :param histories: samples: ``None`` makes them when they are first asked for, by solving the case once more;
        ``True`` makes them at once, ``False`` never. They change nothing else.
    :param output_step: [s] of the samples; default ``analysis.output_step``.
    :param progress: ``True``: a bar after one second, where tqdm is installed; or a function of the fraction done.
    :raises CaseError: where the case is not right, or takes more than its limits.
    :raises SolveError: where the numbers fail.
    :warns RemarkWarning: of numbers that are unusual, ``result.remarks``; once a case.
    """
    asked = as_case(case)
    if output_step is not None:
        output_step = _arguments.positive("output_step", output_step)
    if histories is None and asked._made.energy_audit:
        histories = True  # the account of energies is of the run with its samples, to the last bit
    step = (output_step or asked._made.output_step) if histories else 0.0
    if record is not None:
        record = _arguments.whole("record", record, 1)
    with shown(progress, asked.title or "run") as told:
        made = asked._made if record is None else asked._made.with_record(record)
        solved = _core.solve(made, step, told)
    result = Result(solved, asked, record=record, output_step=output_step, histories=histories)
    _warn_of_remarks(result)
    return result


def _warn_of_remarks(result: Result) -> None:
    """Once for each case, and each record of a suite: whoever runs it again has been told."""
    if not result._run.remark_count or not result.case._is_first_run(result._record):
        return
    name = result.case.title or " | ".join(result.case.buildings)
    warnings.warn("\n".join([f"{name}:", *result.remarks]), RemarkWarning, stacklevel=3)


def run_suite(case: Case | str | PathLike[str], *, progress: Progress = None) -> dict[str, Any]:
    """Runs a case with each record of its suite, as ``bentur run CASE --json`` reports them: ``suite`` with the spectra
    as scaled, ``records`` with a few numbers of each, ``mean`` and ``largest`` of these.

    :param case: a case with ``excitation.kind = "suite"``, or its file. :func:`run` takes one record of it, by
        ``record=N``; :func:`minimum_gap` gives the gap over all of them with what the code takes.
    """
    asked = as_case(case)
    with shown(progress, asked.title or "suite") as told:
        found: dict[str, Any] = json.loads(_core.suite_run_json(asked._made, told))
        return found


def sensitivity(
    case: Case | str | PathLike[str], *, numbers: Sequence[str] = (), progress: Progress = None
) -> dict[str, Any]:
    """The derivatives of gap needed, peak force and displacements by the numbers of a case, through the events, as
    ``bentur sensitivity CASE --json`` prints them (docs/sensitivity.md); of a suite those of the mean or the largest of
    all records, and of each. :attr:`Result.sensitivity` has those of a run.

    :param numbers: those wanted, as ``gap[0].width``; default: all of the case.
    :raises CaseError: for buildings that yield, friction, or a contact law with a curved force.
    """
    asked = as_case(case)
    wanted = [_arguments.text(f"numbers[{i}]", one) for i, one in enumerate([numbers] if isinstance(numbers, str) else numbers)]
    with shown(progress, asked.title or "sensitivity") as told:
        found: dict[str, Any] = json.loads(_core.sensitivity_json(asked._made, wanted, told))
        return found


def modes(case: Case | str | PathLike[str], *, method: str = "library") -> dict[str, Any]:
    """Periods, participation, effective masses and shapes of each building, as ``bentur modes CASE --json`` has them.

    :param method: ``"library"``, or ``"jacobi"`` as in the monograph.
    :returns: by names of buildings; lists became arrays, ``shapes`` is modes × degrees of freedom.
    """
    method = _arguments.one_of("method", method, ("library", "jacobi"))
    told = json.loads(_core.modes_json(as_case(case)._made, method == "jacobi"))
    return {one["name"]: {k: np.array(v) if isinstance(v, list) else v for k, v in one.items()} for one in told["buildings"]}


def height_rules(case: Case | str | PathLike[str]) -> dict[str, Any]:
    """What the rules of the case's ``[code]`` ask of each gap from heights alone, before anything is computed, as
    ``bentur gap --rules --json`` has it.
    """
    found: dict[str, Any] = json.loads(_core.height_rules_json(as_case(case)._made))
    return found


def minimum_gap(
    case: Case | str | PathLike[str], *, at: float | None = None, progress: Progress = None
) -> dict[str, Any]:
    """The gap that keeps the buildings apart, simulated (or by a design spectrum) and by the rules, as
    ``bentur gap --json`` has it.

    :param case: a case or its file; or the file of a study: then over all of its records, as over those of a case's
        suite.
    :param at: for a study with ``[ida]``: the intensity; default its highest level.
    """
    if at is not None:
        at = _arguments.number("at", at)
    with shown(progress, "gap") as told:
        found: dict[str, Any]
        if not isinstance(case, Case) and _core.is_study(_arguments.path("case", case)):
            found = json.loads(_core.gap_study_json(case, at, told))
            return found
        if at is not None:
            raise ValueError("at is for a study with [ida]")
        made = as_case(case)._made
        found = json.loads(_core.suite_gap_json(made, told) if made.records else _core.gap_json(made, told))
        return found


@dataclass(frozen=True)
class Record:
    """A ground motion as its file has it.

    `values` are in `unit` (empty where the file does not say it), every `time_step` [s].
    """

    file: str
    format: str
    unit: str
    time_step: float
    values: NDArray[np.float64]
    header_lines: int = 0
    channel: str = ""
    mean_removed: float = 0.0

    @property
    def time(self) -> NDArray[np.float64]:
        """[s]"""
        return self.time_step * np.arange(len(self.values), dtype=np.float64)

    @property
    def peak(self) -> float:
        """Largest absolute value, in `unit`."""
        return float(np.abs(self.values).max())


def read_record(
    file: str | PathLike[str],
    *,
    format: str = "auto",
    time_step: float | None = None,
    column: int | None = None,
    channel: int | None = None,
    component: str | None = None,
    skip_lines: int = 0,
) -> Record:
    """Reads a strong-motion file in any of the formats of docs/record-files.md.

    :param component: the channel or column by its name in the file, "N-S", "N80W", "Up".
    :raises CaseError: with what is wrong, where.
    """

    def whole(name: str, one: int) -> int:
        return _arguments.whole(name, one, 0, 2**31 - 1)

    options = {"column": column, "channel": channel}
    chosen = {name: None if one is None else whole(name, one) for name, one in options.items()}
    skipped = whole("skip_lines", skip_lines)
    step = None if time_step is None else _arguments.number("time_step", time_step)
    name = _arguments.path("file", file)
    named = None if component is None else _arguments.text("component", component)
    return Record(
        **_core.read_record(
            name, _arguments.text("format", format), step, **chosen, component=named, skip_lines=skipped
        )
    )


def logarithmic_periods(first: float = 0.05, last: float = 5.0, count: int = 41) -> NDArray[np.float64]:
    """`count` periods from `first` to `last` [s], evenly spaced on a logarithmic scale."""
    ends = _arguments.positive("first", first), _arguments.positive("last", last)
    return _core.logarithmic_periods(*ends, _arguments.whole("count", count, 1, 2**31 - 1))


@dataclass(frozen=True)
class Spectrum:
    """A response spectrum; all arrays have one entry per period. Accelerations are in length/s²."""

    period: NDArray[np.float64]
    displacement: NDArray[np.float64]
    pseudo_velocity: NDArray[np.float64]
    pseudo_acceleration: NDArray[np.float64]
    absolute_acceleration: NDArray[np.float64]
    damping_ratio: float
    length: str

    @property
    def dataset(self) -> xarray.Dataset:
        """The same with units. :raises ImportError: without xarray."""
        units = {
            "displacement": self.length,
            "pseudo_velocity": f"{self.length} s-1",
            "pseudo_acceleration": f"{self.length} s-2",
            "absolute_acceleration": f"{self.length} s-2",
        }
        found: xarray.Dataset = imported("xarray", "the Dataset of a spectrum").Dataset(
            {name: ("period", getattr(self, name), {"units": unit}) for name, unit in units.items()},
            coords={"period": ("period", self.period, {"units": "s", "long_name": "period of linear oscillators"})},
            attrs={"damping_ratio": self.damping_ratio},
        )
        return found


def response_spectrum(
    record: Record | ArrayLike | str | PathLike[str],
    periods: Sequence[float] | NDArray[np.float64] | None = None,
    *,
    damping: float = 0.05,
    unit: str | None = None,
    time_step: float | None = None,
    length: str = "m",
) -> Spectrum:
    """Peaks of linear oscillators under a record, as ``bentur spectrum`` has them: of the continuous response, without
    any error of time stepping.

    :param record: a record, its file, or accelerations, which need `unit` and `time_step`.
    :param periods: [s]; default 41 from 0.05 to 5.
    :param unit: of the accelerations, where the file does not say it: g m/s2 cm/s2 mm/s2 in/s2 ft/s2.
    :param length: unit of length of the results.

    From ``solve/spectrum/response_spectrum.h``:

    Peaks of a linear oscillator under a record:

    ::

        ẍ + 2ζω ẋ + ω² x = −a_g(t),   ω = 2π/T,   x(0) = ẋ(0) = 0,   (1)
        S_d = max |x|,   S_v = ω S_d,   S_a = ω² S_d,   A = max |ẍ + a_g| = max |2ζω ẋ + ω² x|.   (2)

    T [s] period, ζ [-] damping ratio, a_g [length/s²] linear between samples and zero after the last. The maxima are
    over all t ≥ 0, the free vibration after the record included.

    No time stepping error: from sample to sample the solution of (1) is a fixed linear map of the state and the two
    samples, and a maximum is an extremum of the continuous solution, not its largest sample. Round-off alone remains.
    Limits: T → 0 gives A = S_a = peak ground acceleration; T → ∞ gives S_d = peak ground displacement.
    """
    if isinstance(record, str | PathLike):
        record = read_record(record, time_step=time_step)
    if isinstance(record, Record):
        if record.unit and unit and record.unit != unit:
            raise ValueError(f'unit is {unit} but the file says "{record.unit}"')
        values, step, unit = record.values, record.time_step, record.unit or unit
    elif time_step is None:
        raise ValueError("time_step is needed for accelerations that are no Record")
    else:
        given, what, rule = _arguments.accelerations("record", record)
        if given is None:
            raise ValueError(f"record is {what}, {rule}")
        values, step = given, time_step
    if not unit:
        raise ValueError("the unit of the accelerations is not known: give unit")
    at = logarithmic_periods() if periods is None else np.array(_arguments.listed("periods", periods))
    damping, step = _arguments.number("damping", damping), _arguments.positive("time_step", step)
    peaks = _core.response_spectrum(values, step, _core.acceleration_factor(unit, length), at.tolist(), damping)
    return Spectrum(at, peaks[:, 0], peaks[:, 1], peaks[:, 2], peaks[:, 3], damping, length)


def examples() -> list[str]:
    """Names of the cases that come with the package."""
    return sorted(file.stem for file in (Path(__file__).parent / "examples").glob("*.toml"))


def example(name: str = "m12-el-centro") -> Case:
    """One of them."""
    file = Path(__file__).parent / "examples" / f"{_arguments.text('name', name)}.toml"
    if not file.exists():
        raise ValueError(f'there is no example "{name}"; there are {", ".join(examples())}')
    return Case.from_file(file)
