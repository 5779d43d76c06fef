"""The functions that reach the robot: connection, motion, configuration, reading."""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import ALL, HEADER, OURS, SOURCE, Function, Group

_BOTH: Final = (HEADER, SOURCE)
_LENGTHS: Final = "0.1 in, 0.1 deg, 0.1 deg; on the Scout 0.1 in of the right and left wheel, 0"
_NO_SENSOR: Final = "FALSE on a Scout or Nomad 150"
_NOTHING: Final = "TRUE, nothing happens"


def _per(time: str) -> str:
    """Gives the units of speeds or accelerations."""
    return _LENGTHS.replace("in", f"in/{time}").replace("deg", f"deg/{time}")


CONNECTION: Final = Group("Connection", (
    Function(
        "int connect_robot(long robot_id, ...)",
        "connects, sends the mask of `init_mask`, and gives the server's port (not 0, not 1);"
        " greets once on stderr. Without a server it says so on stdout, sets State[STATE_ERROR] to"
        " 111 and gives FALSE",
        refreshes=ALL, posts=("CONNECT", "CT"), source=_BOTH,
        under_ndirect="reads the model, the device and its baud rate or port as well, says how it"
        " is connected on stdout, and gives TRUE; a Scout's mask is fixed, without infrared and"
        " laser",
        chosen="Whatever the number, a program's robot is the one that it runs in; every host name"
        " and port is good. Nclient ignores the device and its speed; Ndirect sets the line to the"
        " baud rate, and goes by the robot's model, not by the argument.",
    ),
    Function(
        "int create_robot(long robot_id)", "the same without a greeting and without the mask",
        posts=("CREATE",), source=_BOTH, under_ndirect=_NOTHING,
        chosen="The vendor's server had it switched off; ours connects to the robot.",
    ),
    Function(
        "int disconnect_robot(long robot_id)",
        "ends the connection; the robot goes on as it was told, until the timeout of `conf_tm`",
        posts=("DISCONNECT",), source=_BOTH, under_ndirect="TRUE, the line stays open",
    ),
    Function(
        "int server_is_running(void)", "`connect_robot(1)`",
        refreshes=ALL, posts=("CONNECT", "CT"), source=(SOURCE,),
        under_ndirect="connects over /dev/ttyS0 at 38400 baud",
    ),
    Function(
        "int quit_server(void)",
        "ends the server: from now on nobody answers, all gives FALSE with State[STATE_ERROR] 111",
        posts=("QUIT_SERVER",), source=_BOTH, under_ndirect=_NOTHING,
        chosen="It ends for this program alone; its robot goes on as it was told.",
    ),
    Function(
        "int real_robot(void)", "asks for a real robot", posts=("REAL_ROBOT",), source=_BOTH,
        under_ndirect=_NOTHING, chosen="There is none: FALSE.",
    ),
    Function(
        "int simulated_robot(void)", "asks for a simulated robot", posts=("SIMULATED_ROBOT",),
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
        "sets accelerations; signs do not count", units=_per("s²"),
        refreshes=ALL, posts=("AC",), source=_BOTH,
        chosen="The vendor's simulator took no notice; ours does, as the robot.",
    ),
    Function(
        "int sp(int trans, int steer, int turret)",
        "sets the speeds of `pr`, without moving; signs do not count", units=_per("s"),
        refreshes=ALL, posts=("SP",), source=_BOTH,
    ),
    Function(
        "int pr(int trans, int steer, int turret)",
        "starts a move by so much, and returns", units=_LENGTHS,
        refreshes=ALL, posts=("PR",), source=_BOTH,
        chosen="It starts from the speed reached; where that is too fast to stop in time the axis"
        " comes back. A move that something holds up goes on when the way is free; until then its"
        " motors work, and `ws` waits.",
    ),
    Function(
        "int pa(int trans, int steer, int turret)", "FALSE; nothing is sent",
        source=(SOURCE,), declared=False,
        chosen="Ndirect sends it to a Nomad 200; ours does not.",
    ),
    Function(
        "int vm(int trans, int steer, int turret)",
        "runs at these speeds until the next command, or the timeout of `conf_tm`",
        units=_per("s"), refreshes=ALL, posts=("VM",), source=_BOTH,
        chosen="Held up, motors weaker than the wheels' grip stall, and odometry counts what the"
        " wheels roll; stronger ones let the wheels slip, and it counts as if nothing were there"
        " (`force`, `grip`). Motors give up after the time `give-up`, if there is one. Contacts"
        " never turn a robot.",
    ),
    Function(
        "int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)",
        "commands each axis in a mode of its own; FALSE without sending for a mode that is not one"
        " of MV_IGNORE, MV_VM, MV_PR, MV_LP, MV_AC, MV_SP",
        units="as the mode's command has", refreshes=ALL, posts=("MV",), source=_BOTH,
        under_ndirect="sends every mode",
    ),
    Function(
        "int st(void)", "stops, and holds the axes where they are",
        refreshes=ALL, posts=("ST",),
        chosen="It brakes with the acceleration of `ac`, and then holds with the wheels' grip.",
    ),
    Function(
        "int lp(void)", "lets the motors go limp", refreshes=ALL, posts=("LP",),
        chosen="The wheels roll out (`roll-out`), and roll and count when the robot is pushed along"
        " them; steering and turret stop.",
    ),
    Function(
        "int ws(unsigned char trans, unsigned char steer, unsigned char turret,"
        " unsigned char timeout)",
        "stops nothing",
        units="-, -, -, s",
        refreshes=ALL, posts=("WS",),
        waits="until the axes that are not 0 stand still, `timeout` seconds at most",
        source=_BOTH, chosen="What a timeout of 0 says is a parameter, `ws-timeout-zero`.",
    ),
    Function(
        "int dp(int x, int y)", "sets where the odometry believes to be", units="0.1 in",
        refreshes=ALL, posts=("DP",),
    ),
    Function(
        "int da(int th, int tu)", "sets heading and turret of the odometry", units="0.1 deg",
        refreshes=ALL, posts=("DA",),
    ),
    Function(
        "int zr(void)", "sets the odometry to 0; a Nomad turns steering and turret to their zero",
        refreshes=ALL, posts=("ZR",), source=(HEADER, "RWI", "CARMEN"),
        waits="for what it turns, 120 s at most",
        chosen="A Scout does not move. A Nomad stops, and turns the shorter way, with the speeds of"
        " `sp`, to where wheels and turret point ahead of the base; `conf_tm` is off until then.",
    ),
))  # fmt: skip

