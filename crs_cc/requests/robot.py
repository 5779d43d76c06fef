"""The requests that are sent to the robot, or to its simulator.

Most have the reply of the vendor's robot: a packet with all of `State`, the time of the sensor
board, the batteries' voltages, and the number of laser readings that are ready.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from crs_cc.requests.request import (
    ALL_SENSORS,
    BUMPER,
    COMPASS,
    INFRARED,
    LASER,
    SONAR,
    Field,
    Link,
    Request,
    fields,
)

_SPEED, _ACCELERATION, _LENGTH, _ANGLE = "0.1 in/s", "0.1 in/s^2", "0.1 in", "0.1 deg"
_DONE: Final = fields(("done", "result", "1", "1 if done, else 0"))
_ROBOT: Final = fields(("robot", "i[0]", "1", "robot number"))
_CONNECTED: Final = (
    *_DONE,
    *fields(("model", "i[0]", "1", "model: MODEL_N200, MODEL_N150 or MODEL_SCOUT")),
)
_STATE: Final = (
    *_DONE,
    *fields(
        ("state", "data", "see NUM_STATE", "State[45], each element in its own unit", "int32"),
        ("laser_count", "i[0]", "1", "laser points or segments available from LASER_PAGE"),
        ("computer_battery", "i[1]", "1",
         "byte n for the computer battery, (2 + n 3/255) 12/5 V"),
        ("motor_battery", "i[2]", "1",
         "byte n for the motor battery, (2 + n 3/255) 12.85/5 V"),
        ("board_ms", "f[0]", "ms", "time of the sensor board, 0 to 2^32 - 1"),
    ),
)  # fmt: skip
_POSE: Final = fields(
    ("x", "i[0]", _LENGTH, "x"), ("y", "i[1]", _LENGTH, "y"),
    ("heading", "i[2]", _ANGLE, "heading"), ("turret", "i[3]", _ANGLE, "turret"),
)  # fmt: skip
_VERTICES: Final = fields(
    ("count", "i[0]", "1", "number of vertices, at most 10"),
    ("vertices", "data", _LENGTH, "x and y of each vertex, counter-clockwise", "int32"),
)
_ORDER: Final = fields(
    ("count", "size", "1", "sensors in the order"),
    ("order", "data", "sensor number", "the order, one byte each"),
)
_OBJECTS: Final = fields(("objects", "i[0]", "1", "number of objects that lost heat"))


def _axes(unit: str) -> tuple[Field, ...]:
    """Return the three axes of a motion command; units are those of a Nomad 200."""
    turning = unit.replace("in", "deg")
    return fields(
        ("axis1", "i[0]", unit, "translation; a Scout's right wheel"),
        ("axis2", "i[1]", turning, f"steering; a Scout's left wheel, in {unit}"),
        ("axis3", "i[2]", turning, "turret; a Scout has none"),
    )


def _command(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Field, ...] = (),
    *, sensors: int = ALL_SENSORS, link: Link = "serial", sends_data: bool = False,
    moves: bool = False, waits: bool = False,
) -> Request:  # fmt: skip
    """Return a request of the robot whose reply is all of `State`."""
    return Request(
        name, code, "robot", prototype, meaning, arguments, _STATE, link=link,
        sends_data=sends_data, needs_connection=True, moves=moves, waits=waits,
        replies_state=True, sensors=sensors,
    )  # fmt: skip


def _request(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Field, ...] = (),
    *, results: tuple[Field, ...] = _DONE, link: Link, sends_data: bool = False,
    needs_connection: bool = True, changes_world: bool = False,
) -> Request:  # fmt: skip
    """Return a request whose reply has results of its own."""
    return Request(
        name, code, "robot", prototype, meaning, arguments, results, link=link,
        sends_data=sends_data, needs_connection=needs_connection, changes_world=changes_world,
    )  # fmt: skip


ROBOT_REQUESTS: Final = (
    _request("CONNECT", 100, "int connect_robot(long id, ...)", "connects to the robot",
             (*_ROBOT, *fields(("baud", "i[1]", "baud",
                                "speed of the serial line, 0 for no change"))),
             results=_CONNECTED, link="none", needs_connection=False),
    _request("DISCONNECT", 101, "int disconnect_robot(long id)", "ends the connection",
             _ROBOT, link="none"),
    _command("AC", 102, "int ac(int trans, int steer, int turret)", "sets accelerations",
             _axes(_ACCELERATION)),
    _command("SP", 103, "int sp(int trans, int steer, int turret)", "sets the speeds of `pr`",
             _axes(_SPEED)),
    _command("PR", 104, "int pr(int trans, int steer, int turret)", "starts a relative move",
             _axes(_LENGTH), moves=True),
    _command("VM", 105, "int vm(int trans, int steer, int turret)", "sets wheel speeds",
             _axes(_SPEED), moves=True),
    _command(
        "MV", 106,
        "int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)",
        "commands each axis in a mode of its own (MV_IGNORE, MV_VM, MV_PR, MV_LP, MV_AC, MV_SP)",
        fields(
            ("mode1", "i[0]", "1", "mode of axis 1"), ("value1", "i[1]", "by mode", "its value"),
            ("mode2", "i[2]", "1", "mode of axis 2"), ("value2", "i[3]", "by mode", "its value"),
            ("mode3", "i[4]", "1", "mode of axis 3"), ("value3", "i[5]", "by mode", "its value"),
        ),
        moves=True,
    ),
    _command("ST", 107, "int st(void)", "stops the wheels and holds them"),
    _command("LP", 108, "int lp(void)", "makes the wheels limp"),
    _command(
        "WS", 109,
        "int ws(unsigned char t, unsigned char s, unsigned char r, unsigned char timeout)",
        "waits until the selected axes are at rest",
        fields(
            ("axis1", "i[0]", "1", "1 to wait for axis 1"),
            ("axis2", "i[1]", "1", "1 to wait for axis 2"),
            ("axis3", "i[2]", "1", "1 to wait for axis 3"),
            ("timeout_s", "i[3]", "s", "maximum waiting time"),
        ),
        waits=True,
    ),
    _command("DP", 110, "int dp(int x, int y)", "sets the position of the odometry",
             fields(("x", "i[0]", _LENGTH, "x"), ("y", "i[1]", _LENGTH, "y"))),
    _command("DA", 111, "int da(int th, int tu)", "sets the angles of the odometry",
             fields(("heading", "i[0]", _ANGLE, "heading"), ("turret", "i[1]", _ANGLE, "turret"))),
    _command("ZR", 112, "int zr(void)",
             "turns steering and turret to their zero marks, then sets the odometry to zero",
             waits=True),
    _command(
        "CONF_SN", 113, "int conf_sn(int rate, int order[16])", "sets the sonars' firing order",
        (*fields(("rate", "i[0]", "4 ms", "time between two firings")), *_ORDER),
    ),
    _command(
        "CONF_TM", 114, "int conf_tm(unsigned char timeout)",
        "stops the wheels if no command arrives within a timeout, 0 for never",
        fields(("timeout_s", "i[0]", "s", "timeout")),
    ),
    _command("GS", 115, "int gs(void)", "reads the whole state"),
    _command("GET_SN", 116, "int get_sn(void)", "reads the sonars", sensors=SONAR),
    _command("GET_BP", 117, "int get_bp(void)", "reads the bumpers", sensors=BUMPER),
    _command("GET_RC", 118, "int get_rc(void)", "reads the odometry's pose", sensors=0),
    _command("GET_RV", 119, "int get_rv(void)", "reads the wheel speeds", sensors=0),
    _command("CT", 121, "int ct(void)", "sets which elements of State replies update",
             fields(("count", "size", "1", "44"), ("mask", "data", "1", "Smask, one byte each"))),
    _command("GET_IR", 122, "int get_ir(void)", "reads the infrared sensors", sensors=INFRARED),
    replace(
        _command("GET_RA", 123, "int get_ra(void)", "reads the accelerations", sensors=0),
        results=(
            *_STATE,
            *fields(
                ("ramp1", "i[3]", _ACCELERATION, "acceleration of the first axis"),
                ("ramp2", "i[4]", _ACCELERATION, "acceleration of the second axis"),
                ("ramp3", "i[5]", _ACCELERATION, "acceleration of the third axis"),
            ),
        ),
    ),
    _command("GET_CP", 124, "int get_cp(void)", "reads the compass", sensors=COMPASS),
    _command("GET_LS", 125, "int get_ls(void)", "reads the laser's points", sensors=LASER),
    _command("GET_SG", 126, "int get_sg(void)", "reads the laser's line segments", sensors=LASER),
    _command("CONF_IR", 127, "int conf_ir(int history, int order[16])",
             "sets which infrared sensors measure, and the weight of the previous reading",
             (*fields(("share", "i[0]", "0.1", "weight, 0 to 10")), *_ORDER)),
    _command("CONF_CP", 128, "int conf_cp(int mode)", "sets the mode of the compass",
             fields(("mode", "i[0]", "1", "0 off, 1 on, 2 calibrate"))),
    _command(
        "CONF_LS", 129,
        "int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width,"
        " unsigned int num_data, unsigned int processing)",
        "configures the laser",
        fields(
            ("mode", "i[0]", "1", "mode: 0 or 50 off; 19, 51 points; 1, 33 segments"),
            ("threshold", "i[1]", "1", "brightness threshold"),
            ("width", "i[2]", "pixel", "width of the line"),
            ("points", "i[3]", "1", "number of points, 1 to 482; 0 for all"),
            ("averaged", "i[4]", "1", "number of adjacent pixels that are averaged"),
        ),
    ),
    _command(
        "CONF_SG", 130,
        "int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap)",
        "configures the conversion of laser points to segments",
        fields(
            ("threshold", "i[0]", "(0.1 in)^2",
             "largest mean square of the points' distances from a segment"),
            ("min_points", "i[1]", "1", "minimum number of points of a segment"),
            ("gap", "i[2]", _LENGTH, "largest gap between two points of a segment"),
        ),
    ),
    _request(
        "LASER_PAGE", 131, "int get_ls(void)",
        "returns a page of the laser readings that the last reply announced",
        fields(
            ("first", "i[0]", "1", "first requested reading"),
            ("predicted", "i[1]", "1", "1 for those of PREDICT"),
        ),
        results=fields(
            ("count", "result", "1", "readings in this page, at most 31 points or 15 segments"),
            ("width", "i[0]", "1", "numbers per reading: 2 for a point, 4 for a segment"),
            ("readings", "data", _LENGTH,
             "x and y, forward and to the left of the centre of robot and turret", "int32"),
        ),
        link="none",
    ),
    _request(
        "POS_DATA", 132, "int posSonarRingGet(PosData posData[SONARS])",
        "returns the position and time of the sensor readings in the last reply",
        fields(
            ("kind", "i[0]", "1",
             "one of POS_INFRARED, POS_SONAR, POS_BUMPER, POS_LASER, POS_COMPASS"),
            ("first", "i[1]", "1", "number of the first requested sensor"),
        ),
        results=fields(
            ("count", "result", "1", "PosData in this page, at most 6; 0 after the last sensor"),
            ("records", "data", "as in State; ms",
             "9 each: x, y, heading, turret, three speeds, two times", "int32"),
        ),
        link="none",
    ),
    _command("TK", 133, "int tk(char *talk)", "speaks",
             fields(("size", "size", "byte", "length of the text"), ("text", "data", "1", "text")),
             sends_data=True),
    _command("CONF_SER", 134, "int conf_ser(unsigned char port, unsigned short baud)",
             "sets the speed of a serial port",
             fields(("port", "i[0]", "1", "port"), ("baud", "i[1]", "baud", "speed"))),
    _request("PLACE_ROBOT", 140, "int place_robot(int x, int y, int th, int tu)",
             "moves the robot, and its odometry, to a pose", _POSE,
             link="network", changes_world=True),
    _request("ADD_OBSTACLE", 141, "int add_obstacle(long obs[2 * MAX_VERTICES + 1])",
             "adds a polygon to the world", _VERTICES, link="network", changes_world=True),
    _request("DELETE_OBSTACLE", 142, "int delete_obstacle(long obs[2 * MAX_VERTICES + 1])",
             "removes a polygon that was added", _VERTICES, link="network", changes_world=True),
    _request(
        "MOVE_OBSTACLE", 143,
        "int move_obstacle(long obs[2 * MAX_VERTICES + 1], long dx, long dy)",
        "moves a polygon that was added",
        (*_VERTICES,
         *fields(("dx", "i[1]", _LENGTH, "along x"), ("dy", "i[2]", _LENGTH, "along y"))),
        results=(*_DONE, *_VERTICES), link="network", changes_world=True,
    ),
    _request("NEW_WORLD", 144, "int new_world(void)", "removes all polygons",
             link="network", changes_world=True),
    _request(
        "GET_RPX", 145, "int get_rpx(long *robot_pos)", "returns the true poses of all robots",
        fields(("first", "i[0]", "1", "first requested robot")),
        results=fields(
            ("robots", "result", "1", "number of robots"), ("size", "size", "byte", "bytes"),
            ("poses", "data", "0.1 in, 0.1 in, 0.1 deg", "x, y, heading of each; at most 20",
             "int32"),
        ),
        link="network",
    ),
    _request(
        "PREDICT", 146,
        "int predict_sensors(int x, int y, int th, int tu, long *state, int *laser)",
        "predicts the sensor readings at a pose", _POSE,
        results=(
            *_DONE,
            *fields(
                ("state", "data", "see NUM_STATE", "State[45], of which only the sensors are used",
                 "int32"),
                ("laser_count", "i[0]", "1", "laser readings available from LASER_PAGE"),
            ),
        ),
        link="network",
    ),
    _request(
        "MOTION_CHECK", 147,
        "int motion_check(long type, double a1, double a2, double a3, double a4, double a5,"
        " double a6, double a7, double collide[3])",
        "finds the first collision along a path",
        fields(
            ("path", "i[0]", "1", "0 along a segment, 1 along an arc"),
            ("numbers", "data", "see docs/robot-api.md", "a1 to a7", "float64"),
        ),
        results=fields(
            ("collides", "result", "1", "1 if there is a collision"),
            ("x", "f[0]", _LENGTH, "x"), ("y", "f[1]", _LENGTH, "y"),
            ("normal_rad", "f[2]", "rad", "direction of the normal into the obstacle"),
        ),
        link="network",
    ),
    _request("GET_CONF", 148, "int get_robot_conf(long *conf)",
             "asks the user to select a position in the simulator's window",
             results=(*_DONE, *_POSE), link="network"),
    _request("REAL_ROBOT", 149, "int real_robot(void)", "requests a real robot", link="network"),
    _request("SIMULATED_ROBOT", 150, "int simulated_robot(void)", "requests a simulated robot",
             link="network"),
    _request(
        "DRAW", 151, "int draw_line(long x_1, long y_1, long x_2, long y_2, int mode)",
        "draws in the simulator's window",
        fields(
            ("shape", "i[0]", "1", "0 a robot, 1 a line, 2 an arc"),
            ("x1", "i[1]", _LENGTH, "x, or left edge"),
            ("y1", "i[2]", _LENGTH, "y, or upper edge"),
            ("x2", "i[3]", "0.1 deg or 0.1 in", "heading, x of the end, or width"),
            ("y2", "i[4]", "0.1 deg or 0.1 in", "turret, y of the end, or height"),
            ("angle1", "i[5]", _ANGLE, "first angle of an arc"),
            ("angle2", "i[6]", _ANGLE, "its second angle"), ("mode", "i[7]", "1", "mode"),
        ),
        link="network",
    ),
    _request("REFRESH", 152, "int refresh_all(void)", "redraws (a part of) the window",
             fields(("part", "i[0]", "1", "0 refresh_all to 9 refresh_client_graphics")),
             link="network"),
    _request("QUIT_SERVER", 153, "int quit_server(void)", "ends the simulator, for this program",
             link="network"),
    _request("CREATE", 154, "int create_robot(long robot_id)", "creates a robot and connects to it",
             _ROBOT, results=_CONNECTED, link="none", needs_connection=False),
    _request(
        "SPECIAL", 155,
        "int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer)",
        "sends a user-defined packet",
        fields(("length", "i[0]", "byte", "length of the packet"),
               ("size", "size", "byte", "bytes, at most 248"),
               ("packet", "data", "1", "its first bytes")),
        results=(*_DONE, *fields(("size", "size", "byte", "bytes"),
                                 ("answer", "data", "1", "the answer"))),
        link="serial", sends_data=True,
    ),
    _request(
        "SONAR", 160, "int sonarSensorCheck(void)", "reads all sonars as in the CRS report",
        fields(("fire", "i[0]", "1", "0 for the last echoes, 1 to fire all of them now")),
        results=(
            *_DONE,
            *fields(("size", "size", "byte", "64"),
                    ("ranges", "data", _LENGTH, "16 ranges, -1 for no echo", "int32")),
        ),
        link="serial",
    ),
    _request("HEAT", 161, "int heatSensorCheck(void)", "reads the heat sensor",
             results=(*_DONE, *fields(("heat", "i[0]", "1", "the heat"))), link="serial"),
    _request("TAG", 162, "int tagTarget(void)", "removes the heat of all objects in range",
             results=(*_DONE, *_OBJECTS), link="serial"),
)  # fmt: skip
"""Every request that a robot, or its simulator, answers."""
