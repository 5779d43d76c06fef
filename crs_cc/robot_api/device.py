"""The functions of `crs.h`: devices that the vendor's robots did not have, and messages.

`docs/crs-h.md` is generated from it; a test compares it with the header and the library.

>>> [function.name for group in DEVICE_GROUPS for function in group.functions][0]
'crs_period'
"""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import OURS, Function, Group

SENSORS: Final = Group("Sensors", (
    Function(
        "int crs_period(int sensor, int ms)",
        "sets the period of a sensor (`CRS_SENSOR_GPS`, ...), starting now; 0 means on request. "
        "The shortest period is the one that its rate allows",
        units="ms", posts=("PERIOD",), source=(OURS,),
    ),
    Function(
        "int crs_age(int sensor)",
        "returns the age of a sensor's current measurement, -1 if there is none, or if there is "
        "no such sensor",
        units="ms", posts=("AGE",), source=(OURS,),
    ),
))  # fmt: skip

MESSAGES: Final = Group("Messages", (
    Function(
        "int crs_send(int to, int type, const void *data, int size)",
        "sends a message to the robot with this number; also FALSE for more than 248 bytes, or "
        "if too many messages are waiting; TRUE does not guarantee delivery",
        units="-, -, -, byte", posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_broadcast(int type, const void *data, int size)",
        "sends a message to all robots in range of the channel", units="-, -, byte",
        posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_multicast(int group, int type, const void *data, int size)",
        "sends a message to all robots in range that are in a group", units="-, -, -, byte",
        posts=("SEND",), source=(OURS,),
    ),
    Function(
        "int crs_use_channel(int channel)",
        "selects the channel for subsequent messages, initially CRS_RADIO", posts=("CHANNEL",),
        source=(OURS,),
    ),
    Function(
        "int crs_receive(struct crs_message *message, int milliseconds)",
        "removes the message that arrived first from the inbox; FALSE if there is none",
        units="-, ms", posts=("RECEIVE",),
        waits="for a message for up to this time: 0 for no time, CRS_FOREVER without limit",
        source=(OURS,),
    ),
    Function(
        "int crs_message_count(void)", "returns the number of messages in the inbox",
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
        "returns the number of a channel, -1 if there is none with that name", posts=("CHANNEL",),
        source=(OURS,),
    ),
    Function(
        "int crs_find_field(const char *name)",
        "returns the number of a pheromone field, -1 if there is none with that name",
        posts=("FIELD",), source=(OURS,),
    ),
    Function(
        "int crs_my_number(void)", "returns the robot's own number; robots are numbered from 0",
        posts=("ROBOT",), source=(OURS,),
    ),
    Function(
        "int crs_robot_count(void)", "returns the number of robots in the world", posts=("ROBOT",),
        source=(OURS,),
    ),
    Function(
        "int crs_find_robot(const char *name)",
        "returns the number of a robot, -1 if there is none with that name", posts=("ROBOT",),
        source=(OURS,),
    ),
    Function(
        "int crs_robot_name(int number, char *name, int size)",
        "copies the name of a robot, truncated to `size`", units="-, -, byte",
        posts=("ROBOT",), source=(OURS,),
    ),
))  # fmt: skip

DEVICE_GROUPS: Final = (SENSORS, MESSAGES)
"""All functions, by group."""
