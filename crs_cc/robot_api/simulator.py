"""The functions of the simulator, of position data, and of user-defined packets."""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import ALL, HEADER, OURS, SOURCE, Function, Group

_BOTH: Final = (HEADER, SOURCE)
_NOTHING: Final = "TRUE, no effect"
_POLYGON: Final = "long obs[2 * MAX_VERTICES + 1]"


def _polygon(name: str, does: str, request: str, more: str = "", chosen: str = "") -> Function:
    return Function(
        f"int {name}({_POLYGON}{more})", does, units="0.1 in", posts=(request,),
        under_ndirect=_NOTHING, source=_BOTH, chosen=chosen,
    )  # fmt: skip


WORLD: Final = Group("World", (
    _polygon("add_obstacle", "adds a polygon of obs[0] vertices, counter-clockwise, to the world",
             "ADD_OBSTACLE",
             chosen="These are rejected: a polygon whose sides touch, a polygon on a robot, a "
                    "program's 101st polygon, and a world's 501st. All programs change the same "
                    "world; a change takes effect at the next timestep, when the program "
                    "continues."),
    _polygon("add_Obs", "the same", "ADD_OBSTACLE"),
    _polygon("delete_obstacle", "removes a polygon", "DELETE_OBSTACLE",
             chosen="Any corner may come first. Fixed boxes and polygons from the world file "
             "can also be removed."),
    _polygon("delete_Obs", "the same", "DELETE_OBSTACLE"),
    _polygon("move_obstacle", "moves a polygon, and updates obs", "MOVE_OBSTACLE",
             ", long dx, long dy", chosen="Like `delete_obstacle` and `add_obstacle`."),
    _polygon("move_Obs", "the same", "MOVE_OBSTACLE", ", long dx, long dy"),
    Function(
        "int new_world(void)", "removes all obstacles", posts=("NEW_WORLD",),
        under_ndirect=_NOTHING, source=_BOTH,
        chosen="Only the walls around the area and the robots remain; objects from the world "
        "file are also removed.",
    ),
    Function(
        "int place_robot(int x, int y, int th, int tu)",
        "moves the robot, and the pose of its odometry, to another pose",
        units="0.1 in, 0.1 in, 0.1 deg, 0.1 deg", posts=("PLACE_ROBOT",),
        under_ndirect="`dp` and `da`", source=_BOTH,
        chosen="x and y are in the frame of the world file. A pose outside the world, or"
               " occupied, is rejected. A motion continues from there; the base of a Nomad keeps"
               " its direction.",
    ),
    Function(
        "int get_rpx(long *robot_pos)",
        "returns the true poses of all robots: their number, then x, y, heading of each",
        units="0.1 in, 0.1 in, 0.1 deg", posts=("GET_RPX",),
        under_ndirect="FALSE, robot_pos[0] is -1", source=(SOURCE, OURS),
        chosen="The third number is assumed to be the heading; robots are in the order of the world"
               " file.",
    ),
    Function(
        "int predict_sensors(int x, int y, int th, int tu, long *state, int *laser)",
        "predicts the readings of the sensors at another pose: state[1] to state[32], 0 after"
        " that, and the laser", units="as State", posts=("PREDICT", "LASER_PAGE"),
        under_ndirect=_NOTHING, source=_BOTH,
        chosen="The prediction has no errors, and covers all sonars and infrared sensors, "
        "including inactive ones, and the laser as configured; `laser` may be NULL.",
    ),
    Function(
        "int motion_check(long type, double a1, double a2, double a3, double a4, double a5,"
        " double a6, double a7, double collide[3])",
        "TRUE if the robot would collide on a path; returns the position of its centre at that"
        " point, and the direction into the obstacle. Type 0: a segment from (a1, a2) to (a3, a4)."
        " Type 1: an arc that starts at (a1, a2), from angle a3 to a4 around (a6, a7), radius a5",
        units="0.1 in, 0.1 in, rad", posts=("MOTION_CHECK",), under_ndirect="FALSE",
        source=_BOTH,
        chosen="An arc turns left if a4 is greater than a3; if (a1, a2) is nearer to its second"
               " end, it is reversed. A current contact counts only if the path leads into it.",
    ),
    Function(
        "int get_robot_conf(long *conf)", "asks the user to select a position in the window",
        units="0.1 in, 0.1 in, 0.1 deg, 0.1 deg", posts=("GET_CONF",),
        under_ndirect=_NOTHING, source=_BOTH,
        chosen="Programs that crs compiles have no user to ask, so the call returns FALSE. For "
        "linked programs, the page of `crs serve` asks the user.",
    ),
))  # fmt: skip


