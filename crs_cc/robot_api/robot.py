"""The functions of the robot: connection, motion, configuration, reading."""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import ALL, HEADER, OURS, SOURCE, Function, Group

_BOTH: Final = (HEADER, SOURCE)
_LENGTHS: Final = "0.1 in, 0.1 deg, 0.1 deg; on the Scout 0.1 in of the right and left wheel, 0"
_NO_SENSOR: Final = "FALSE on a Scout or Nomad 150"
_NOTHING: Final = "TRUE, no effect"


def _per(time: str) -> str:
    """Return the units of speeds or accelerations."""
    return _LENGTHS.replace("in", f"in/{time}").replace("deg", f"deg/{time}")


CONNECTION: Final = Group("Connection", (
    Function(
        "int connect_robot(long robot_id, ...)",
        "connects, sends the mask of `init_mask`, and returns the server's port (not 0, not 1);"
        " prints a greeting to stderr once. Without a server, prints a message to stdout, sets"
        " State[STATE_ERROR] to 111 and returns FALSE",
        refreshes=ALL, posts=("CONNECT", "CT"), source=_BOTH,
        under_ndirect="also reads the model, the device and its baud rate or port, prints to"
                      " stdout how it is connected, and returns TRUE; a Scout's mask is fixed,"
                      " without infrared and laser",
        chosen="The robot number is ignored: a program's robot is the one it runs on; every host "
               "name and port is accepted. Nclient ignores the device and its speed; Ndirect "
               "sets the line to the baud rate, but uses the robot's model instead of the "
               "argument.",
    ),
    Function(
        "int create_robot(long robot_id)", "the same without the greeting and the mask",
        posts=("CREATE",), source=_BOTH, under_ndirect=_NOTHING,
        chosen="The function was disabled in the vendor's server; ours connects to the robot.",
    ),
    Function(
        "int disconnect_robot(long robot_id)",
        "ends the connection; the robot continues its motion until the timeout of `conf_tm`",
        posts=("DISCONNECT",), source=_BOTH, under_ndirect="TRUE, the line stays open",
    ),
    Function(
        "int server_is_running(void)", "`connect_robot(1)`",
        refreshes=ALL, posts=("CONNECT", "CT"), source=(SOURCE,),
        under_ndirect="connects over /dev/ttyS0 at 38400 baud",
    ),
    Function(
        "int quit_server(void)",
        "stops the server: from then on all functions return FALSE with State[STATE_ERROR] 111",
        posts=("QUIT_SERVER",), source=_BOTH, under_ndirect=_NOTHING,
        chosen="The server stops for this program only; the program's robot continues its motion.",
    ),
    Function(
        "int real_robot(void)", "requests a real robot", posts=("REAL_ROBOT",), source=_BOTH,
        under_ndirect=_NOTHING, chosen="There is no real robot, so the call has no effect.",
    ),
    Function(
        "int simulated_robot(void)", "requests a simulated robot", posts=("SIMULATED_ROBOT",),
        source=_BOTH, under_ndirect=_NOTHING,
    ),
    Function(
        "int set_server_machine_name(char *name)", "sets SERVER_MACHINE_NAME", source=(SOURCE,)
    ),
    Function("int set_serv_tcp_port(int port)", "sets SERV_TCP_PORT", source=(SOURCE,)),
))  # fmt: skip

