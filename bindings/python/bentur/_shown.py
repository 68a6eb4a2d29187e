"""What notebooks show of tables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from html import escape
from typing import Any

import numpy as np

_MOST = 12  # values of a list that are shown


class Shown:
    """A table of a case, which notebooks show by its keys."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        values = {one.name: getattr(self, one.name) for one in fields(self)}  # type: ignore[arg-type]
        return f"<b>{type(self).__name__}</b>{html_of(values)}"


def html_of(value: Any) -> str:
    """A value, and what stands in it, as HTML; keys that are None are left out."""
    if isinstance(value, Shown):
        return html_of({one.name: getattr(value, one.name) for one in fields(value)})  # type: ignore[arg-type]
    if isinstance(value, Mapping):
        given = [(str(key), one) for key, one in value.items() if one is not None]
        rows = "".join(
            f'<tr><th style="text-align:left;vertical-align:top">{escape(key)}</th>'
            f'<td style="text-align:left">{html_of(one)}</td></tr>'
            for key, one in given
        )
        return f"<table>{rows}</table>"
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, list | tuple):
        if any(isinstance(one, Mapping | Shown) for one in value):
            return "".join(map(html_of, value))
        told = ", ".join(_text(one) for one in value[:_MOST])
        return f"{told}, … ({len(value)} values)" if len(value) > _MOST else told
    return _text(value)


def _text(value: Any) -> str:
    return escape(f"{value:.6g}" if isinstance(value, float) else str(value))