def _refresh(name: str, what: str) -> Function:
    return Function(
        f"int {name}(void)", f"erases {what}", posts=("REFRESH",), source=_BOTH,
        under_ndirect="not available; ours returns TRUE",
    )  # fmt: skip


_COLOURS: Final = "mode: 1 black, 2 black and erased by drawing again, from 3 the colour with its"
GRAPHICS: Final = Group("Window", (
    Function(
        "int draw_robot(long x, long y, int th, int tu, int mode)",
        "draws a robot; mode: 1 black and erased by drawing again, 2 with an arrow that stays, 3"
        " black, from 4 the colour with its number minus 3", units="0.1 in, 0.1 deg",
        posts=("DRAW",), under_ndirect=_NOTHING, source=_BOTH,
        chosen="`crs run --plot` includes the final drawing. If there are more than 10,000 marks,"
               " the oldest are dropped; other modes are rejected.",
    ),
    Function(
        "int draw_line(long x_1, long y_1, long x_2, long y_2, int mode)",
        f"draws a line; {_COLOURS} number minus 2", units="0.1 in", posts=("DRAW",),
        under_ndirect=_NOTHING, source=_BOTH,
    ),
    Function(
        "int draw_arc(long x_0, long y_0, long w, long h, int th1, int th2, int mode)",
        "draws a part of the ellipse in the rectangle with the upper left corner (x_0, y_0);"
        " modes are those of a line", units="0.1 in, 0.1 deg",
        posts=("DRAW",), under_ndirect=_NOTHING,
        source=_BOTH,
        chosen="The arc is drawn from the first angle to the second, counter-clockwise from x.",
    ),
    _refresh("refresh_all", "everything that the functions below erase"),
    _refresh("refresh_all_traces", "the robot's paths"),
    _refresh("refresh_actual_trace", "its true path"),
    _refresh("refresh_encoder_trace", "its path according to odometry"),
    _refresh("refresh_all_sensors", "the sensors' readings"),
    _refresh("refresh_bumper_sensor", "the readings of the bumpers"),
    _refresh("refresh_infrared_sensor", "the readings of the infrared sensors"),
    _refresh("refresh_sonar_sensor", "the readings of the sonars"),
    _refresh("refresh_laser_sensor", "the readings of the laser"),
    _refresh("refresh_client_graphics", "the drawings by programs"),
))  # fmt: skip


def _position(name: str, parameters: str, what: str) -> Function:
    return Function(
        f"int {name}({parameters})", f"copies {what}; always TRUE", units="as State, ms",
        posts=("POS_DATA",), source=_BOTH,
    )  # fmt: skip


POSDATA: Final = Group("Position and time of sensor readings", (
    Function(
        "int posDataRequest(int posRequest)",
        "requests position data of these kinds of sensors in replies (Smask[0], `ct`);"
        " always TRUE",
        refreshes=ALL, posts=("CT",), source=_BOTH,
        under_ndirect="on a Scout or Nomad 150, sends nothing",
    ),
    Function("int posDataCheck(void)", "returns the kinds that were requested", source=_BOTH),
    _position("posInfraredRingGet", "PosData posData[INFRAREDS]", "the data of the infrared ring"),
    _position("posInfraredGet", "PosData *posData, int infraredNumber", "the data of one sensor"),
    _position("posSonarRingGet", "PosData posData[SONARS]", "the data of all sonars"),
    _position("posSonarGet", "PosData *posData, int sonarNumber", "the data of one sonar"),
    _position("posBumperGet", "PosData *posData", "the data of the last bumper contact"),
    _position("posLaserGet", "PosData *posData", "the data of the laser, 30 times a second"),
    _position("posCompassGet", "PosData *posData", "the data of the compass, 10 times a second"),
    Function(
        "int posTimeGet(void)",
        "returns the time of the sensor board [ms] in the last reply; its resolution is 16.4 ms",
        source=_BOTH,
        chosen="The robot is switched on when the run starts; a definition can set an earlier"
               " time.",
    ),
))  # fmt: skip