MOTION: Final = Group("Motion", (
    Function(
        "int ac(int trans, int steer, int turret)",
        "sets accelerations; signs are ignored", units=_per("s²"),
        refreshes=ALL, posts=("AC",), source=_BOTH,
        chosen="The vendor's simulator ignored it; ours behaves like the robot.",
    ),
    Function(
        "int sp(int trans, int steer, int turret)",
        "sets the speeds of `pr`, without moving; signs are ignored", units=_per("s"),
        refreshes=ALL, posts=("SP",), source=_BOTH,
    ),
    Function(
        "int pr(int trans, int steer, int turret)",
        "starts a relative move and returns", units=_LENGTHS,
        refreshes=ALL, posts=("PR",), source=_BOTH,
        chosen="The move starts from the current speed; if that is too fast to stop in time, the "
               "axis reverses. A blocked move continues when the path is free; until then its "
               "motors keep working, and `ws` waits.",
    ),
    Function(
        "int pa(int trans, int steer, int turret)", "returns FALSE, sends nothing",
        under_ndirect="on a Nomad 200 turns steering and turret to absolute angles; the"
                      " effect on the translation is unknown, and not simulated",
        source=(SOURCE,), declared=False,
    ),
    Function(
        "int vm(int trans, int steer, int turret)",
        "drives at these speeds until the next command, or the timeout of `conf_tm`",
        units=_per("s"), refreshes=ALL, posts=("VM",), source=_BOTH,
        chosen="If the robot is blocked, motors weaker than the wheels' grip stall, and odometry"
               " counts their rolling; stronger motors make the wheels slip, and odometry"
               " counts as if nothing blocked them (`force`, `grip`). Motors give up after the"
               " time `give-up`, if set. Contacts never turn a robot.",
    ),
    Function(
        "int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)",
        "commands each axis in its own mode; returns FALSE without sending for any mode other"
        " than MV_IGNORE, MV_VM, MV_PR, MV_LP, MV_AC, MV_SP",
        units="those of the mode's command", refreshes=ALL, posts=("MV",), source=_BOTH,
        under_ndirect="sends every mode",
    ),
    Function(
        "int st(void)", "stops the axes and holds them",
        refreshes=ALL, posts=("ST",),
        chosen="The robot brakes with the acceleration of `ac`, and then holds with the wheels' "
        "grip.",
    ),
    Function(
        "int lp(void)", "makes the motors limp", refreshes=ALL, posts=("LP",),
        chosen="The wheels coast (`roll-out`); when the robot is pushed along them, they roll, "
        "and the encoders count; steering and turret stop.",
    ),
    Function(
        "int ws(unsigned char trans, unsigned char steer, unsigned char turret,"
        " unsigned char timeout)",
        "does not stop anything",
        units="-, -, -, s",
        refreshes=ALL, posts=("WS",),
        waits="until the axes with nonzero arguments have stopped, at most `timeout` seconds",
        source=_BOTH, chosen="The meaning of a timeout of 0 is a parameter, `ws-timeout-zero`.",
    ),
    Function(
        "int dp(int x, int y)", "sets the position of the odometry", units="0.1 in",
        refreshes=ALL, posts=("DP",),
    ),
    Function(
        "int da(int th, int tu)", "sets the heading and the turret angle of the odometry",
        units="0.1 deg", refreshes=ALL, posts=("DA",),
    ),
    Function(
        "int zr(void)", "sets the odometry to 0; a Nomad turns steering and turret to their zero"
                        " positions",
        refreshes=ALL, posts=("ZR",), source=(HEADER, "RWI", "CARMEN"),
        waits="for these turns, at most 120 s",
        chosen="A Scout does not move. A Nomad stops, and turns in the shorter direction, at the "
               "speeds of `sp`, until wheels and turret point to the front of the base; "
               "`conf_tm` is inactive until then.",
    ),
))  # fmt: skip

CONFIGURATION: Final = Group("Configuration", (
    Function(
        "int conf_sn(int rate, int order[16])",
        "sets the firing order of the sonars and the firing interval; 255 ends the order; as the"
        " first element, it switches the sonars off, as does NULL", units="4 ms, sonar numbers",
        refreshes=ALL, posts=("CONF_SN",), source=(HEADER, SOURCE, "CARMEN"),
        chosen="NULL is our interpretation of what CARMEN passes. An order with a sonar that the"
               " robot does not have is rejected. Intervals shorter than the definition's least"
               " interval (40 ms on a Scout, the time of the longest echo), including 0, mean that"
               " interval. The first sonar fires immediately; a pending echo of the previous one"
               " is discarded. Sonars that are not in the order read 255. Before the first call,"
               " sonars fire in the definition's order, and a cycle of it has just been completed"
               " when the program starts.",
    ),
    Function(
        "int conf_ir(int history, int order[16])",
        "sets which infrared sensors measure, and what fraction of a reading carries over to the"
        " next",
        units="0.1, sensor numbers", refreshes=ALL, posts=("CONF_IR",),
        under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="Sensors that are not in the order read 15.",
    ),
    Function(
        "int conf_cp(int mode)", "controls the compass: 0 off, 1 on, 2 calibrates it, while the"
                                 " turret turns once in 3 minutes", refreshes=ALL,
        posts=("CONF_CP",),
        under_ndirect=f"{_NO_SENSOR}; on a Nomad 200 prints `compass calibration score x: 0 y: 0 z:"
                      " 0` and leaves State",
        chosen="The compass is initially off, and keeps its last reading while it is off. The "
               "program continues during the calibration; `ws` waits for it.",
    ),
    Function(
        "int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width,"
        " unsigned int num_data, unsigned int processing)",
        "configures the laser: 51 for points, 33 for segments, 0 off",
        units="-, -, pixel, readings, pixel", refreshes=ALL, posts=("CONF_LS",),
        under_ndirect=_NO_SENSOR,
        chosen="Modes that return pixels are rejected; threshold and width of the line are"
               " ignored; points are at equal angles from the right to the left of the field of"
               " view, and 0 requests all of them; averaging pixels reduces errors.",
    ),
    Function(
        "int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap)",
        "configures the conversion of laser points to segments", units="(0.1 in)^2, points, 0.1 in",
        refreshes=ALL, posts=("CONF_SG",), under_ndirect=_NO_SENSOR,
        chosen="The threshold is the largest mean square of the distances of points from their"
               " segment; the defaults are the values recommended in the vendor's header: 50, 4"
               " and 30. For details see `crs_cc/sim/geometry/split_and_merge.py`.",
    ),
    Function(
        "int conf_tm(unsigned char timeout)",
        "stops the motion if no command arrives for this time; 0 for never; the argument is"
        " truncated to a byte: 1000 becomes 232", units="s", refreshes=ALL, posts=("CONF_TM",),
        chosen="The value before the first call is a parameter, `timeout`.",
    ),
    Function(
        "int conf_ser(unsigned char port, unsigned short baud)",
        "sets the speed of the serial line, 4800, 9600, 19200 or 38400; FALSE on a Nomad 200; not"
        " declared in any header",
        units="-, baud", refreshes=ALL, posts=("CONF_SER",), source=(SOURCE,), declared=False,
        chosen="Nclient lacks this function; ours behaves like Ndirect's. The port is ignored.",
    ),
    Function(
        "int ct(void)", "sends Smask, which becomes the active mask",
        refreshes=ALL, posts=("CT",), source=_BOTH,
        under_ndirect="FALSE on a Scout or Nomad 150, whose mask is fixed",
    ),
    Function("void init_mask(void)", "sets Smask[0] to 0 and all others to 1", source=_BOTH),
    Function(
        "int init_sensors(void)", "`init_mask` and `ct`", refreshes=ALL, posts=("CT",),
        source=_BOTH, under_ndirect="FALSE on a Scout or Nomad 150, but Smask is set",
    ),
    Function("int get_mask(int mask[NUM_MASK])", "copies the active mask, not Smask",
             source=(SOURCE,)),
    Function("int set_mask(int mask[NUM_MASK])", "copies a mask to Smask, without sending it",
             source=(SOURCE,)),
))  # fmt: skip

