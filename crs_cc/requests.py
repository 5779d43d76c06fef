"""The door between a control program and everything outside its memory.

A program can do one thing to the world: fill in a message, post it with a request code, and stop.
Whoever runs it finds the message in the program's slot, writes the reply over it, and resumes the
program. All slots of a fleet lie side by side in one memory that C cannot address; `SLOT` is how
numpy sees it. `REQUESTS` lists every code; nothing else crosses.

>>> import numpy as np
>>> slots = np.zeros(2, SLOT)                       # two robots
>>> slots["code"] = [CODES["VM"], CODES["WRITE"]]   # what they asked for
>>> slots["message"]["i"][0, :2] = 100, 80          # robot 0: 10 and 8 inches a second
>>> REQUESTS[slots["code"][0]].prototype
'int vm(int trans, int steer, int turret)'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

MESSAGE: Final = np.dtype(
    [
        ("i", "<i4", (8,)),  # integer arguments, then integer results
        ("f", "<f8", (4,)),  # floating arguments, then floating results
        ("size", "<i4"),  # bytes of `data` in use, 0 to 248
        ("result", "<i4"),  # the reply's result, what `__crs_request` gives
        ("data", "u1", (248,)),
    ]
)
"""The message that a program posts and the reply that it finds in its place: 320 bytes.

`struct __crs_message` in `crs_request.h` is the same for C; a test holds the two together.
"""

DATA_SIZE: Final = MESSAGE["data"].shape[0]

SLOT: Final = np.dtype(
    [
        ("run", "<i4"),  # 1: resume the robot in the next round
        ("status", "<i4"),  # how it came back, one of the STATUS constants
        ("code", "<i4"),  # the request it posted; 0 when it stopped for another reason
        ("error_kind", "<i4"),  # index into ERROR_KINDS
        ("error_site", "<i4"),  # number of the place in the code, see `runtime.codegen`
        ("error_address", "<u4"),  # the address or value that was refused
        ("fuel", "<i8"),  # in: fuel it may burn; out: what is left, below 0 when overdrawn
        ("statements", "<i8"),  # statements begun so far (debug density only)
        ("stop_at", "<i8"),  # statement number to stop before, -1 for none (debug density only)
        ("error_size", "<u4"),  # bytes of the access that failed; 0 where the code knows
        ("reserved", "<u4", (3,)),
        ("message", MESSAGE),
    ]
)
"""One robot's slot: 384 bytes."""


def slot_offset(field: str) -> int:
    """Gives where a field lies in a robot's slot [bytes]."""
    return int(SLOT.fields[field][1])  # type: ignore[index]


RETURNED: Final = 0
SUSPENDED: Final = 1
FAILED: Final = 2

ERROR_KINDS: Final = (
    "none",
    "null pointer",
    "pointer outside memory",
    "wild pointer",  # into memory, but to no object
    "out of bounds",
    "use after free",
    "use after scope",
    "use after return",
    "uninitialised read",
    "invalid free",
    "double free",
    "missing argument",  # `va_arg` behind the last argument
    "no value returned",  # and yet used
    "mismatched call",  # through a pointer to a function that would misread its arguments
    "shift out of range",
    "signed overflow",
    "division by zero",
    "division overflow",
    "bad function pointer",
    "stack overflow",
    "damaged stack",
    "unreachable code reached",
    "abort called",
    "assertion failed",
    "array length not positive",
    "no memory for local array",
    "goto to no label",
    "longjmp without setjmp",
    "longjmp to a function that has returned",
    "unhandled signal",
    "internal trap",
)
"""What can stop a program, by the number in the slot."""

