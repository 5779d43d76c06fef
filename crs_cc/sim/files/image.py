"""Pictures that worlds are made of: PNG files as arrays of grey values.

They may come from anybody. Only PNG is decoded, and only when its head tells of a size that is
allowed. This file alone knows Pillow, and imports it late: worlds without pictures need none.
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
"""How large a file may be."""

MAX_PIXELS: Final = 4_000_000
"""How many pixels a picture may have."""

_SIGNATURE: Final = b"\x89PNG\r\n\x1a\n"
_HEAD: Final = struct.Struct(">I4sII")  # length and kind of the first chunk, width, height


def picture(folder: Path | None, name: str) -> FloatArray:
    """Gives the grey values of a picture that a world file names, see `grey_values`.

    Args:
        folder: the folder of the world file; None when the world came from no file.
        name: the picture, relative to it.

    Raises:
        ValueError: the picture cannot be read; says why.
    """
    if folder is None:
        raise ValueError("a world that is no file has no pictures")
    return grey_values(read_below(folder, name, ".png", MAX_BYTES))


def grey_values(data: bytes) -> FloatArray:
    """Gives the grey values of a PNG file.

    Colours count by their luma (ITU-R BT.601); what is transparent shows white behind it. Pictures
    with one channel of 16 bits keep them all.

    Args:
        data: the file.

    Returns:
        0 (black) to 1 (white), shape (rows, columns), the uppermost row first.

    Raises:
        ValueError: the file is no PNG, is broken, or is too large; says which.
    """
    if data[:8] != _SIGNATURE or len(data) < len(_SIGNATURE) + _HEAD.size:
        raise ValueError("is not a PNG file")
    _, kind, width, height = _HEAD.unpack_from(data, len(_SIGNATURE))
    if kind != b"IHDR" or width * height == 0:
        raise ValueError("is not a PNG file")
    if width * height > MAX_PIXELS:
        raise ValueError(f"has {width} x {height} pixels; {MAX_PIXELS} are allowed")
    try:
        values = _decoded(data)
    except Exception as error:  # a decoder under attack has many ways to complain
        raise ValueError(f"is broken: {_one_line(error)}") from None
    if values.shape != (height, width):
        raise ValueError("is broken: its size is not what its head says")
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
