"""The requests that go through the link to the robot, or to the simulator that it lives in.

Most have the reply of the vendor's robot: a packet with all of `State`, the time of the sensor
board, the batteries' voltages, and the number of laser readings that are ready.
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests.code import Argument, RequestCode, arguments

_SPEED, _ACCELERATION, _LENGTH, _ANGLE = "0.1 in/s", "0.1 in/s^2", "0.1 in", "0.1 deg"
_DONE: Final = arguments(("result", "1 when done, else 0", "1"))
_CONNECTED: Final = (
    *_DONE,
    *arguments(("i[0]", "model: MODEL_N200, MODEL_N150 or MODEL_SCOUT", "1")),
)
_STATE: Final = (
    *_DONE,
    *arguments(
        ("data", "State[45] as 45 int32, each in its own unit", "see NUM_STATE"),
        ("i[0]", "laser readings (points or segments) that LASER_PAGE has ready", "1"),
        ("i[1]", "byte n of the computer battery, whose voltage is (2 + n 3/255) 12/5 V", "1"),
        ("i[2]", "byte n of the motor battery, whose voltage is (2 + n 3/255) 12.85/5 V", "1"),
        ("f[0]", "time of the sensor board, 0 to 2^32 - 1", "ms"),
    ),
)
_POSE: Final = arguments(
    ("i[0]", "x", _LENGTH), ("i[1]", "y", _LENGTH), ("i[2]", "heading", _ANGLE),
    ("i[3]", "turret", _ANGLE),
)  # fmt: skip
_VERTICES: Final = arguments(
    ("i[0]", "number of vertices, at most 10", "1"),
    ("data", "x and y of each vertex as int32, counter-clockwise", _LENGTH),
)
_ORDER: Final = arguments(
    ("size", "sensors in the order", "1"), ("data", "the order, one byte each", "sensor number")
)


def _axes(unit: str) -> tuple[Argument, ...]:
    """Return the three axes of a motion command; units are those of a Nomad 200."""
    turning = unit.replace("in", "deg")
    return arguments(
        ("i[0]", "translation; a Scout's right wheel", unit),
        ("i[1]", f"steering; a Scout's left wheel, in {unit}", turning),
        ("i[2]", "turret; a Scout has none", turning),
    )


def _robot(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Argument, ...] = (),
    *, results: tuple[Argument, ...] | None = None,
) -> RequestCode:  # fmt: skip
    """Return a request to the robot; without results of its own its reply is `State`."""
    tells_state = results is None
    return RequestCode(
        name, code, "robot", prototype, meaning, arguments,
        _STATE if results is None else results, tells_state,
    )  # fmt: skip


ROBOT_REQUESTS: Final = (
    _robot("CONNECT", 100, "int connect_robot(long id, ...)", "connects to the robot",
           arguments(("i[0]", "robot number", "1"),
                     ("i[1]", "speed of the serial line, 0 for unchanged", "baud")),
           results=_CONNECTED),
    _robot("DISCONNECT", 101, "int disconnect_robot(long id)", "ends the connection",
           arguments(("i[0]", "robot number", "1")), results=_DONE),
    _robot("AC", 102, "int ac(int trans, int steer, int turret)", "sets accelerations",
           _axes(_ACCELERATION)),
    _robot("SP", 103, "int sp(int trans, int steer, int turret)", "sets the speeds of `pr`",
           _axes(_SPEED)),
    _robot("PR", 104, "int pr(int trans, int steer, int turret)", "starts a relative move",
           _axes(_LENGTH)),
    _robot("VM", 105, "int vm(int trans, int steer, int turret)", "sets wheel speeds",
           _axes(_SPEED)),
    _robot(
        "MV", 106,
        "int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)",
        "commands each axis in its own mode (MV_IGNORE, MV_VM, MV_PR, MV_LP, MV_AC, MV_SP)",
        arguments(
            ("i[0]", "mode of axis 1", "1"), ("i[1]", "its value", "by mode"),
            ("i[2]", "mode of axis 2", "1"), ("i[3]", "its value", "by mode"),
            ("i[4]", "mode of axis 3", "1"), ("i[5]", "its value", "by mode"),
        ),
    ),
    _robot("ST", 107, "int st(void)", "stops the wheels and holds them"),
    _robot("LP", 108, "int lp(void)", "makes the wheels limp"),
    _robot(
        "WS", 109,
        "int ws(unsigned char t, unsigned char s, unsigned char r, unsigned char timeout)",
        "waits until the selected axes have stopped",
        arguments(
            ("i[0]", "1 to wait for axis 1", "1"), ("i[1]", "1 to wait for axis 2", "1"),
            ("i[2]", "1 to wait for axis 3", "1"),
            ("i[3]", "maximum time to wait", "s"),
        ),
    ),
    _robot("DP", 110, "int dp(int x, int y)", "sets the position of the odometry",
           arguments(("i[0]", "x", _LENGTH), ("i[1]", "y", _LENGTH))),
    _robot("DA", 111, "int da(int th, int tu)", "sets the angles of the odometry",
           arguments(("i[0]", "heading", _ANGLE), ("i[1]", "turret", _ANGLE))),
    _robot("ZR", 112, "int zr(void)",
           "sets the odometry to zero, after steering and turret have turned to their zero"
           " positions"),
    _robot(
        "CONF_SN", 113, "int conf_sn(int rate, int order[16])", "sets the firing order of the"
                                                                " sonars",
        (*arguments(("i[0]", "firing interval", "4 ms")), *_ORDER),
    ),
    _robot(
        "CONF_TM", 114, "int conf_tm(unsigned char timeout)",
        "stops the wheels if no command arrives for this time, 0 for never",
        arguments(("i[0]", "timeout", "s")),
    ),
    _robot("GS", 115, "int gs(void)", "reads the whole state"),
    _robot("GET_SN", 116, "int get_sn(void)", "reads the sonars"),
    _robot("GET_BP", 117, "int get_bp(void)", "reads the bumpers"),
    _robot("GET_RC", 118, "int get_rc(void)", "reads the pose of the odometry"),
    _robot("GET_RV", 119, "int get_rv(void)", "reads the wheel speeds"),
    _robot("CT", 121, "int ct(void)", "sets which parts of State replies update",
           arguments(("size", "44", "1"), ("data", "Smask, one byte each", "1"))),
    _robot("GET_IR", 122, "int get_ir(void)", "reads the infrared sensors"),
    _robot("GET_RA", 123, "int get_ra(void)", "requests the accelerations; updates nothing"),
    _robot("GET_CP", 124, "int get_cp(void)", "reads the compass"),
    _robot("GET_LS", 125, "int get_ls(void)", "reads the laser's points"),
    _robot("GET_SG", 126, "int get_sg(void)", "reads the laser's line segments"),
    _robot("CONF_IR", 127, "int conf_ir(int history, int order[16])",
           "sets which infrared sensors measure, and what fraction of a reading carries over to"
           " the next",
           (*arguments(("i[0]", "fraction that carries over, 0 to 10", "0.1")), *_ORDER)),
    _robot("CONF_CP", 128, "int conf_cp(int mode)", "controls the compass",
           arguments(("i[0]", "0 off, 1 on, 2 calibrate", "1"))),
    _robot(
        "CONF_LS", 129,
        "int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width,"
        " unsigned int num_data, unsigned int processing)",
        "configures the laser",
        arguments(
            ("i[0]", "mode: 0 or 50 off; 19, 51 points; 1, 33 segments", "1"),
            ("i[1]", "brightness threshold", "1"), ("i[2]", "width of the line", "pixel"),
            ("i[3]", "number of points, 1 to 482; 0 for all", "1"),
            ("i[4]", "number of neighbouring pixels to average", "1"),
        ),
    ),
    _robot(
        "CONF_SG", 130,
        "int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap)",
        "configures the conversion of laser points to segments",
        arguments(
            ("i[0]", "maximum mean square of the points' distances from a segment", "(0.1 in)^2"),
            ("i[1]", "minimum number of points in a segment", "1"),
            ("i[2]", "maximum gap between two points of a segment", _LENGTH),
        ),
    ),
    _robot(
        "LASER_PAGE", 131, "int get_ls(void)",
        "returns the laser readings announced by the last reply",
        arguments(
            ("i[0]", "first reading requested", "1"), ("i[1]", "1 for those of PREDICT", "1"),
        ),
        results=arguments(
            ("result", "readings in this page: at most 31 points or 15 segments", "1"),
            ("i[0]", "numbers of each: 2 for a point, 4 for a segment's two ends", "1"),
            ("data", "x and y as int32, forward and left of the robot's centre", _LENGTH),
        ),
    ),
    _robot(
        "POS_DATA", 132, "int posSonarRingGet(PosData posData[SONARS])",
        "returns position and time of the sensor readings announced by the last reply",
        arguments(
            ("i[0]", "one of POS_INFRARED, POS_SONAR, POS_BUMPER, POS_LASER, POS_COMPASS", "1"),
            ("i[1]", "number of the first sensor requested", "1"),
        ),
        results=arguments(
            ("result", "PosData in this page, at most 6; 0 after the last sensor", "1"),
            ("data", "9 int32 each: x, y, heading, turret, three speeds, two times",
             "as in State; ms"),
        ),
    ),
    _robot("TK", 133, "int tk(char *talk)", "speaks",
           arguments(("size", "length of the text", "byte"), ("data", "the text", "1"))),
    _robot("CONF_SER", 134, "int conf_ser(unsigned char port, unsigned short baud)",
           "sets the speed of a serial port",
           arguments(("i[0]", "port", "1"), ("i[1]", "speed", "baud"))),
    _robot("PLACE_ROBOT", 140, "int place_robot(int x, int y, int th, int tu)",
           "moves the robot, and the pose of its odometry, to another place", _POSE, results=_DONE),
    _robot("ADD_OBSTACLE", 141, "int add_obstacle(long obs[2 * MAX_VERTICES + 1])",
           "adds a polygon to the world", _VERTICES, results=_DONE),
    _robot("DELETE_OBSTACLE", 142, "int delete_obstacle(long obs[2 * MAX_VERTICES + 1])",
           "removes a polygon that was added", _VERTICES, results=_DONE),
    _robot(
        "MOVE_OBSTACLE", 143,
        "int move_obstacle(long obs[2 * MAX_VERTICES + 1], long dx, long dy)",
        "moves a polygon that was added",
        (*_VERTICES, *arguments(("i[1]", "along x", _LENGTH), ("i[2]", "along y", _LENGTH))),
        results=(*_DONE, *_VERTICES),
    ),
    _robot("NEW_WORLD", 144, "int new_world(void)", "removes all polygons", results=_DONE),
    _robot(
        "GET_RPX", 145, "int get_rpx(long *robot_pos)", "returns the true poses of all robots",
        arguments(("i[0]", "first robot requested", "1")),
        results=arguments(
            ("result", "number of robots", "1"), ("size", "bytes", "byte"),
            ("data", "x, y, heading of each as int32; at most 20", "0.1 in, 0.1 in, 0.1 deg"),
        ),
    ),
    _robot(
        "PREDICT", 146,
        "int predict_sensors(int x, int y, int th, int tu, long *state, int *laser)",
        "predicts the readings of the sensors at another pose", _POSE,
        results=arguments(
            ("result", "1 when done, else 0", "1"),
            ("data", "State[45] as 45 int32, of which only the sensors are used", "see NUM_STATE"),
            ("i[0]", "laser readings that LASER_PAGE has ready", "1"),
        ),
    ),
    _robot(
        "MOTION_CHECK", 147,
        "int motion_check(long type, double a1, double a2, double a3, double a4, double a5,"
        " double a6, double a7, double collide[3])",
        "returns where a motion would end in a collision",
        arguments(
            ("i[0]", "0 along a segment, 1 along an arc", "1"),
            ("data", "a1 to a7 as float64", "see docs/robot-api.md"),
        ),
        results=arguments(
            ("result", "1 if there is a collision", "1"), ("f[0]", "x", _LENGTH),
            ("f[1]", "y", _LENGTH), ("f[2]", "direction of the normal into the obstacle", "rad"),
        ),
    ),
    _robot("GET_CONF", 148, "int get_robot_conf(long *conf)",
           "asks the user to select a position in the simulator's window",
           results=(*_DONE, *_POSE)),
    _robot("REAL_ROBOT", 149, "int real_robot(void)", "requests a real robot", results=_DONE),
    _robot("SIMULATED_ROBOT", 150, "int simulated_robot(void)", "requests a simulated robot",
           results=_DONE),
    _robot(
        "DRAW", 151, "int draw_line(long x_1, long y_1, long x_2, long y_2, int mode)",
        "draws in the simulator's window",
        arguments(
            ("i[0]", "0 a robot, 1 a line, 2 an arc", "1"),
            ("i[1]", "x, or left edge", _LENGTH), ("i[2]", "y, or upper edge", _LENGTH),
            ("i[3]", "heading, x of the end point, or width", "0.1 deg or 0.1 in"),
            ("i[4]", "turret, y of the end point, or height", "0.1 deg or 0.1 in"),
            ("i[5]", "first angle of an arc", _ANGLE), ("i[6]", "second angle of an arc", _ANGLE),
            ("i[7]", "mode", "1"),
        ),
        results=_DONE,
    ),
    _robot("REFRESH", 152, "int refresh_all(void)", "redraws (a part of) the window",
           arguments(("i[0]", "what: 0 refresh_all to 9 refresh_client_graphics", "1")),
           results=_DONE),
    _robot("QUIT_SERVER", 153, "int quit_server(void)", "stops the simulator, for this program",
           results=_DONE),
    _robot("CREATE", 154, "int create_robot(long robot_id)", "creates a robot and connects to it",
           arguments(("i[0]", "robot number", "1")), results=_CONNECTED),
    _robot(
        "SPECIAL", 155,
        "int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer)",
        "sends a user-defined packet",
        arguments(("i[0]", "length of the packet", "byte"), ("size", "bytes, at most 248", "byte"),
                  ("data", "the first of them", "1")),
        results=(*_DONE, *arguments(("size", "bytes", "byte"), ("data", "the answer", "1"))),
    ),
    _robot(
        "SONAR", 160, "int sonarSensorCheck(void)", "reads all sonars by the rules of the CRS"
                                                    " report",
        arguments(("i[0]", "1 to fire all of them now, 0 for their last readings", "1")),
        results=(
            *_DONE,
            *arguments(("size", "64", "byte"), ("data", "16 int32, -1 for no echo", _LENGTH)),
        ),
    ),
    _robot("HEAT", 161, "int heatSensorCheck(void)", "measures the heat of all objects in range",
           results=(*_DONE, *arguments(("i[0]", "the heat", "1")))),
    _robot("TAG", 162, "int tagTarget(void)", "removes the heat of all objects in range",
           results=(*_DONE, *arguments(("i[0]", "number of objects that lost heat", "1")))),
)  # fmt: skip
"""All requests that a robot, or the simulator that it lives in, serves."""

STATE_REPLIES: Final = frozenset(request.code for request in ROBOT_REQUESTS if request.tells_state)
"""Codes of the requests whose reply is all of `State`."""