Server = Literal["host", "robot"]


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument or result of a request.

    Attributes:
        place: where in the message it lies, as written in Python: `i[0]`, `f[1]`, `data`, `result`.
        name: what it is.
        unit: its unit; "1" for a number without unit.
    """

    place: str
    name: str
    unit: str = "1"


@dataclass(frozen=True, slots=True)
class RequestCode:
    """One kind of request.

    Attributes:
        name: its name, `CRS_<name>` in C.
        code: its number.
        server: who answers it: the session as the program's host, or the simulated robot.
        prototype: the C function that posts it.
        meaning: what it does.
        arguments: what the message holds when it is posted.
        results: what the message holds when the program goes on.
    """

    name: str
    code: int
    server: Server
    prototype: str
    meaning: str
    arguments: tuple[Argument, ...] = ()
    results: tuple[Argument, ...] = ()


def _arguments(*rows: tuple[str, str, str]) -> tuple[Argument, ...]:
    return tuple(Argument(*row) for row in rows)


_SPEED, _ACCELERATION, _LENGTH, _ANGLE = "0.1 in/s", "0.1 in/s^2", "0.1 in", "0.1 deg"
_STATE = _arguments(
    ("result", "1 when done, else 0", "1"),
    ("data", "State[45] as 45 int32, each in its own unit", "see NUM_STATE"),
)


def _wheels(unit: str) -> tuple[Argument, ...]:
    return _arguments(
        ("i[0]", "right wheel", unit), ("i[1]", "left wheel", unit), ("i[2]", "unused", "1")
    )


def _robot(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Argument, ...] = ()
) -> RequestCode:
    return RequestCode(name, code, "robot", prototype, meaning, arguments, _STATE)


_TABLE: Final = (
    RequestCode(
        "EXIT", 1, "host", "void exit(int status)", "ends the program",
        _arguments(("i[0]", "exit status", "1")),
    ),
    RequestCode(
        "WRITE", 2, "host", "int write(int fd, const void *bytes, unsigned count)",
        "writes to the standard output (1) or error (2) stream",
        _arguments(("i[0]", "stream", "1"), ("size", "bytes", "byte"), ("data", "the bytes", "1")),
        _arguments(("result", "bytes written, -1 on error", "byte")),
    ),
    RequestCode(
        "READ", 3, "host", "int read(int fd, void *bytes, unsigned count)",
        "reads from the standard input stream (0)",
        _arguments(("i[0]", "stream", "1"), ("i[1]", "bytes wanted", "byte")),
        _arguments(
            ("result", "bytes read, 0 at the end, -1 on error", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
    ),
    RequestCode(
        "CLOCK", 4, "host", "int gettimeofday(struct timeval *now, void *zone)",
        "reads the program's simulated clock",
        (), _arguments(("f[0]", "time since the start of the run", "s"),
                       ("f[1]", "processor time used", "s")),
    ),
    RequestCode(
        "SLEEP", 5, "host", "int usleep(unsigned microseconds)",
        "lets simulated time pass",
        _arguments(("f[0]", "how long", "s")), _arguments(("result", "0", "1")),
    ),
    RequestCode(
        "ARGUMENT", 6, "host", "int main(int argc, char **argv)",
        "reads a piece of one of the program's arguments",
        _arguments(("i[0]", "number of the argument", "1"), ("i[1]", "first byte wanted", "byte")),
        _arguments(
            ("result", "length of the argument, -1 when there is none", "byte"),
            ("size", "bytes", "byte"), ("data", "the piece", "1"),
        ),
    ),
    RequestCode(
        "FILE_OPEN", 7, "host", "FILE *fopen(const char *name, const char *mode)",
        "opens a file on the robot's own disk, or makes it",
        _arguments(
            ("i[0]", "flags: O_CREAT, O_EXCL, O_TRUNC, O_TMPFILE of fcntl.h", "1"),
            ("size", "length of the name", "byte"), ("data", "the name", "1"),
        ),
        _arguments(("result", "the file's number, or -errno", "1")),
    ),
    RequestCode(
        "FILE_CLOSE", 8, "host", "int close(int fd)", "says that an open file is no longer needed",
        _arguments(("i[0]", "the file's number", "1")), _arguments(("result", "0, or -errno", "1")),
    ),
    RequestCode(
        "FILE_READ", 9, "host",
        "size_t fread(void *items, size_t size, size_t count, FILE *stream)",
        "reads from a file",
        _arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "first byte wanted", "byte"),
            ("i[2]", "bytes wanted", "byte"),
        ),
        _arguments(
            ("result", "bytes read, 0 at the end, or -errno", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
    ),
    RequestCode(
        "FILE_WRITE", 10, "host",
        "size_t fwrite(const void *items, size_t size, size_t count, FILE *stream)",
        "writes to a file",
        _arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "where, -1 for the end", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
        _arguments(("result", "place behind what was written, or -errno", "byte")),
    ),
    RequestCode(
        "FILE_RESIZE", 11, "host", "int ftruncate(int fd, off_t size)",
        "cuts a file off or fills it up with zeros",
        _arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "size, -1 for no change", "byte")
        ),
        _arguments(("result", "size, or -errno", "byte")),
    ),
    RequestCode(
        "FILE_REMOVE", 12, "host", "int remove(const char *name)", "takes a file's name away",
        _arguments(("size", "length of the name", "byte"), ("data", "the name", "1")),
        _arguments(("result", "0, or -errno", "1")),
    ),
    RequestCode(
        "FILE_RENAME", 13, "host", "int rename(const char *from, const char *to)",
        "gives a file another name",
        _arguments(
            ("i[0]", "length of the old name", "byte"), ("size", "length of both", "byte"),
            ("data", "the old name, the new name", "1"),
        ),
        _arguments(("result", "0, or -errno", "1")),
    ),
    _robot("CONNECT", 100, "int connect_robot(long id, ...)", "connects to the robot",
           _arguments(("i[0]", "robot number", "1"))),
    _robot("DISCONNECT", 101, "int disconnect_robot(long id)", "ends the connection",
           _arguments(("i[0]", "robot number", "1"))),
    _robot("AC", 102, "int ac(int trans, int steer, int turret)", "sets accelerations",
           _wheels(_ACCELERATION)),
    _robot("SP", 103, "int sp(int trans, int steer, int turret)", "sets the speeds of `pr`",
           _wheels(_SPEED)),
    _robot("PR", 104, "int pr(int trans, int steer, int turret)", "starts a relative move",
           _wheels(_LENGTH)),
    _robot("VM", 105, "int vm(int trans, int steer, int turret)", "sets wheel speeds",
           _wheels(_SPEED)),
    _robot(
        "MV", 106,
        "int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)",
        "commands each axis in a mode of its own (MV_IGNORE, MV_VM, MV_PR, MV_LP, MV_AC, MV_SP)",
        _arguments(
            ("i[0]", "mode of the right wheel", "1"), ("i[1]", "its value", "by mode"),
            ("i[2]", "mode of the left wheel", "1"), ("i[3]", "its value", "by mode"),
            ("i[4]", "mode of the turret", "1"), ("i[5]", "its value", "by mode"),
        ),
    ),
    _robot("ST", 107, "int st(void)", "stops the wheels and holds them"),
    _robot("LP", 108, "int lp(void)", "lets the wheels go limp"),
    _robot(
        "WS", 109,
        "int ws(unsigned char t, unsigned char s, unsigned char r, unsigned char timeout)",
        "waits until the chosen wheels stand still",
        _arguments(
            ("i[0]", "1 to wait for the right wheel", "1"),
            ("i[1]", "1 to wait for the left wheel", "1"), ("i[2]", "unused", "1"),
            ("i[3]", "longest wait", "s"),
        ),
    ),
    _robot("DP", 110, "int dp(int x, int y)", "sets the position of the odometry",
           _arguments(("i[0]", "x", _LENGTH), ("i[1]", "y", _LENGTH))),
    _robot("DA", 111, "int da(int th, int tu)", "sets the angles of the odometry",
           _arguments(("i[0]", "heading", _ANGLE), ("i[1]", "turret", _ANGLE))),
    _robot("ZR", 112, "int zr(void)", "sets the odometry to zero"),
    _robot(
        "CONF_SN", 113, "int conf_sn(int rate, int order[16])", "sets the sonars' firing order",
        _arguments(
            ("i[0]", "time between two firings", "4 ms"), ("size", "sonars in the order", "1"),
            ("data", "the order, one byte each", "sonar number"),
        ),
    ),
    _robot(
        "CONF_TM", 114, "int conf_tm(unsigned char timeout)",
        "stops the wheels when no command came for so long, 0 for never",
        _arguments(("i[0]", "timeout", "s")),
    ),
    _robot("GS", 115, "int gs(void)", "reads the whole state"),
    _robot("GET_SN", 116, "int get_sn(void)", "reads the sonars"),
    _robot("GET_BP", 117, "int get_bp(void)", "reads the bumpers"),
    _robot("GET_RC", 118, "int get_rc(void)", "reads the odometry's pose"),
    _robot("GET_RV", 119, "int get_rv(void)", "reads the wheel speeds"),
)  # fmt: skip

REQUESTS: Final[dict[int, RequestCode]] = {request.code: request for request in _TABLE}
"""Every request by its number."""

CODES: Final[dict[str, int]] = {request.name: request.code for request in _TABLE}
"""Every request's number by its name."""

NUM_STATE: Final = 45
"""Length of the vendor's `State` array (vendor header `Nclient.h` 1.29)."""
