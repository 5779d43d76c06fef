"""The constants, indices into State and Smask, variables and types of the vendor's header."""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import Name

CONSTANTS: Final = (
    Name("FALSE", "0", "returned on failure"),
    Name("TRUE", "1", "returned on success, unless stated otherwise"),
    Name("MAX_VERTICES", "10", "maximum number of vertices of an obstacle"),
    Name("NUM_STATE", "45", "size of State"),
    Name("NUM_MASK", "44", "size of Smask"),
    Name("NUM_LASER", "482", "maximum number of laser points"),
    Name("BUFSIZE", "4096", "unused here"),
    Name("MAX_USER_BUF", "0xFFFF", "maximum length of a user-defined packet"),
    Name("USER_BUFFER_LENGTH", "0xFFFF", "the same"),
    Name("SONARS", "16", "number of sonars"),
    Name("INFRAREDS", "16", "number of infrared sensors"),
    Name("MODEL_N200", "0", "a Nomad 200"),
    Name("MODEL_N150", "1", "a Nomad 150"),
    Name("MODEL_SCOUT", "2", "a Scout"),
    Name("MODEL_SCOUT2", "2", "a Super Scout"),
    Name("MV_IGNORE", "0", "mode of an axis in `mv`: unchanged"),
    Name("MV_VM", "1", "speed"),
    Name("MV_PR", "2", "relative move"),
    Name("MV_LP", "3", "limp"),
    Name("MV_AC", "4", "set the acceleration"),
    Name("MV_SP", "5", "set the speed of moves"),
    Name("MV_PA", "6", "absolute move; not sent"),
    Name("MV_TQ", "7", "torque; not sent"),
    Name("MV_MT", "8", "maximum torque; not sent"),
    Name("ZR_CHECK", "1", "mode of `arm_zr`"),
    Name("ZR_ORIENT", "2", "mode of `arm_zr`"),
    Name("ZR_NO_N_GRIPPER", "4", "mode of `arm_zr`"),
    Name("ARM_ZR", "40", "type of the arm's packet"),
    Name("ARM_WS", "41", "type of the arm's packet"),
    Name("ARM_MV", "42", "type of the arm's packet"),
    Name("POS_NONE", "0", "kinds of sensors, for `posDataRequest`"),
    Name("POS_INFRARED", "1", "the infrared sensors"),
    Name("POS_SONAR", "2", "the sonars"),
    Name("POS_BUMPER", "4", "the bumpers"),
    Name("POS_LASER", "8", "the laser"),
    Name("POS_COMPASS", "16", "the compass"),
    Name("POS_IR_1 .. POS_IR_16", "0", "numbers of infrared sensors in position data"),
    Name("POS_SONAR_1 .. POS_SONAR_16", "0", "numbers of sonars in position data"),
    Name("ROTATION_CONSTANT", "0.118597", "wheel distance of a Scout per degree [in]"),
)

MACROS: Final = (
    Name("RIGHT(trans, steer)", "", "right wheel of a Scout that moves and turns left"),
    Name("LEFT(trans, steer)", "", "left wheel"),
    Name(
        "scout_vm(trans, steer)",
        "",
        "`vm` of a Scout that moves and turns left; arguments are not parenthesised: put"
        " parentheses around `a ? b : c`",
    ),
    Name("POS_INFRARED_P", "", "1 if that data has been requested, else 0"),
    Name("POS_SONAR_P", "", "the same"),
    Name("POS_BUMPER_P", "", "the same"),
    Name("POS_LASER_P", "", "the same"),
    Name("POS_COMPASS_P", "", "the same"),
)

