"""The requests to devices that the vendor's robots did not have: those of `crs.h`.

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
    """Return the request of a device: its reply begins with whether it was done."""
    results = (*_DONE, *results)
    return RequestCode(name, code, "device", prototype, meaning, arguments, results)


DEVICE_REQUESTS: Final = (
    device_request(
        "CAMERA", 201, "int crs_camera(struct crs_pixel *row, int most)",
        "lets the camera look, and makes ready what it saw",
        arguments(("i[0]", "0 for pixels, 1 for blobs", "1")),
        results=arguments(("i[0]", "how many READINGS has ready", "1")),
    ),
    device_request(
        "READINGS", 202, "int crs_camera(struct crs_pixel *row, int most)",
        "hands over a page of what the reply before told of",
        arguments(("i[0]", "the sensor's number", "1"), ("i[1]", "the first reading", "1")),
        results=arguments(
            ("result", "how many are in the page", "1"), ("i[0]", "numbers of each", "1"),
            ("data", "the numbers as int32", "0.1 in, 0.1 deg, 0xRRGGBB"),
        ),
    ),
    device_request(
        "SENSE_HEAT", 203, "int crs_heat(int *heat)", "tells how much heat there is around",
        results=arguments(("i[0]", "the heat", "1")),
    ),
    device_request(
        "LASER", 204, "int crs_laser(int *ranges, int most)",
        "lets the laser look, and makes ready what it saw",
        results=arguments(("i[0]", "how many ranges READINGS has ready", "1")),
    ),
    device_request(
        "PERIOD", 205, "int crs_period(int sensor, int ms)",
        "sets how often a sensor measures by itself",
        arguments(("i[0]", "the sensor's number", "1"), ("i[1]", "0 for on request", "ms")),
    ),
    device_request(
        "AGE", 206, "int crs_age(int sensor)", "tells how long ago a sensor measured",
        arguments(("i[0]", "the sensor's number", "1")),
        results=arguments(("i[0]", "the time since then, -1 for never", "ms")),
    ),
    device_request(
        "SONAR_MODE", 207, "int crs_sonar_mode(int mode)", "lets the sonars work in another mode",
        arguments(("i[0]", "the mode's number in the definition", "1")),
    ),
    device_request(
        "SONAR_RANGES", 208, "int crs_sonar(int *ranges, int most)",
        "tells what the sonars heard last",
        arguments(("i[0]", "0, or else all fire now", "1")),
        results=arguments(("data", "range of each sonar as int32, -1 for no echo", _LENGTH)),
    ),
    device_request(
        "GRIPPER", 220, "int crs_gripper(int what)", "lets the gripper open or close",
        arguments(("i[0]", "0 to open, 1 to close", "1")),
    ),
    device_request(
        "GET_GRIPPER", 221, "int crs_get_gripper(int *opening, int *beam, int *weight)",
        "tells where the gripper's fingers are and what they hold",
        results=arguments(
            ("i[0]", "distance of the fingers", _LENGTH),
            ("i[1]", "whether anything is between them", "1"),
            ("i[2]", "weight of what they hold, 0 for nothing", _WEIGHT),
        ),
    ),
    device_request(
        "ARM", 222, "int crs_arm_move(int shoulder, int elbow)", "lets the joints of the arm turn",
        arguments(
            ("i[0]", "0 to angles, else on by angles", "1"),
            ("i[1]", "shoulder", _ANGLE), ("i[2]", "elbow", _ANGLE),
        ),
    ),
    device_request(
        "GET_ARM", 223, "int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)",
        "tells where the arm is and what is in its hand",
        results=arguments(
            ("i[0]", "shoulder", _ANGLE), ("i[1]", "elbow", _ANGLE),
            ("i[2]", "tip, ahead of the robot's middle", _LENGTH),
            ("i[3]", "tip, to the left of it", _LENGTH),
            ("i[4]", "weight of what is in the hand, 0 for nothing", _WEIGHT),
        ),
    ),
    device_request(
        "HAND", 224, "int crs_hand(int what)", "lets the hand open or close",
        arguments(("i[0]", "0 to open, 1 to close", "1")),
    ),
    device_request(
        "LIGHT", 225, "int crs_light(int brightness)", "lets the lamp shine",
        arguments(("i[0]", "brightness, as read at 1 m", "1")),
    ),
    device_request(
        "SOUND", 226, "int crs_sound(int level, int tone)", "lets the speaker sound",
        arguments(("i[0]", "level, as read at 1 m", "1"), ("i[1]", "tone, 0 to 7", "1")),
    ),
    device_request(
        "GET_LIGHT", 227, "int crs_get_light(int *readings, int most)",
        "tells what the light sensors read",
        results=arguments(
            ("i[0]", "how many sensors there are", "1"), ("data", "readings as int32", "1"),
        ),
    ),
    device_request(
        "GET_SOUND", 228, "int crs_get_sound(int *levels, int most, int *direction)",
        "tells how loud all tones are, and where the loudest comes from",
        results=arguments(
            ("i[0]", "direction of the loudest, from ahead", _ANGLE),
            ("data", "levels of the eight tones as int32", "1"),
        ),
    ),
    device_request(
        "TAKE_HEAT", 229, "int crs_tag(void)", "takes the heat from all things near",
        results=arguments(("i[0]", "how many things lost heat", "1")),
    ),
    device_request(
        "SEND", 240, "int crs_send(int to, int type, const void *data, int size)",
        "sends a message",
        arguments(
            ("i[0]", "the receiver's number, -1 for all, or all of a group", "1"),
            ("i[1]", "the group, -1 for none", "1"), ("i[2]", "the type", "1"),
            ("i[3]", "the channel", "1"), ("size", "bytes", "byte"), ("data", "the content", "1"),
        ),
    ),
    device_request(
        "RECEIVE", 241, "int crs_receive(struct crs_message *message, int milliseconds)",
        "takes the first message out of the inbox, and waits for it if it must",
        arguments(("i[0]", "how long to wait, below 0 without an end", "ms")),
        results=arguments(
            ("i[0]", "the sender's number", "1"), ("i[1]", "whom it was sent to, -1 for all", "1"),
            ("i[2]", "which group, -1 for none", "1"), ("i[3]", "the type", "1"),
            ("i[4]", "the channel", "1"), ("f[0]", "when it was sent", "s"),
            ("f[1]", "when it arrived", "s"), ("size", "bytes", "byte"),
            ("data", "the content", "1"),
        ),
    ),
    device_request(
        "MESSAGE_COUNT", 242, "int crs_message_count(void)",
        "tells how many messages lie in the inbox",
        results=arguments(("i[0]", "how many", "1")),
    ),
    device_request(
        "GROUP", 243, "int crs_join_group(int group)", "joins a group, or leaves it",
        arguments(("i[0]", "the group, 0 to 31", "1"), ("i[1]", "1 to join, 0 to leave", "1")),
    ),
    device_request(
        "CHANNEL", 244, "int crs_find_channel(const char *name)", "looks up a channel",
        arguments(
            ("size", "length of its name, 0 to ask by number", "byte"), ("data", "the name", "1"),
            ("i[0]", "its number", "1"),
        ),
        results=arguments(
            ("i[0]", "its number", "1"), ("i[1]", "how many there are", "1"),
            ("size", "length of its name", "byte"), ("data", "its name", "1"),
        ),
    ),
    device_request(
        "ROBOT", 245, "int crs_my_number(void)", "looks up a robot",
        arguments(
            ("size", "length of its name, 0 to ask by number", "byte"), ("data", "the name", "1"),
            ("i[0]", "its number, -1 for who asks", "1"),
        ),
        results=arguments(
            ("i[0]", "its number", "1"), ("i[1]", "how many there are", "1"),
            ("size", "length of its name", "byte"), ("data", "its name", "1"),
        ),
    ),
)  # fmt: skip
"""The requests to devices of `crs.h`, those of the device registry apart."""