CONFIGURATION: Final = Group("Configuration", (
    Function(
        "int conf_sn(int rate, int order[16])",
        "sets which sonars fire in turn, and how often one of them; 255 ends the order, and at its"
        " begin switches the sonars off; NULL does so too", units="4 ms, sonar numbers",
        refreshes=ALL, posts=("CONF_SN",), source=(HEADER, SOURCE, "CARMEN"),
        chosen="NULL is our reading of what CARMEN passes. An order with a sonar that the robot "
        "does not have is refused. Rates below the definition's least"
        " interval (40 ms on a Scout, the time of the longest echo), 0 too, mean that interval. The"
        " first sonar fires at once; what the one before has not heard yet is lost. Sonars that are"
        " not in the order read 255. Until the program calls it, sonars fire in the definition's"
        " order, and a round of it has just ended when the program starts.",
    ),
    Function(
        "int conf_ir(int history, int order[16])",
        "sets which infrared sensors measure, and how much of a reading stays in the next",
        units="0.1, sensor numbers", refreshes=ALL, posts=("CONF_IR",),
        under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="Sensors that are not in the order read 15.",
    ),
    Function(
        "int conf_cp(int mode)", "switches the compass: 0 off, 1 on, 2 calibrates it, while the"
        " turret turns once around in 3 minutes", refreshes=ALL, posts=("CONF_CP",),
        under_ndirect=_NO_SENSOR,
        chosen="It is off at first, and what it read last stays while it is off. The program goes"
        " on during the calibration; `ws` waits for it.",
    ),
    Function(
        "int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width,"
        " unsigned int num_data, unsigned int processing)",
        "configures the laser: 51 gives points, 33 segments, 0 switches it off",
        units="-, -, pixel, readings, pixel", refreshes=ALL, posts=("CONF_LS",),
        under_ndirect=_NO_SENSOR,
        chosen="Modes that tell pixels are refused; threshold and width of the line mean nothing;"
        " points lie at equal angles from the right to the left of the field of view, and 0 asks"
        " for all of them; averaging pixels makes errors smaller.",
    ),
    Function(
        "int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap)",
        "configures how the laser's points become segments", units="(0.1 in)^2, points, 0.1 in",
        refreshes=ALL, posts=("CONF_SG",), under_ndirect=_NO_SENSOR,
        chosen="The threshold is the largest mean square of the distances of points from their"
        " segment; before the first call what the vendor's header advises holds, 50, 4 and 30."
        " `crs_cc/sim/geometry/split_and_merge.py` tells the rest.",
    ),
    Function(
        "int conf_tm(unsigned char timeout)",
        "stops the motion when no command came for so long; 0 for never; what does not fit into a"
        " byte is cut off, 1000 is 232", units="s", refreshes=ALL, posts=("CONF_TM",),
        chosen="What holds before the first call is a parameter, `timeout`.",
    ),
    Function(
        "int conf_ser(unsigned char port, unsigned short baud)",
        "sets the speed of the serial line, 4800, 9600, 19200 or 38400; FALSE on a Nomad 200; "
        "no header declares it",
        units="-, baud", refreshes=ALL, posts=("CONF_SER",), source=(SOURCE,), declared=False,
        chosen="Nclient has no such function, ours does the same; the port does not count.",
    ),
    Function(
        "int ct(void)", "sends Smask, which is in use from now on",
        refreshes=ALL, posts=("CT",), source=_BOTH,
        under_ndirect="FALSE on a Scout or Nomad 150, whose mask is fixed",
    ),
    Function("void init_mask(void)", "sets Smask[0] to 0 and all others to 1", source=_BOTH),
    Function(
        "int init_sensors(void)", "`init_mask` and `ct`", refreshes=ALL, posts=("CT",),
        source=_BOTH, under_ndirect="FALSE on a Scout or Nomad 150, but Smask is set",
    ),
    Function("int get_mask(int mask[NUM_MASK])", "copies the mask in use, not Smask",
             source=(SOURCE,)),
    Function("int set_mask(int mask[NUM_MASK])", "copies a mask to Smask, without sending it",
             source=(SOURCE,)),
))  # fmt: skip

