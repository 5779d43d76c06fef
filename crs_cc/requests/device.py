"""Requests to devices that the vendor's robots did not have: those of `crs.h`.

They need no connection, and take the time of a short message on a network.
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests.code import Argument, RequestCode, arguments

_LENGTH: Final = "0.1 in"
_WEIGHT: Final = "g"
_ANGLE: Final = "0.1 deg"
_DONE: Final = arguments(("result", "1 when done, else 0", "1"))


def device_request(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Argument, ...] = (),
    *, results: tuple[Argument, ...] = (),
) -> RequestCode:  # fmt: skip
    """Return a device's request, whose reply has a success flag first."""
    results = (*_DONE, *results)
    return RequestCode(name, code, "device", prototype, meaning, arguments, results)


DEVICE_REQUESTS: Final = (
    device_request(
        "CAMERA", 201, "int crs_camera(struct crs_pixel *row, int most)",
        "takes a picture and prepares its readings",
        arguments(("i[0]", "0 for pixels, 1 for blobs", "1")),
        results=arguments(("i[0]", "number of readings prepared for READINGS", "1")),
    ),
    device_request(
        "READINGS", 202, "int crs_camera(struct crs_pixel *row, int most)",
        "returns a page of the readings prepared by the previous reply",
        arguments(("i[0]", "the sensor's number", "1"), ("i[1]", "first reading requested", "1")),
        results=arguments(
            ("result", "number of readings in the page", "1"), ("i[0]", "numbers per reading", "1"),
            ("data", "the numbers as int32", "0.1 in, 0.1 deg, 0xRRGGBB"),
        ),
    ),
    device_request(
        "SENSE_HEAT", 203, "int crs_heat(int *heat)", "measures the heat",
        results=arguments(("i[0]", "the heat", "1")),
    ),
    device_request(
        "LASER", 204, "int crs_laser(int *ranges, int most)",
        "takes a laser scan and prepares its readings",
        results=arguments(("i[0]", "number of ranges prepared for READINGS", "1")),
    ),
    device_request(
        "PERIOD", 205, "int crs_period(int sensor, int ms)",
        "sets the period of a sensor",
        arguments(("i[0]", "the sensor's number", "1"), ("i[1]", "0 to measure on request", "ms")),
    ),
    device_request(
        "AGE", 206, "int crs_age(int sensor)", "returns the age of a sensor's measurement",
        arguments(("i[0]", "the sensor's number", "1")),
        results=arguments(("i[0]", "its age, -1 for none", "ms")),
    ),
    device_request(
        "SONAR_MODE", 207, "int crs_sonar_mode(int mode)", "selects the operating mode of the"
                                                           " sonars",
        arguments(("i[0]", "the mode's number in the definition", "1")),
    ),
    device_request(
        "SONAR_RANGES", 208, "int crs_sonar(int *ranges, int most)",
        "reads the sonars",
        arguments(("i[0]", "0 for the current readings, otherwise all fire now", "1")),
        results=arguments(("data", "range of each sonar as int32, -1 for no echo", _LENGTH)),
    ),
    device_request(
        "GRIPPER", 220, "int crs_gripper(int what)", "opens or closes the gripper",
        arguments(("i[0]", "0 to open, 1 to close", "1")),
    ),
    device_request(
        "GET_GRIPPER", 221, "int crs_get_gripper(int *opening, int *beam, int *weight)",
        "returns the position of the gripper's fingers and what they hold",
        results=arguments(
            ("i[0]", "distance between the fingers", _LENGTH),
            ("i[1]", "whether an object is between them", "1"),
            ("i[2]", "weight of what they hold, 0 for nothing", _WEIGHT),
        ),
    ),
    device_request(
        "ARM", 222, "int crs_arm_move(int shoulder, int elbow)", "turns the joints of the arm",
        arguments(
            ("i[0]", "0 for absolute angles, otherwise relative", "1"),
            ("i[1]", "shoulder", _ANGLE), ("i[2]", "elbow", _ANGLE),
        ),
    ),
    device_request(
        "GET_ARM", 223, "int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)",
        "returns the position of the arm and what its hand holds",
        results=arguments(
            ("i[0]", "shoulder", _ANGLE), ("i[1]", "elbow", _ANGLE),
            ("i[2]", "tip, forward of the robot's centre", _LENGTH),
            ("i[3]", "tip, to the left of the centre", _LENGTH),
            ("i[4]", "weight of what the hand holds, 0 for nothing", _WEIGHT),
        ),
    ),
    device_request(
        "HAND", 224, "int crs_hand(int what)", "opens or closes the hand",
        arguments(("i[0]", "0 to open, 1 to close", "1")),
    ),
    device_request(
        "LIGHT", 225, "int crs_light(int brightness)", "sets the brightness of the lamp",
        arguments(("i[0]", "brightness, as read at 1 m", "1")),
    ),
    device_request(
        "SOUND", 226, "int crs_sound(int level, int tone)", "sets the level and tone of the"
                                                            " speaker",
        arguments(("i[0]", "level, as read at 1 m", "1"), ("i[1]", "tone, 0 to 7", "1")),
    ),
    device_request(
        "GET_LIGHT", 227, "int crs_get_light(int *readings, int most)",
        "reads the light sensors",
        results=arguments(
            ("i[0]", "number of sensors", "1"), ("data", "readings as int32", "1"),
        ),
    ),
    device_request(
        "GET_SOUND", 228, "int crs_get_sound(int *levels, int most, int *direction)",
        "reads the levels of all tones and the direction of the loudest",
        results=arguments(
            ("i[0]", "direction of the loudest, relative to the front", _ANGLE),
            ("data", "levels of the eight tones as int32", "1"),
        ),
    ),
    device_request(
        "TAKE_HEAT", 229, "int crs_tag(void)", "removes the heat of all objects in range",
        results=arguments(("i[0]", "number of objects that lost heat", "1")),
    ),
    device_request(
        "SEND", 240, "int crs_send(int to, int type, const void *data, int size)",
        "sends a message",
        arguments(
            ("i[0]", "the receiver's number, -1 for all, or all in a group", "1"),
            ("i[1]", "the group, -1 for none", "1"), ("i[2]", "the type", "1"),
            ("i[3]", "the channel", "1"), ("size", "bytes", "byte"), ("data", "the content", "1"),
        ),
    ),
    device_request(
        "RECEIVE", 241, "int crs_receive(struct crs_message *message, int milliseconds)",
        "removes the first message from the inbox, waiting for one if necessary",
        arguments(("i[0]", "maximum time to wait, negative for no limit", "ms")),
        results=arguments(
            ("i[0]", "the sender's number", "1"), ("i[1]", "the receiver, -1 for all", "1"),
            ("i[2]", "the group, -1 for none", "1"), ("i[3]", "the type", "1"),
            ("i[4]", "the channel", "1"), ("f[0]", "time at which it was posted", "s"),
            ("f[1]", "time at which it arrived", "s"), ("size", "bytes", "byte"),
            ("data", "the content", "1"),
        ),
    ),
    device_request(
        "MESSAGE_COUNT", 242, "int crs_message_count(void)",
        "returns the number of messages in the inbox",
        results=arguments(("i[0]", "number of messages", "1")),
    ),
    device_request(
        "GROUP", 243, "int crs_join_group(int group)", "joins or leaves a group",
        arguments(("i[0]", "the group, 0 to 31", "1"), ("i[1]", "1 to join, 0 to leave", "1")),
    ),
    device_request(
        "CHANNEL", 244, "int crs_find_channel(const char *name)", "looks up a channel",
        arguments(
            ("size", "length of its name, 0 for by number", "byte"), ("data", "the name", "1"),
            ("i[0]", "its number", "1"),
        ),
        results=arguments(
            ("i[0]", "its number", "1"), ("i[1]", "total number", "1"),
            ("size", "length of its name", "byte"), ("data", "its name", "1"),
        ),
    ),
    device_request(
        "ROBOT", 245, "int crs_my_number(void)", "looks up a robot",
        arguments(
            ("size", "length of its name, 0 for by number", "byte"), ("data", "the name", "1"),
            ("i[0]", "its number, -1 for the calling robot", "1"),
        ),
        results=arguments(
            ("i[0]", "its number", "1"), ("i[1]", "total number", "1"),
            ("size", "length of its name", "byte"), ("data", "its name", "1"),
        ),
    ),
)  # fmt: skip
"""The requests to devices of `crs.h`, except those of the device registry."""
