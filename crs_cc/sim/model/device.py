"""Device descriptions: one row for each device, from which everything else is derived.

From the row are derived the elements of robot definitions and their schema, the columns of the
state, request codes and handlers, timers, noise streams, degradation, the declarations of `crs.h`,
the inspector's rows, and the tables of the docs.

A new device is a package in `crs_cc/sim/devices` with a `DEVICE`; a third-party device is the same
in another package, named by an entry point of the group `crs_cc.devices`. Sensors that measure a
few numbers have a simpler row, see `devices.sensor`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy.typing as npt

from crs_cc.requests import Request
from crs_cc.robot_api.row import Function
from crs_cc.sim.model.degradable import Degradable

NAME: Final = re.compile(r"[a-z][a-z0-9_]{0,31}")
"""Valid names of devices and values: they become names in C and Python."""

_ELEMENT: Final = re.compile(r"[a-z][a-z0-9-]{0,31}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Device:
    """A sensor or an actuator of robots.

    Attributes:
        name: one word: its name in the state and in the models of robots.
        title: its title in the docs, such as `Inclinometer`.
        element: its element in robot definitions; empty if that of another device describes it
            too, which its `read` then reads.
        summary: one sentence for the schema.
        model: the dataclass of its constants; its element's attributes are the fields made by
            `attribute`.
        read: reads its model from the root element of a robot definition, given that and the
            `files.document.Reader`; None to read it from the attributes of the element.
        write: returns the elements of a robot definition that describe it, given the model of the
            robot; None to write its model to the attributes of the element.
        state: returns the columns of its state at the start, a dataclass of arrays with a row for
            each device, given the models of all; None if it has none.
        dense: whether these have a row for every robot instead, with None as the model of robots
            without the device.
        install: equips the robots of a world with it: given this row, the world, the seed and the
            event log, returns `devices.installed.Installed`.
        requests: its requests; those with a negative code get one from the registry.
        functions: its C functions.
        declarations: C code that goes before them in `crs.h`: types and constants.
        code: the C source of its functions, unless there is a file `<name>.c` in its folder.
        degradables: what of it can be degraded.
        inspect: returns what inspectors show of one, given the state and its number.
        reading: returns its last reading [SI unit] without measuring, given the state, its model
            and its number: a row of the state where possible; NaN before the first measurement.
            None if it measures nothing.
        number: its number in `crs.h` as a sensor that can have a timer; None for others, negative
            for the next free one.
        stream: the number of its noise stream; negative to derive it from its name.
        source: the device's file, whose docstring the docs show; it is `__file__` of the package.
    """

    name: str
    title: str
    element: str
    summary: str
    model: type
    install: Callable[..., Any]
    state: Callable[[Sequence[Any]], Any] | None = None
    read: Callable[[Any, Any], Any] | None = None
    write: Callable[[Any], list[Any]] | None = None
    requests: tuple[Request, ...] = ()
    functions: tuple[Function, ...] = ()
    declarations: str = ""
    code: str = ""
    degradables: tuple[Degradable, ...] = ()
    inspect: Callable[[Any, int], str] | None = None
    reading: Callable[[Any, Any, int], npt.NDArray[Any]] | None = None
    dense: bool = False
    number: int | None = None
    stream: int = -1
    source: str = ""

    @property
    def folder(self) -> Path:
        """The device's folder, which may contain a C file of its own."""
        return Path(self.source).parent

    def validation_error(self) -> str:
        """Return why the row is invalid; empty if it is valid."""
        is_shared = not self.element and self.read is not None
        if not NAME.fullmatch(self.name) or not (is_shared or _ELEMENT.fullmatch(self.element)):
            return "name and element must be lower-case words"
        return ""
