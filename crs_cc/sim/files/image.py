"""Images in world files: PNG files as arrays of grey levels.

They are untrusted input. Only PNG is decoded, and only if the size in its header is allowed. Only
this file uses Pillow, and imports it late: worlds without images do not need it.
"""

from __future__ import annotations

import io
import struct
from pathlib import Path
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.files.nearby import read_below

MAX_BYTES: Final = 16 * 1024 * 1024
"""Maximum size of a file."""

MAX_PIXELS: Final = 4_000_000
"""Maximum number of pixels of an image."""

_SIGNATURE: Final = b"\x89PNG\r\n\x1a\n"
_HEAD: Final = struct.Struct(">I4sII")  # length and type of the first chunk, width, height


def picture(folder: Path | None, name: str) -> FloatArray:
    """Return the grey levels of an image that a world file names, see `grey_values`.

    Args:
        folder: the folder of the world file; None if the world was not read from a file.
        name: the image's path, relative to it.

    Raises:
        ValueError: the image cannot be read; the message is the reason.
    """
    if folder is None:
        raise ValueError("images require a world that is read from a file")
    return grey_values(read_below(folder, name, ".png", MAX_BYTES))


def grey_values(data: bytes) -> FloatArray:
    """Return the grey levels of a PNG file.

    Colours are converted to luma (ITU-R BT.601); transparent pixels are blended with white. Images
    with one channel of 16 bits keep their full depth.

    Returns:
        0 (black) to 1 (white), shape (rows, columns), from the top row.

    Raises:
        ValueError: the file is not a PNG file, is invalid, or is too large; the message says which.
    """
    if data[:8] != _SIGNATURE or len(data) < len(_SIGNATURE) + _HEAD.size:
        raise ValueError("not a PNG file")
    _, kind, width, height = _HEAD.unpack_from(data, len(_SIGNATURE))
    if kind != b"IHDR" or width * height == 0:
        raise ValueError("not a PNG file")
    if width * height > MAX_PIXELS:
        raise ValueError(f"{width} x {height} pixels are too many (maximum: {MAX_PIXELS})")
    try:
        values = _decoded(data)
    except Exception as error:  # decoders raise many kinds of errors on malformed input
        raise ValueError(f"invalid PNG file: {_one_line(error)}") from None
    if values.shape != (height, width):
        raise ValueError("invalid PNG file: its size differs from that in its header")
    return values


def _decoded(data: bytes) -> FloatArray:
    from PIL import Image

    with Image.open(io.BytesIO(data), formats=["PNG"]) as picture:
        picture.load()
        if picture.mode.startswith("I"):  # one channel of 16 bits
            return np.asarray(picture, dtype=np.float64) / 0xFFFF
        if picture.has_transparency_data:
            seen = picture.convert("RGBA")
            white = Image.new("RGBA", seen.size, "white")
            return _levels(Image.alpha_composite(white, seen).convert("L"))
        return _levels(picture.convert("L"))


def _levels(picture: object) -> FloatArray:
    return np.asarray(picture, dtype=np.float64) / 0xFF


def _one_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0][:200]
