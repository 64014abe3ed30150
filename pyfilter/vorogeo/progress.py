"""Progress reports: a function of the caller, or a tqdm bar."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeAlias

from .errors import InvalidInput

#: Gets the fraction done and what is being done; a result of False cancels, any other (None, 0) continues.
ProgressFunction: TypeAlias = Callable[[float, str], object]


@contextmanager
def reporter(progress: ProgressFunction | bool | None) -> Iterator[Callable[[float, str], object] | None]:
    """The function to call for `progress`; a bar that it opened is closed at the end."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        bar = _bar()
        try:
            yield _advance(bar)
        finally:
            bar.close()
    elif callable(progress):
        yield progress
    else:
        raise InvalidInput(
            f"progress: {progress!r} is not a function; give one that takes (fraction, text), True for a tqdm bar, "
            "or None."
        )


def _bar() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        raise ImportError(
            "progress=True draws its bar with tqdm, which is not installed; run 'pip install tqdm' or give a function."
        ) from None
    return tqdm(total=100, unit="%", bar_format="{l_bar}{bar}| {elapsed}<{remaining}")


def _advance(bar: Any) -> Callable[[float, str], None]:
    def report(fraction: float, text: str) -> None:
        bar.set_description_str(text, refresh=False)
        bar.update(100 * fraction - bar.n)

    return report