def _stuff(name: str, data: str, what: str) -> Function:
    return Function(
        f"int {name}({data} data, unsigned char *buffer, unsigned short *index)",
        f"writes {what} to the buffer; returns the new index", source=_BOTH,
    )  # fmt: skip


def _extract(data: str, name: str, what: str) -> Function:
    return Function(
        f"{data} {name}(unsigned char *buffer, unsigned short *index)",
        f"reads {what} from the buffer", source=_BOTH,
    )  # fmt: skip


_SIGNED: Final = "sign and magnitude"
PACKETS: Final = Group("User-defined packets", (
    Function(
        "int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer)",
        "sends a packet to the robot and waits for its answer", posts=("SPECIAL",),
        source=_BOTH,
        chosen="No simulated robot understands user-defined packets, so the call returns FALSE.",
    ),
    Function(
        "int init_receive_buffer(unsigned short *index)",
        "sets the index to 4, after the header, and returns it", source=_BOTH,
    ),
    Function(
        "int extract_receive_buffer_header(unsigned short *length, unsigned char *serial_number,"
        " unsigned char *packet_type, unsigned char *buffer)",
        "decodes the header: the length in two bytes, a number, a type; returns the length",
        source=_BOTH,
    ),
    Function(
        "int init_send_buffer(unsigned short *index)",
        "sets the index to 4, after the header, and returns it", source=_BOTH,
    ),
    Function(
        "int stuff_send_buffer_header(unsigned short index, unsigned char serial_number,"
        " unsigned char packet_type, unsigned char *buffer)",
        "writes the header; returns the index", source=_BOTH,
    ),
    _stuff("stuffchar", "signed char", f"one byte, {_SIGNED},"),
    _stuff("stuff2byteint", "signed short", f"two bytes, {_SIGNED}, low byte first,"),
    _stuff("stuff4byteint", "signed long", f"four bytes, {_SIGNED}, lowest byte first,"),
    _stuff("stuffuchar", "unsigned char", "one byte"),
    _stuff("stuff2byteuint", "unsigned short", "two bytes, low byte first,"),
    _stuff("stuff4byteuint", "unsigned long", "four bytes, lowest byte first,"),
    _stuff("stuffdouble", "double", "eight bytes, lowest byte first,"),
    _extract("signed char", "extractchar", f"one byte, {_SIGNED},"),
    _extract("signed short", "extract2byteint", f"two bytes, {_SIGNED},"),
    _extract("signed long", "extract4byteint", f"four bytes, {_SIGNED},"),
    _extract("unsigned char", "extractuchar", "one byte"),
    _extract("unsigned short", "extract2byteuint", "two bytes"),
    _extract("unsigned long", "extract4byteuint", "four bytes"),
    _extract("double", "extractdouble", "eight bytes"),
    Function(
        "long arm_mv(long l_mode, long l_v, long g_mode, long g_v)",
        "moves the lift and the gripper of the arm; returns the number in the answer",
        posts=("SPECIAL",), source=_BOTH,
        chosen="No simulated robot has this arm, so the call returns 0.",
    ),
    Function(
        "long arm_ws(short lift, short grip, long timeout, long *time_remain)",
        "waits for the arm", posts=("SPECIAL",), source=_BOTH, chosen="The same.",
    ),
    Function(
        "long arm_zr(short mode)", "zeroes the arm", posts=("SPECIAL",), source=_BOTH,
        chosen="The same.",
    ),
))  # fmt: skip
