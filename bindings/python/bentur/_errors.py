"""What goes wrong, as exceptions."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

_KEY = re.compile(r'^[A-Za-z_][\w-]*(?:\.[\w-]+|\["(?:[^"\\]|\\.)*"\]|\[\d+\])*')


@dataclass(frozen=True)
class Finding:
    """One error of a case, study or record.

    `line` and `column` count from 1; they are 0 where the value stands in no file, as that of a case
    made in Python. `key` is the way to it, as in ``building["A"].stick.masses``.
    """

    file: str
    line: int
    column: int
    message: str

    @property
    def key(self) -> str:
        found = _KEY.match(self.message)
        return found[0] if found else ""

    def __str__(self) -> str:
        place = self.file
        if self.line > 0:
            place += f":{self.line}:{self.column}"
        return f"{place}: error: {self.message}" if place else f"error: {self.message}"


class CaseError(ValueError):
    """A case, study or record that is not right. `errors` has all that was found, each with its place."""

    errors: list[Finding]

    def __init__(self, errors: Iterable[tuple[str, int, int, str]]) -> None:
        self.errors = [Finding(*one) for one in errors]
        super().__init__("\n".join(str(one) for one in self.errors))

    def __reduce__(self) -> tuple[type[CaseError], tuple[list[tuple[str, int, int, str]]]]:
        return type(self), ([(e.file, e.line, e.column, e.message) for e in self.errors],)


class SolveError(RuntimeError):
    """The numbers failed; the message says why and when."""


def missing(package: str, what: str) -> ImportError:
    """For what needs a package that is not there."""
    return ImportError(f"{what} needs {package}, which is not installed: pip install {package}")