READING: Final = Group("Reading", (
    Function("int gs(void)", "reads the whole state", refreshes=ALL, posts=("GS",)),
    Function(
        "int get_ir(void)", "reads the infrared sensors", refreshes="STATE_IR_*",
        posts=("GET_IR",), under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="A reading is the distance to a white surface in inches, 15 for nothing near; a"
               " surface that reflects a quarter appears twice as far away.",
    ),
    Function(
        "int get_sn(void)", "reads the last result of each sonar, in whole inches",
        refreshes="STATE_SONAR_*", posts=("GET_SN",), source=_BOTH,
        chosen="A reading changes when its echo arrives, 1.8 ms after the firing for each foot,"
               " or, without an echo, when the listening time ends. The parameters of `<sonars>` in"
               " a robot definition determine what is detected; the formulas are in"
               " `crs_cc/sim/geometry/echoes.py` and `crs_cc/sim/devices/sonar/errors.py`.",
    ),
    Function(
        "int get_rc(void)", "reads the pose of the odometry", refreshes="STATE_CONF_*",
        posts=("GET_RC",), source=_BOTH,
    ),
    Function(
        "int get_rv(void)", "reads the speeds", refreshes="STATE_VEL_*", posts=("GET_RV",),
        source=_BOTH,
    ),
    Function(
        "int get_ra(void)", "reads the accelerations, which have no entry in State: Nclient writes"
        " them over the speeds, Ndirect does not store them",
        posts=("GET_RA",), source=_BOTH,
    ),
    Function(
        "int get_cp(void)", "reads the compass", refreshes="STATE_COMPASS", posts=("GET_CP",),
        under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="The compass turns with the turret; angles are counter-clockwise from the world's "
        "x axis.",
    ),
    Function(
        "int get_ls(void)", "reads the laser's points", refreshes="Laser",
        posts=("GET_LS", "LASER_PAGE"), under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="Points are in the frame of the turret, which carries the laser; directions "
               "without an object in range have no point. It returns points in every mode, "
               "`get_sg` segments.",
    ),
    Function(
        "int get_bp(void)", "reads the bumpers", refreshes="STATE_BUMPER", posts=("GET_BP",),
        source=_BOTH,
        chosen="Each switch of a Scout sets one bit; `<bumpers>` in the robot definition defines "
        "the layout. A switch is pressed from the timestep after a contact begins, for as long "
        "as the contact lasts.",
    ),
    Function(
        "int get_sg(void)", "reads the laser's segments", refreshes="Laser",
        posts=("GET_SG", "LASER_PAGE"), under_ndirect=_NO_SENSOR, source=_BOTH,
    ),
    Function("int get_state(long state[NUM_STATE])", "copies State", source=(SOURCE,)),
    Function(
        "int get_laser(int laser[2 * NUM_LASER + 1])",
        "copies Laser[0] and as many numbers after it, although a point has two",
        source=(SOURCE,),
    ),
    Function(
        "float voltCpuGet(void)",
        "returns the voltage of the computer battery [V] from the last state reply", source=_BOTH,
    ),
    Function(
        "float voltMotorGet(void)",
        "returns the voltage of the motor battery [V] from the last state reply", source=_BOTH,
        chosen="Below the cut-off of the definition, 10.8 V, the motors have no force. The"
               " discharge model is in `crs_cc/sim/devices/battery/__init__.py`.",
    ),
    Function(
        "int tk(char *talk)", "speaks", posts=("TK",), source=(HEADER, OURS),
        under_ndirect="FALSE on a Scout or Nomad 150, whose host has no /dev/dbtk; on a Nomad 200"
                      " the reply is the state",
        chosen="The text is printed to stdout, one line per call.",
    ),
))  # fmt: skip
