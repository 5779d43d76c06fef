"""Interpreted, whole programs do what gcc's machine code does; and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from crs_cc.debug.data.expression_memory import EvaluationError
from crs_cc.debug.data.interpret import Interpreter
from crs_cc.requests import MESSAGE
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.link import ROOT
from crs_cc.session.host import Host, HostRequest
from tests.c.execution import Run, build, cases

MAX = 150_000
"""Instructions of a case; those that run longer are left alone."""


class Bytes:
    """A robot's memory, all of it to be read and written."""

    def __init__(self, fleet: Fleet) -> None:
        self.trusting = False
        self.memory = fleet.memory(0)
        self.shadow = fleet.shadow(0)

    def read(self, address: int, size: int, *, judged: bool = True) -> bytes:
        return self.memory[address : address + size].tobytes()

    def write(self, address: int, content: bytes, states: bytes = b"") -> None:
        self.memory[address : address + len(content)] = np.frombuffer(content, np.uint8)

    def states(self, address: int, size: int) -> bytes:
        return self.shadow[address : address + size].tobytes()

    def state(self, address: int) -> int:
        return int(self.shadow[address])

    def mark(self, address: int, size: int, state: int) -> None:
        self.shadow[address : address + size] = state


class EndError(Exception):
    """The program has ended."""


class Talking(Interpreter):
    """Answers what small programs ask for."""

    def __init__(self, executable: Executable) -> None:
        self.fleet = Fleet([executable])
        self.output = output = bytearray()

        def say(_robot: int, stream: int, content: bytes) -> None:
            if stream == 1:
                output.extend(content)

        self.host = Host([["case"]], say, lambda *_: b"")
        memory = Bytes(self.fleet)
        super().__init__(executable.program, executable.detail().compiled.addresses, memory)

    def _request(self, code: int, message: int) -> int:
        """Answer as a host does; robots there are none."""
        row = np.frombuffer(bytearray(self.read(message & 0xFFFF_FFFF, MESSAGE.itemsize)), MESSAGE)
        self.host.serve(code, HostRequest(0, row[0]))
        if self.host.exit_status[0] is not None:
            raise EndError
        self.write(message, row.tobytes())
        return int(row["result"][0])


CASES = [path for path in cases("valid") if path.with_suffix(".out").exists()]


@pytest.mark.parametrize("path", CASES[::6], ids=lambda path: path.stem)
def test_interpreted_programs_print_what_gcc_programs_do(path: Path) -> None:
    executable = build(path)
    if Run(executable).to_end().fuel > 2 * MAX:
        pytest.skip("takes long")  # to find that out by interpreting it would
    talking = Talking(executable)
    try:
        talking._left = MAX
        talking._call(executable.program.functions[ROOT], [])
    except EndError:
        pass
    except EvaluationError as wrong:
        pytest.skip(str(wrong))
    assert talking.output == path.with_suffix(".out").read_bytes()