READING: Final = Group("Reading", (
    Function("int gs(void)", "reads the whole state", refreshes=ALL, posts=("GS",)),
    Function(
        "int get_ir(void)", "reads the infrared sensors", refreshes="STATE_IR_*",
        posts=("GET_IR",), under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="A reading is the distance in inches of a white surface, 15 for nothing near; one"
        " that reflects a quarter seems to be twice as far away.",
    ),
    Function(
        "int get_sn(void)", "reads what each sonar heard when it was its turn, in whole inches",
        refreshes="STATE_SONAR_*", posts=("GET_SN",), source=_BOTH,
        chosen="A reading changes when its echo comes, 1.8 ms after the firing for each foot, or"
        " when the sound has been to the end of the range and back. The parameters of <sonars> in a"
        " robot definition say what is heard; the formulas are in `crs_cc/sim/geometry/echoes.py`"
        " and `crs_cc/sim/devices/sonar/errors.py`.",
    ),
    Function(
        "int get_rc(void)", "reads the odometry's pose", refreshes="STATE_CONF_*",
        posts=("GET_RC",), source=_BOTH,
    ),
    Function(
        "int get_rv(void)", "reads the speeds", refreshes="STATE_VEL_*", posts=("GET_RV",),
        source=_BOTH,
    ),
    Function(
        "int get_ra(void)", "asks for the accelerations, which have no place in State",
        posts=("GET_RA",), source=_BOTH,
        chosen="Nclient writes them over the speeds, Ndirect nowhere; ours does as Ndirect.",
    ),
    Function(
        "int get_cp(void)", "reads the compass", refreshes="STATE_COMPASS", posts=("GET_CP",),
        under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="It turns with the turret, and counts counter-clockwise from the world's x axis.",
    ),
    Function(
        "int get_ls(void)", "reads the laser's points", refreshes="Laser",
        posts=("GET_LS", "LASER_PAGE"), under_ndirect=_NO_SENSOR, source=_BOTH,
        chosen="Points are in the frame of the turret, which carries the laser; directions in which"
        " nothing is in range give none. It tells points whatever the mode is, `get_sg` segments.",
    ),
    Function(
        "int get_bp(void)", "reads the bumpers", refreshes="STATE_BUMPER", posts=("GET_BP",),
        source=_BOTH,
        chosen="Which bit each switch of a Scout sets; <bumpers> of the robot definition lays the"
        " switches out. A switch is pressed in the timestep after a contact, while it lasts.",
    ),
    Function(
        "int get_sg(void)", "reads the laser's segments", refreshes="Laser",
        posts=("GET_SG", "LASER_PAGE"), under_ndirect=_NO_SENSOR, source=_BOTH,
    ),
    Function("int get_state(long state[NUM_STATE])", "copies State", source=(SOURCE,)),
    Function(
        "int get_laser(int laser[2 * NUM_LASER + 1])",
        "copies Laser[0] and as many numbers behind it, though a point has two",
        source=(SOURCE,),
    ),
    Function(
        "float voltCpuGet(void)",
        "gives the voltage of the computers' battery [V], as the last state told it", source=_BOTH,
    ),
    Function(
        "float voltMotorGet(void)",
        "gives the voltage of the motors' battery [V], as the last state told it", source=_BOTH,
        chosen="Below the cut-off of the definition, 10.8 V, the motors have no force any more. How"
        " it drains is told in `crs_cc/sim/devices/battery.py`.",
    ),
    Function(
        "int tk(char *talk)", "speaks", posts=("TK",), source=(HEADER, OURS),
        under_ndirect="FALSE on a Scout or Nomad 150, whose host has no /dev/dbtk",
        chosen="What is said stands on stdout, a line for each call.",
    ),
))  # fmt: skip
