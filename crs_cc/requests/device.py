"""Requests to devices that the vendor's robots did not have: those of `crs.h`.

They need no connection, and take the time of a short message on a network.
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests.request import Field, Link, Request, fields

_LENGTH: Final = "0.1 in"
_DONE: Final = fields(("done", "result", "1", "1 if done, else 0"))
_NAMED: Final = fields(
    ("size", "size", "byte", "length of the name, 0 to look up by number"),
    ("name", "data", "1", "the name"),
)
_FOUND: Final = fields(
    ("number", "i[0]", "1", "the number"), ("count", "i[1]", "1", "their number"),
    ("size", "size", "byte", "length of the name"), ("name", "data", "1", "the name"),
)  # fmt: skip


def device_request(
    name: str, code: int, prototype: str, meaning: str, arguments: tuple[Field, ...] = (),
    *, results: tuple[Field, ...] = (), link: Link = "network", waits: bool = False,
) -> Request:  # fmt: skip
    """Return the request of a device; by default the result of its reply is whether it was done."""
    if not any(result.place == "result" for result in results):
        results = (*_DONE, *results)
    return Request(
        name, code, "device", prototype, meaning, arguments, results, link=link, waits=waits
    )


DEVICE_REQUESTS: Final = (
    device_request(
        "READINGS", 202, "int crs_camera(struct crs_pixel *row, int most)",
        "returns a page of the readings that an earlier reply announced",
        fields(
            ("sensor", "i[0]", "1", "the sensor's number"),
            ("first", "i[1]", "1", "the first reading"),
        ),
        results=fields(
            ("count", "result", "1", "number of readings in the page"),
            ("width", "i[0]", "1", "numbers per reading"),
            ("readings", "data", "0.1 in, 0.1 deg, 0xRRGGBB", "the numbers", "int32"),
        ),
        link="none",  # they came with the reply
    ),
    device_request(
        "PERIOD", 205, "int crs_period(int sensor, int ms)",
        "sets the period of a sensor's timer",
        fields(
            ("sensor", "i[0]", "1", "the sensor's number"),
            ("period_ms", "i[1]", "ms", "the period, 0 for on request"),
        ),
    ),
    device_request(
        "AGE", 206, "int crs_age(int sensor)", "returns the age of a sensor's last measurement",
        fields(("sensor", "i[0]", "1", "the sensor's number")),
        results=fields(("age_ms", "i[0]", "ms", "the age, -1 for none")),
    ),
    device_request(
        "SEND", 240, "int crs_send(int to, int type, const void *data, int size)",
        "sends a message",
        fields(
            ("to", "i[0]", "1", "the receiver's number, -1 for all, or all of a group"),
            ("group", "i[1]", "1", "the group, -1 for none"), ("type", "i[2]", "1", "the type"),
            ("channel", "i[3]", "1", "the channel"), ("size", "size", "byte", "bytes"),
            ("content", "data", "1", "the content"),
        ),
    ),
    device_request(
        "RECEIVE", 241, "int crs_receive(struct crs_message *message, int milliseconds)",
        "removes the first message from the inbox, waiting for one if it is empty",
        fields(("timeout_ms", "i[0]", "ms", "maximum waiting time, below 0 for no limit")),
        results=fields(
            ("sender", "i[0]", "1", "the sender's number"),
            ("to", "i[1]", "1", "the receiver's number, -1 for all"),
            ("group", "i[2]", "1", "the group, -1 for none"), ("type", "i[3]", "1", "the type"),
            ("channel", "i[4]", "1", "the channel"), ("sent_s", "f[0]", "s", "time of sending"),
            ("arrived_s", "f[1]", "s", "time of arrival"), ("size", "size", "byte", "bytes"),
            ("content", "data", "1", "the content"),
        ),
        waits=True,
    ),
    device_request(
        "MESSAGE_COUNT", 242, "int crs_message_count(void)",
        "returns the number of messages in the inbox",
        results=fields(("messages", "i[0]", "1", "their number")),
    ),
    device_request(
        "GROUP", 243, "int crs_join_group(int group)", "joins or leaves a group",
        fields(
            ("group", "i[0]", "1", "the group, 0 to 31"),
            ("joins", "i[1]", "1", "1 to join, 0 to leave"),
        ),
    ),
    device_request(
        "CHANNEL", 244, "int crs_find_channel(const char *name)", "looks up a channel",
        (*_NAMED, *fields(("number", "i[0]", "1", "its number"))), results=_FOUND,
    ),
    device_request(
        "ROBOT", 245, "int crs_my_number(void)", "looks up a robot",
        (*_NAMED, *fields(("number", "i[0]", "1", "its number, -1 for the sender's"))),
        results=_FOUND,
    ),
    device_request(
        "FIELD", 246, "int crs_find_field(const char *name)", "looks up a pheromone field",
        (*_NAMED, *fields(("number", "i[0]", "1", "its number"))), results=_FOUND,
    ),
)  # fmt: skip
"""The requests to devices of `crs.h`, except those of the device registry."""
