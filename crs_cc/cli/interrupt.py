"""Ctrl-C: end a run between two timesteps, so that its results are complete."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Self


class Interrupt:
    """Handle SIGINT inside a `with` block.

    The first one only requests the end of the run; the second, or the first while the run waits
    for input, raises `KeyboardInterrupt` at once.

    Attributes:
        requested: whether the end of the run is requested.
    """

    def __init__(self) -> None:
        self.requested = False
        self._is_waiting = False
        self._listens = threading.current_thread() is threading.main_thread()

    def __enter__(self) -> Self:
        if self._listens:
            self._before = signal.signal(signal.SIGINT, self._handle)
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _where: TracebackType | None,
    ) -> None:
        if self._listens:
            signal.signal(signal.SIGINT, self._before)

    @contextmanager
    def waiting(self) -> Iterator[None]:
        """Mark a block that waits for input, where `requested` is not polled."""
        self._is_waiting = True
        try:
            yield
        finally:
            self._is_waiting = False

    def _handle(self, _signal: int, _frame: FrameType | None) -> None:
        if self.requested or self._is_waiting:
            raise KeyboardInterrupt
        self.requested = True