STATE: Final = (
    Name("STATE_SIM_SPEED", "0", "speed of the simulation, 10 is real time"),
    Name("STATE_IR_0 .. STATE_IR_15", "1", "infrared sensors [in], 0 to 15, 15 for nothing near"),
    Name("STATE_SONAR_0 .. STATE_SONAR_15", "17",
         "sonars [in], 0 to 255, 255 for no echo; 0 in front, counter-clockwise"),
    Name("STATE_BUMPER", "33", "bumpers, one bit each"),
    Name("STATE_CONF_X", "34", "odometry: x [0.1 in]"),
    Name("STATE_CONF_Y", "35", "odometry: y [0.1 in]"),
    Name("STATE_CONF_STEER", "36", "odometry: heading [0.1 deg], 0 to 3599, counter-clockwise"),
    Name("STATE_CONF_TURRET", "37", "odometry: turret [0.1 deg]"),
    Name("STATE_VEL_TRANS", "38", "speed [0.1 in/s]"),
    Name("STATE_VEL_RIGHT", "38", "speed of a Scout's right wheel [0.1 in/s]"),
    Name("STATE_VEL_STEER", "39", "speed of the steering [0.1 deg/s]"),
    Name("STATE_VEL_LEFT", "39", "speed of a Scout's left wheel [0.1 in/s]"),
    Name("STATE_VEL_TURRET", "40", "speed of the turret [0.1 deg/s]"),
    Name("STATE_MOTOR_STATUS", "41", "bit 0: the motor of the first axis is working (right"
                                     " wheel), even if blocked, 1: second (left), 2: the turret"),
    Name("STATE_LASER", "42", "mode of the laser"),
    Name("STATE_COMPASS", "43", "compass [0.1 deg]"),
    Name("STATE_ERROR", "44", "0 after a successful reply, 111 without a reply, 1 if the request"
                              " was rejected"),
)  # fmt: skip

SMASK: Final = (
    Name("SMASK_POS_DATA", "0", "kinds of sensors with position data in replies"),
    Name("SMASK_IR_1 .. SMASK_IR_16", "1", "infrared sensors"),
    Name("SMASK_SONAR_1 .. SMASK_SONAR_16", "17", "sonars"),
    Name("SMASK_BUMPER", "33", "bumpers"),
    Name("SMASK_CONF_X", "34", "odometry"),
    Name("SMASK_CONF_Y", "35", "odometry"),
    Name("SMASK_CONF_STEER", "36", "odometry"),
    Name("SMASK_CONF_TURRET", "37", "odometry"),
    Name("SMASK_VEL_TRANS", "38", "speeds"),
    Name("SMASK_VEL_STEER", "39", "speeds"),
    Name("SMASK_VEL_TURRET", "40", "speeds"),
    Name("SMASK_RESERVED", "41", "nothing"),
    Name("SMASK_LASER", "42", "laser"),
    Name("SMASK_COMPASS", "43", "compass"),
)

VARIABLES: Final = (
    Name("State", "long [NUM_STATE]", "contents of the replies"),
    Name("Smask", "int [NUM_MASK]", "entries that replies update, once `ct` has sent it"),
    Name("Laser", "int [2 * NUM_LASER + 1]",
         "Laser[0] points (x, y) or segments (two points) [0.1 in], x ahead, y to the left"),
    Name("SERVER_MACHINE_NAME", "char [80]", "the server's host; informational"),
    Name("SERV_TCP_PORT", "int", "its port, 7019, under Ndirect -1; informational"),
    Name("ROBOT_MACHINE_NAME", "char [80]", "unused here"),
    Name("CONN_TYPE", "int", "unused here"),
    Name("SERIAL_PORT", "char [40]", "unused here"),
    Name("SERIAL_BAUD", "int", "unused here"),
    Name("ROBOT_TCP_PORT", "int", "unused here"),
    Name("LASER_CALIBRATION", "double [8]", "unused here"),
    Name("LASER_OFFSET", "double [2]", "unused here"),
)  # fmt: skip

TYPES: Final = (
    Name("TimeData", "unsigned long", "milliseconds of the sensor board"),
    Name("ConfigData", "struct", "configX, configY, configSteer, configTurret, velTrans, velSteer,"
         " velTurret as in State, and their timeStamp"),
    Name("PosData", "struct", "config, and the timeStamp of the reading"),
    Name("double_union", "union", "a double and its bytes"),
    Name("long_union", "union", "a long, its words and bytes"),
    Name("short_union", "union", "a short and its bytes"),
    Name("ushort_union", "union", "an unsigned short and its bytes"),
    Name("ulong_union", "union", "an unsigned long, its words and bytes"),
    Name("request_struct", "struct", "type, size and 0xFFFF numbers; unused here"),
    Name("reply_struct", "struct", "the same"),
)  # fmt: skip
