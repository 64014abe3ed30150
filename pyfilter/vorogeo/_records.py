"""Classes of results whose fields carry their description, from which the class documentation is completed."""

from __future__ import annotations

import dataclasses
import textwrap
from collections.abc import Iterator
from typing import Any, TypeVar, get_args, get_type_hints

_Class = TypeVar("_Class", bound=type)


def doc(text: str, **how: Any) -> Any:
    """A field of a dataclass with its description. `how`: as for `dataclasses.field`."""
    return dataclasses.field(metadata={"doc": text}, **how)


def documented(record: _Class) -> _Class:
    """Adds the fields of a dataclass, or of a named tuple of Annotated types, to its documentation."""
    lines = ["", "", "Attributes", "----------"]
    for head, text in _fields(record):
        lines += [head, textwrap.indent(textwrap.fill(text, 112), "    ")]
    record.__doc__ = str(record.__doc__) + "\n".join(lines)
    return record


def _fields(record: Any) -> Iterator[tuple[str, str]]:
    if dataclasses.is_dataclass(record):
        yield from ((f"{one.name} : {one.type}", one.metadata["doc"]) for one in dataclasses.fields(record))
        return
    for name, hint in get_type_hints(record, include_extras=True).items():
        kind, text = get_args(hint)
        yield f"{name} : {getattr(kind, '__name__', kind)}", text
    record.__annotations__.update(get_type_hints(record))  # as help() shows them, without the texts
