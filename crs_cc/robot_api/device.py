"""The functions of `crs.h`: what robots have here beyond the vendor's.

Those of the device registry are in `session.device_library`.

`docs/crs-h.md` is made of it, and a test holds it, the header and the library together.

>>> [function.name for group in DEVICE_GROUPS for function in group.functions][0]
'crs_camera'
"""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import OURS, Function, Group

SENSORS: Final = Group("Sensors", (
    Function(
        "int crs_camera(struct crs_pixel *row, int most)",
        "lets the camera look, and tells colour and range of its columns, from the left to the "
        "right; gives how many it told, at most `most`",
        units="0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"), source=(OURS,),
    ),
    Function(
        "int crs_blobs(struct crs_blob *blobs, int most)",
        "lets the camera look, and tells angle, width, colour and range of the spots of one "
        "colour, from the left to the right; gives how many it told, at most `most`",
        units="0.1 deg, 0.1 deg, 0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"), source=(OURS,),
    ),
    Function(
        "int crs_heat(int *heat)", "tells how much heat there is around",
        posts=("SENSE_HEAT",), source=(OURS,),
    ),
    Function(
        "int crs_laser(int *ranges, int most)",
        "lets the laser look, and tells how far away things are in each direction, from the right "
        "to the left, -1 where nothing is in range; gives how many it told, at most `most`, 0 "
        "also while the laser is off",
        units="0.1 in", posts=("LASER", "READINGS"), source=(OURS,),
    ),
    Function(
        "int crs_period(int sensor, int ms)",
        "sets how often a sensor (`CRS_SENSOR_GPS`, ...) measures by itself, the first time now; "
        "0: when it is asked. Its rate is the shortest period there is",
        units="ms", posts=("PERIOD",), source=(OURS,),
    ),
    Function(
        "int crs_age(int sensor)",
        "gives how long ago a sensor measured what it tells, -1 for never, and without such a "
        "sensor",
        units="ms", posts=("AGE",), source=(OURS,),
    ),
    Function(
        "int crs_sonar_mode(int mode)",
        "lets the sonars work in another of the modes of the robot's definition, from each one's "
        "next ping on",
        posts=("SONAR_MODE",), source=(OURS,),
    ),
    Function(
        "int crs_sonar(int *ranges, int most)",
        "tells what the sonars heard last, -1 for no echo; gives how many it told, at most `most`",
        units="0.1 in", posts=("SONAR_RANGES",), source=(OURS,),
    ),
))  # fmt: skip

HANDLING: Final = Group("Taking hold of things", (
    Function(
        "int crs_gripper(int what)",
        "lets the gripper open (CRS_OPEN) or close (CRS_CLOSE), and returns at once",
        posts=("GRIPPER",), source=(OURS,),
    ),
    Function(
        "int crs_get_gripper(int *opening, int *beam, int *weight)",
        "tells how far the fingers are apart, which is the width of what they hold; whether "
        "anything breaks the beam between them; and the weight of what they hold, 0 for nothing. "
        "A pointer may be NULL", units="0.1 in, g",
        posts=("GET_GRIPPER",), source=(OURS,),
    ),
    Function(
        "int crs_arm_move(int shoulder, int elbow)",
        "lets the joints of the arm turn to angles, and returns at once; 0, 0 stretches it out "
        "ahead", units="0.1 deg", posts=("ARM",), source=(OURS,),
    ),
    Function(
        "int crs_arm_turn(int shoulder, int elbow)",
        "lets them turn on by angles from where they are, and returns at once",
        units="0.1 deg", posts=("ARM",), source=(OURS,),
    ),
    Function(
        "int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)",
        "tells where the joints are, and where that puts the tip: ahead of the robot's middle, "
        "and to the left. A pointer may be NULL", units="0.1 deg, 0.1 in",
        posts=("GET_ARM",), source=(OURS,),
    ),
    Function(
        "int crs_hand(int what)",
        "lets the hand close (CRS_CLOSE) on what is at the tip, and open (CRS_OPEN) as soon as "
        "there is room below; returns at once", posts=("HAND",), source=(OURS,),
    ),
    Function(
        "int crs_get_hand(int *weight)", "tells the weight of what is in the hand, 0 for nothing",
        units="g", posts=("GET_ARM",), source=(OURS,),
    ),
    Function(
        "int crs_tag(void)",
        "takes the heat from all things near, as tagTarget() of the CRS report does; gives how "
        "many things lost theirs, -1 for a robot that cannot do it",
        posts=("TAKE_HEAT",), source=(OURS,),
    ),
))  # fmt: skip

