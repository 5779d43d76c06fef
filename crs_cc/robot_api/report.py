"""The commands of the CRS report: what they mean, and what is otherwise with the vendor's.

>>> next(each for each in COMMANDS if each.name == "get_bp").vendors
'a bit for each bumper'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Command:
    """A command of the report's.

    Attributes:
        prototype: how `crs/report.h` declares it, its name for the linker left out.
        units: of its arguments, in their order; empty when it has none that count.
        meaning: what it does.
        vendors: what is otherwise with the vendor's function of that name; empty when nothing is,
            "-" when the vendor has none.
        source: where in the report it stands.
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
        "connects; what follows the number is read by nobody: (id, port, machine), or (id, model,"
        " device, v). Programs that do not call it are connected by their first command",
        "must be called; gives the server's port, not 1; says its version on stderr",
        "Table 2, appendix A",
    ),
    Command(
        "int disconnect_robot(int id)", "", "ends the connection; the robot goes on as it was told",
        "", "Table 1, appendix A",
    ),
    Command(
        "int conf_tm(int timeout)", "s", "stops the robot when no command came for so long", "",
        "Table 1",
    ),
    Command(
        "int real_robot(void)", "", "asks for a real robot", "", "Table 1",
    ),
    Command(
        "int simulated_robot(void)", "", "asks for a simulated robot", "", "Table 1",
    ),
    Command(
        "int pr(int r_wheel, int l_wheel, int dummy)", "0.1 in",
        "moves the robot straight on by its first argument",
        "each wheel by its own way", "appendix A",
    ),
    Command(
        "int vm(double speed)", "0.1 in/s",
        "sets the speed of the robot, to the nearest whole number; with three arguments, as in"
        " 2.2.2, the speeds of the wheels",
        "three arguments always", "3.3, Table 2",
    ),
    Command(
        "int mv(int r_mode, int r_value, int l_mode, int l_value, int dummy_mode,"
        " int dummy_value)",
        "by mode", "commands each wheel in a mode of its own", "", "Table 1",
    ),
    Command("int st(void)", "", "stops the wheels", "", "2.2.2, 3.3"),
    Command(
        "int ws(int x, int y, int z, int dummy)", "",
        "waits until the robot stands, whatever the arguments, however long; also when something"
        " holds it up",
        "waits for the wheels that are chosen, and at most as many seconds as the last argument"
        " says", "appendix A",
    ),
    Command(
        "int scout_pr(int trans, int steer)", "0.1 in, 0.1 deg",
        "moves on, and turns to the right",
        "turns to the left", "2.2.3, appendix A",
    ),
    Command(
        "int scout_vm(int trans, int steer)", "0.1 in/s, 0.1 deg/s",
        "drives, and turns to the right", "turns to the left", "2.2.3",
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
        "sets which sonars fire in turn, and how often", "", "2.2.4",
    ),
    Command(
        "int get_sn(void)", "", "reads what the sonars told at their last turn",
        "in whole inches, 255 for nothing", "2.2.5",
    ),
    Command(
        "int get_bp(void)", "", "reads the bumpers: 1 while anything is touched, else 0",
        "a bit for each bumper", "2.2.5, 4.3.2",
    ),
    Command(
        "int sonarSensorCheck(void)", "", "lets all sonars fire and reads them",
        "none; with `Nclient.h` it is another name of `get_sn`", "3.3, appendix A",
    ),
    Command(
        "int heatSensorCheck(void)", "", "reads the heat of all things in the sensor's range", "-",
        "4.3.3, appendix A",
    ),
    Command(
        "int tagTarget(void)", "", "takes the heat from all things in range", "-", "appendix A",
    ),
)  # fmt: skip
"""Every command of the report's dialect."""


REPORT_STATE: Final = (
    ("STATE_SONAR_0", "inches, 255 for nothing", "0.1 inch, -1 for nothing, and before any check"),
    ("STATE_BUMPER", "bit n for switch n", "1 or 0"),
    ("STATE_CONF_X", "0.1 inch", "the same"),
    ("STATE_CONF_STEER", "0.1 degree, to the left", "the same"),
    ("STATE_VEL_RIGHT", "0.1 inch/s", "the same"),
    ("STATE_MOTOR_STATUS", "bit 0 right wheel, bit 1 left wheel", "the same"),
    ("STATE_HEAT", "-", "the heat in range, a whole number"),
    ("NUM_STATE", "45", "46"),
)
"""What stands in State: its index, in the vendor's dialect, in the report's."""

CHOICES: Final = """\
- `scout_pr` and `scout_vm` turn to the right, as 2.2.3 says in so many words, although the vendor's
  macros turn to the left. With the vendor's sense Table 2 would drive past the object that sonar 1,
  ahead to the left, has found.
- `vm` takes the robot's speed (3.3, Table 2) or the speeds of both wheels (2.2.2); `pr` goes by its
  first argument alone, as appendix A says, although 2.2.2 gives each wheel a way.
- State is refreshed by each command, but what a sensor tells only by the commands of that sensor.
- A robot that was never connected is connected by its first command, as in the report whoever
  starts the robot connects it. After `disconnect_robot` commands do nothing and give 0.
- Every command gives 1, or 0 when it was not done; the report has `void` for most of them, and uses
  what `connect_robot` gives.
- The heat sensor reads the sum of the heat of all other things whose nearest point is within its
  range, rounded; distance, direction and what stands between count for nothing. `tagTarget` reaches
  as far as the sensor, unless the robot definition says otherwise.
- `STATE_HEAT` is the element behind the vendor's `State`.
"""
"""Where the report is silent, or says two things."""
