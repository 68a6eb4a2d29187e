"""Rows of a design of experiments, drawn from distributions that may be correlated."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments
from ._errors import imported

if TYPE_CHECKING:
    import pandas

Floats = NDArray[np.float64]

_STANDARD = NormalDist()
_LEAST = 1e-15  # probability that a quantile is asked for
_NODES, _WEIGHTS = np.polynomial.hermite_e.hermegauss(48)
_WEIGHTS = _WEIGHTS / _WEIGHTS.sum()


def sample(
    distributions: Mapping[str, Any],
    runs: int,
    *,
    correlation: ArrayLike | None = None,
    method: str = "latin-hypercube",
    seed: int = 1,
) -> pandas.DataFrame:
    """Rows for :func:`vary`, a column for each key.

    :param distributions: by keys of the case: whatever has a ``ppf``, as the frozen distributions of scipy.stats, a
        list of values that are equally likely, or a mapping of values to their weights. Values that are no numbers,
        such as names of records, cannot be correlated.
    :param correlation: Pearson's, of the values themselves, one row and column per key in their order; by the model of
        Nataf: a Gaussian copula whose correlations are such that the values have these. Of a discrete one that of its
        numbers.
    :param method: "latin-hypercube" or "random". Of a design of scipy.stats.qmc, SALib or UQpy a DataFrame with the
        keys as columns will do as it is.
    :raises ValueError: where the matrix is none of correlations, or none that these distributions can have.

    Sources: [LiuDerKiureghian1986, doi 10.1016/0266-8920(86)90033-0], [McKayBeckmanConover1979].
    """
    keys = list(_arguments.mapping("distributions", distributions, "distributions by their keys"))
    runs = _arguments.whole("runs", runs, 1)
    method = _arguments.one_of("method", method, ("latin-hypercube", "random"))
    random = np.random.default_rng(_arguments.whole("seed", seed, 0, 2**63 - 1))
    quantiles = {key: _quantile(key, distributions[key]) for key in keys}
    uniform = np.empty((runs, len(keys)))
    for column in range(len(keys)):
        at = (random.permutation(runs) + random.random(runs)) / runs if method == "latin-hypercube" else random.random(runs)
        uniform[:, column] = np.clip(at, _LEAST, 1 - _LEAST)
    if correlation is not None:
        matrix = _checked(correlation, keys)
        normal = np.vectorize(_STANDARD.inv_cdf)(uniform)
        # What chance has left of correlation in the rows goes first: they then have the one asked for, not about it.
        if runs > len(keys) + 1:
            normal = (normal - normal.mean(axis=0)) @ np.linalg.inv(np.linalg.cholesky(np.cov(normal.T).reshape(len(keys), -1))).T
        copula = _nataf(matrix, [quantiles[key] for key in keys], keys)
        normal = normal @ np.linalg.cholesky(copula).T
        uniform = _probability(normal)
    columns = {key: quantiles[key](uniform[:, i]) for i, key in enumerate(keys)}
    made: pandas.DataFrame = imported("pandas", "rows of a design").DataFrame(columns)
    return made


def _probability(z: Floats) -> Floats:
    found: Floats = np.clip(np.vectorize(_STANDARD.cdf)(z), _LEAST, 1 - _LEAST)
    return found


def _quantile(key: str, distribution: Any) -> Any:
    """The function of a probability that gives values."""
    if hasattr(distribution, "ppf"):
        return lambda u: np.asarray(distribution.ppf(u), dtype=float)
    if isinstance(distribution, Mapping):
        values, weights = list(distribution), np.array(list(distribution.values()), dtype=float)
    elif isinstance(distribution, Sequence | np.ndarray) and not isinstance(distribution, str):
        values, weights = list(distribution), np.ones(len(distribution))
    else:
        kind = type(distribution).__name__
        raise TypeError(f'distributions["{key}"] is a {kind}, must have ppf, or be values, or values with weights')
    if not values or not np.all(weights >= 0) or not weights.sum() > 0:
        raise ValueError(f'distributions["{key}"] must have values, with weights >= 0')
    ends = np.cumsum(weights) / weights.sum()
    choices = np.array(values) if all(isinstance(one, int | float) for one in values) else np.array(values, dtype=object)
    return lambda u: choices[np.minimum(np.searchsorted(ends, u, side="right"), len(choices) - 1)]


def _checked(correlation: ArrayLike, keys: Sequence[str]) -> Floats:
    matrix = np.asarray(correlation, dtype=float)
    if matrix.shape != (len(keys), len(keys)):
        raise ValueError(f"correlation is {' × '.join(map(str, matrix.shape))}, must be {len(keys)} × {len(keys)}")
    if not np.allclose(matrix, matrix.T) or not np.allclose(np.diag(matrix), 1):
        raise ValueError("correlation must be symmetric with ones on its diagonal")
    if not np.linalg.eigvalsh(matrix).min() > 0:
        raise ValueError("correlation must be positive definite")
    return matrix


def _nataf(matrix: Floats, quantiles: Sequence[Any], keys: Sequence[str]) -> Floats:
    """Correlations of the normal variables that give the values those of `matrix`."""
    x = [quantile(_probability(_NODES)) for quantile in quantiles]
    found = np.eye(len(keys))
    for i in range(len(keys)):
        for j in range(i):
            wanted = matrix[i, j]
            if wanted != 0:
                found[i, j] = found[j, i] = _of_normals(wanted, i, j, x, quantiles, keys)
    if not np.linalg.eigvalsh(found).min() > 0:
        raise ValueError("correlation: these distributions cannot have it, its copula is not positive definite")
    return found


def _of_normals(wanted: float, i: int, j: int, x: Sequence[Any], quantiles: Sequence[Any], keys: Sequence[str]) -> float:
    for n in (i, j):
        if x[n].dtype == object:
            raise ValueError(f'distributions["{keys[n]}"] has values that are no numbers, which have no correlation')
    mean = [float(_WEIGHTS @ one) for one in (x[i], x[j])]
    spread = [math.sqrt(float(_WEIGHTS @ (one - m) ** 2)) for one, m in zip((x[i], x[j]), mean, strict=True)]

    def given(rho: float) -> float:
        inner = rho * _NODES[:, None] + math.sqrt(1 - rho * rho) * _NODES[None, :]
        other = quantiles[j](_probability(inner))
        return float(_WEIGHTS @ (((x[i] - mean[0])[:, None] * (other - mean[1])) @ _WEIGHTS)) / (spread[0] * spread[1])

    low, high = -0.9999, 0.9999
    if not given(low) <= wanted <= given(high):
        raise ValueError(
            f"correlation of {keys[i]} and {keys[j]} = {wanted:g}, these distributions can have "
            f"{given(low):.3g} to {given(high):.3g}"
        )
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if given(middle) < wanted else (low, middle)
    return (low + high) / 2
