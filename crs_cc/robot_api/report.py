"""The commands of the CRS report: their meaning, and differences from the vendor's.

>>> next(each for each in COMMANDS if each.name == "get_bp").vendors
'one bit for each bumper'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Command:
    """A command of the report.

    Attributes:
        prototype: its declaration in `crs/report.h`, without its name for the linker.
        units: the units of its arguments, in order; empty if none has a unit.
        meaning: its effect.
        vendors: difference of the vendor's function of that name; empty for none, "-" if the vendor
            has no such function.
        source: its place in the report.
    """

    prototype: str
    units: str
    meaning: str
    vendors: str
    source: str

    @property
    def name(self) -> str:
        """The function's name."""
        return self.prototype.partition("(")[0].split()[-1].lstrip("*")


COMMANDS: Final = (
    Command(
        "int connect_robot(int id, ...)", "",
        "connects; arguments after the number are ignored: (id, port, machine), or (id, model,"
        " device, v). Programs that do not call it are connected by their first command",
        "required; returns the server's port, not 1; prints its version to stderr",
        "Table 2, appendix A",
    ),
    Command(
        "int disconnect_robot(int id)", "", "ends the connection; the robot continues its motion",
        "", "Table 1, appendix A",
    ),
    Command(
        "int conf_tm(int timeout)", "s", "stops the robot if no command arrives for this time", "",
        "Table 1",
    ),
    Command(
        "int real_robot(void)", "", "requests a real robot", "", "Table 1",
    ),
    Command(
        "int simulated_robot(void)", "", "requests a simulated robot", "", "Table 1",
    ),
    Command(
        "int pr(int r_wheel, int l_wheel, int dummy)", "0.1 in",
        "moves the robot straight ahead by its first argument",
        "each wheel by its own distance", "appendix A",
    ),
    Command(
        "int vm(double speed)", "0.1 in/s",
        "sets the speed of the robot, rounded to an integer; with three arguments, as in 2.2.2,"
        " the speeds of the wheels",
        "always three arguments", "3.3, Table 2",
    ),
    Command(
        "int mv(int r_mode, int r_value, int l_mode, int l_value, int dummy_mode,"
        " int dummy_value)",
        "by mode", "commands each wheel in its own mode", "", "Table 1",
    ),
    Command("int st(void)", "", "stops the wheels", "", "2.2.2, 3.3"),
    Command(
        "int ws(int x, int y, int z, int dummy)", "",
        "waits until the robot has stopped, regardless of the arguments and of the time; also if"
        " it is blocked",
        "waits for the selected wheels, at most as many seconds as the last argument", "appendix A",
    ),
    Command(
        "int scout_pr(int trans, int steer)", "0.1 in, 0.1 deg",
        "moves, and turns right",
        "turns left", "2.2.3, appendix A",
    ),
    Command(
        "int scout_vm(int trans, int steer)", "0.1 in/s, 0.1 deg/s",
        "drives, and turns right", "turns left", "2.2.3",
    ),
    Command(
        "int dp(int x, int y)", "0.1 in", "sets the position in State", "", "3.3, appendix A",
    ),
    Command(
        "int ac(int r_wheel, int l_wheel, int dummy)", "0.1 in/s^2", "sets accelerations", "",
        "2.2.2",
    ),
    Command(
        "int sp(int r_wheel, int l_wheel, int dummy)", "0.1 in/s", "sets the speeds of pr", "",
        "Table 1",
    ),
    Command(
        "int conf_sn(int rate, int order[])", "4 ms, sonar numbers",
        "sets the firing order and interval of the sonars", "", "2.2.4",
    ),
    Command(
        "int get_sn(void)", "", "reads the last result of each sonar",
        "in whole inches, 255 for no echo", "2.2.5",
    ),
    Command(
        "int get_bp(void)", "", "reads the bumpers: 1 while any of them is pressed, else 0",
        "one bit for each bumper", "2.2.5, 4.3.2",
    ),
    Command(
        "int sonarSensorCheck(void)", "", "fires all sonars and reads them",
        "none; with `Nclient.h` it is another name of `get_sn`", "3.3, appendix A",
    ),
    Command(
        "int heatSensorCheck(void)", "", "reads the heat of all objects in the sensor's range", "-",
        "4.3.3, appendix A",
    ),
    Command(
        "int tagTarget(void)", "", "removes the heat of all objects in range", "-", "appendix A",
    ),
)  # fmt: skip
"""Every command of the report's dialect."""


REPORT_STATE: Final = (
    (
        "STATE_SONAR_0",
        "inches, 255 for no echo",
        "0.1 inch, -1 for no echo, and before the first reading",
    ),
    ("STATE_BUMPER", "bit n for switch n", "1 or 0"),
    ("STATE_CONF_X", "0.1 inch", "the same"),
    ("STATE_CONF_STEER", "0.1 degree, counter-clockwise", "the same"),
    ("STATE_VEL_RIGHT", "0.1 inch/s", "the same"),
    ("STATE_MOTOR_STATUS", "bit 0 right wheel, bit 1 left wheel", "the same"),
    ("STATE_HEAT", "-", "the heat in range, an integer"),
    ("NUM_STATE", "45", "46"),
)
"""The elements of State: index, contents in the vendor's dialect, in the report's."""

CHOICES: Final = """\
- `scout_pr` and `scout_vm` turn right, as section 2.2.3 states explicitly, although the vendor's
  macros turn left. With the vendor's direction, Table 2 would drive past the object that sonar 1,
  at the front left, has detected.
- The arguments of `vm` are the robot's speed (3.3, Table 2) or the speeds of both wheels (2.2.2);
  `pr` uses only its first argument (appendix A), although 2.2.2 specifies a distance per wheel.
- Every command updates State, but the readings of a sensor change only with the commands of that
  sensor.
- A robot that was never connected is connected by its first command; in the report, starting
  the robot connects it. After `disconnect_robot`, commands do nothing and return 0.
- Every command returns 1, or 0 on failure; in the report most are `void`, but the return value of
  `connect_robot` is used.
- The heat sensor reads the sum of the heat of all other objects whose nearest point is in its
  range, rounded; distance, direction and obstacles have no effect. `tagTarget` has the range of the
  sensor, unless the robot definition sets another.
- `STATE_HEAT` is the element after the vendor's `State`.
"""
"""Choices where the report is silent or contradicts itself."""
