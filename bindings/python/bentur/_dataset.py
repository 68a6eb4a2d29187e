"""Variables of results, as the program lists them, in the forms that Python has for them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import imported

#: Name, names of the dimensions, values, attributes. Of a group all but the values begin with "group/".
Variable = tuple[str, tuple[str, ...], NDArray[Any], dict[str, Any]]


def dataset(what: str, attributes: dict[str, Any], variables: Iterable[Variable], group: str = "") -> Any:
    """An xarray.Dataset of a group, or of what is in none, for `what`; the coordinates of its dimensions are in it."""
    own, others = _split(variables, group)
    outside, _ = _split(others, "") if group else ([], [])
    coordinates = {word for *_, told in (*own, *outside) for word in str(told.get("coordinates", "")).split()}
    along = {name for _, dims, *_ in own for name in dims}
    names = {name for name, *_ in own}
    coordinates |= along
    shared = [one for one in outside if one[0] in coordinates - names and along.issuperset(one[1])]
    made = {
        name: (dims, values, {key: value for key, value in told.items() if key != "coordinates"})
        for name, dims, values, told in (*own, *shared)
    }
    return imported("xarray", what).Dataset(
        {name: one for name, one in made.items() if name not in coordinates},
        coords={name: one for name, one in made.items() if name in coordinates},
        attrs=attributes,
    )


def by_name(variables: Iterable[Variable], buildings: int, group: str = "") -> dict[str, Any]:
    """Arrays along time by name; a list of them where each building has its own, None where one has none."""
    found: dict[str, Any] = {}
    for name, dims, values, _ in _split(variables, group)[0]:
        if dims[:1] != ("time",):
            continue
        of, _, number = name.rpartition("_")
        if number.isdigit():
            found.setdefault(of, [None] * buildings)[int(number) - 1] = values
        else:
            found[name] = values
    return found


def netcdf(attributes: dict[str, Any], variables: Iterable[Variable]) -> bytes | None:
    """A NetCDF-4 file as bytes, the same as the program's to whoever reads it; None without netCDF4."""
    try:
        netCDF4 = imported("netCDF4", "a file of results")
    except ImportError:
        return None
    file = netCDF4.Dataset("results.nc", "w", memory=1 << 20)
    file.setncatts(attributes)
    known: set[str] = set()

    def place(name: str) -> tuple[Any, str]:
        group, _, own = name.rpartition("/")
        return (file.createGroup(group) if group else file), own

    for name, dims, values, told in variables:
        for dimension, size in zip(dims, values.shape, strict=True):
            if dimension not in known:
                where, own = place(dimension)
                where.createDimension(own, size)
                known.add(dimension)
        where, own = place(name)
        is_text = values.dtype.kind == "O"
        made = where.createVariable(own, str if is_text else values.dtype, [place(one)[1] for one in dims])
        made.setncatts(told)
        made[...] = values
    return bytes(file.close())


def is_histories(file: Path) -> bool:
    """Whether a file is ``histories.nc`` of a run."""
    names, _ = _results(file)
    return "displacement_1" in names or "displacement_x_1" in names


def attributes_of_study(file: Path, is_ida: bool) -> dict[str, str] | None:
    """Of a file of results of a study; None of any other file."""
    names, attributes = _results(file)
    return attributes if "status" in names and ("intensity" in names) == is_ida else None


def _results(file: Path) -> tuple[set[str], dict[str, str]]:
    """Names of the variables and attributes of a file that bentur has written; of others none."""
    try:
        with imported("netCDF4", "a file of results").Dataset(file) as found:
            attributes = {name: str(found.getncattr(name)) for name in found.ncattrs()}
            ours = attributes.get("history", "").startswith("written by bentur")
            return (set(found.variables), attributes) if ours else (set(), {})
    except (ImportError, OSError):
        return set(), {}


def _split(variables: Iterable[Variable], group: str) -> tuple[list[Variable], list[Variable]]:
    """Those of a group under their own names, or those of none; and the others."""
    own: list[Variable] = []
    others: list[Variable] = []
    for one in variables:
        name, dims, values, told = one
        if name.rpartition("/")[0] != group:
            others.append(one)
        else:
            short = tuple(dim.removeprefix(group + "/") for dim in dims)
            own.append((name.removeprefix(group + "/"), short, values, told))
    return own, others
