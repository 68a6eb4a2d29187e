"""Which NumPy goes with the compiled part."""

import numpy as np


def check(pybind11: tuple[int, int], numpy: str = np.__version__) -> None:
    """Refuses a NumPy whose arrays would have wrong numbers.

    pybind11 before 2.12 looks for the size of an array's elements where NumPy 1 has it.

    :raises ImportError: where `pybind11` is before 2.12 and `numpy` 2 or newer.
    """
    if pybind11 < (2, 12) and int(numpy.partition(".")[0]) >= 2:
        raise ImportError(
            f"this bentur was built with pybind11 {pybind11[0]}.{pybind11[1]}, which reads arrays of NumPy {numpy} "
            "wrongly: build it with pybind11 2.12 or newer, as `pip install .` does, or `pip install 'numpy<2'`"
        )