BEACONS: Final = Group("Light and sound", (
    Function(
        "int crs_light(int brightness)",
        "lets the robot's lamp shine so that a light sensor reads this at 1 m; 0 for off",
        posts=("LIGHT",), source=(OURS,),
    ),
    Function(
        "int crs_sound(int level, int tone)",
        "lets the robot's speaker sound with a tone, 0 to 7, so that microphones read this at "
        "1 m; 0 for silence", posts=("SOUND",), source=(OURS,),
    ),
    Function(
        "int crs_get_light(int *readings, int most)",
        "tells what the light sensors read, counter-clockwise; gives how many it told, at most "
        "`most`", posts=("GET_LIGHT",), source=(OURS,),
    ),
    Function(
        "int crs_get_sound(int *levels, int most, int *direction)",
        "tells how loud each tone is, and where the loudest comes from, from ahead, which may be "
        "NULL; gives how many tones it told, at most `most`", units="-, -, 0.1 deg",
        posts=("GET_SOUND",), source=(OURS,),
    ),
))  # fmt: skip

MESSAGES: Final = Group("Messages", (
    Function(
        "int crs_send(int to, int type, const void *data, int size)",
        "sends a message to a robot, by its number; FALSE also for more than 248 bytes, or where "
        "too many wait; TRUE does not say that it arrives",
        units="-, -, -, byte", posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_broadcast(int type, const void *data, int size)",
        "sends a message to all in range of the channel", units="-, -, byte",
        posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_multicast(int group, int type, const void *data, int size)",
        "sends a message to all in range that are in a group", units="-, -, -, byte",
        posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_use_channel(int channel)",
        "says where later messages are sent, at first on CRS_RADIO", posts=("CHANNEL",),
        source=(OURS,),
    ),
    Function(
        "int crs_receive(struct crs_message *message, int milliseconds)",
        "takes the oldest message that has arrived; FALSE for none", units="-, ms",
        posts=("RECEIVE",), waits="for a message, 0 not at all, CRS_FOREVER without an end",
        source=(OURS,),
    ),
    Function(
        "int crs_message_count(void)", "gives how many messages have arrived and wait to be taken",
        posts=("MESSAGE_COUNT",), source=(OURS,),
    ),
    Function(
        "int crs_join_group(int group)", "joins a group, 0 to 31", posts=("GROUP",),
        source=(OURS,),
    ),
    Function(
        "int crs_leave_group(int group)", "leaves a group", posts=("GROUP",), source=(OURS,),
    ),
    Function(
        "int crs_find_channel(const char *name)",
        "gives the number of a channel, -1 where there is none", posts=("CHANNEL",),
        source=(OURS,),
    ),
    Function(
        "int crs_my_number(void)", "gives the robot's own number; robots count from 0",
        posts=("ROBOT",), source=(OURS,),
    ),
    Function(
        "int crs_robot_count(void)", "gives how many robots the world has", posts=("ROBOT",),
        source=(OURS,),
    ),
    Function(
        "int crs_find_robot(const char *name)",
        "gives the number of a robot, -1 where there is none", posts=("ROBOT",), source=(OURS,),
    ),
    Function(
        "int crs_robot_name(int number, char *name, int size)",
        "writes the name of a robot, cut off where there is no room", units="-, -, byte",
        posts=("ROBOT",), source=(OURS,),
    ),
))  # fmt: skip

DEVICE_GROUPS: Final = (SENSORS, HANDLING, BEACONS, MESSAGES)
"""All functions, by what they are about."""
