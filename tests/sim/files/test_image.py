"""Images as grey levels, and invalid image files."""

from __future__ import annotations

import io
import os
import random
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from crs_cc.sim.files.image import MAX_PIXELS, grey_values
from crs_cc.sim.files.nearby import read_below


def png(picture: Image.Image, **options: object) -> bytes:
    file = io.BytesIO()
    picture.save(file, "PNG", **options)
    return file.getvalue()


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def bomb(width: int, height: int, content: bytes) -> bytes:
    """Return a PNG file with any size in its header."""
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    parts = chunk(b"IHDR", head), chunk(b"IDAT", zlib.compress(content)), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def test_first_row_is_the_top_row() -> None:
    picture = Image.new("L", (3, 2), 255)
    picture.putpixel((2, 0), 0)
    assert grey_values(png(picture)).tolist() == [[1, 1, 0], [1, 1, 1]]


@pytest.mark.parametrize(
    ("mode", "paint", "grey"),
    [
        ("1", 1, 1.0),
        ("L", 51, 0.2),
        ("I;16", 13107, 0.2),
        ("LA", (51, 255), 0.2),
        ("LA", (51, 0), 1.0),
        ("RGB", (51, 51, 51), 0.2),
        ("RGB", (255, 0, 0), 76 / 255),  # 0.299 of white
        ("RGBA", (0, 0, 0, 0), 1.0),
        ("RGBA", (51, 51, 51, 255), 0.2),
    ],
)
def test_pixel_formats_convert_to_grey(mode: str, paint: object, grey: float) -> None:
    values = grey_values(png(Image.new(mode, (2, 1), paint)))
    assert values == pytest.approx(np.full((1, 2), grey))


def test_palette_image_uses_its_colours() -> None:
    picture = Image.new("P", (1, 1), 1)
    picture.putpalette([0, 0, 0, 51, 51, 51])
    assert grey_values(png(picture)) == pytest.approx(0.2)
    assert grey_values(png(picture, transparency=1)) == pytest.approx(1.0)


def test_sixteen_bit_image_keeps_its_depth() -> None:
    values = grey_values(png(Image.new("I;16", (1, 1), 1)))
    assert values == pytest.approx(1 / 65535)


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (b"", "not a PNG file"),
        (b"GIF89a" + bytes(50), "not a PNG file"),
        (b"\x89PNG\r\n\x1a\n", "not a PNG file"),
        (bomb(0, 4, b""), "not a PNG file"),
        (bomb(60_000, 60_000, b"0"), f"60000 x 60000 pixels are too many .maximum: {MAX_PIXELS}"),
        (bomb(2**31 - 1, 2**31 - 1, b"0"), "pixels are too many"),
        (bomb(100, 100, b"0"), "invalid PNG file: "),
    ],
)
def test_invalid_image_is_rejected(data: bytes, expected: str) -> None:
    with pytest.raises(ValueError, match=expected):
        grey_values(data)


def test_damaged_image_never_crashes_the_decoder() -> None:
    dice = random.Random(5)
    whole = png(Image.radial_gradient("L").resize((40, 30)))
    for _ in range(300):
        data = bytearray(whole)
        for _ in range(dice.randint(1, 6)):
            data[dice.randrange(8, len(data))] = dice.randrange(256)
        try:
            values = grey_values(bytes(data[: dice.randint(20, len(data))]))
        except ValueError:
            continue
        assert ((values >= 0.0) & (values <= 1.0)).all()


# -- where files may come from ---------------------------------------------------------------------


def test_files_in_the_folder_and_below_are_read(tmp_path: Path) -> None:
    (tmp_path / "maps").mkdir()
    (tmp_path / "maps" / "a.PNG").write_bytes(b"abc")
    assert read_below(tmp_path, "maps/a.PNG", ".png", 3) == b"abc"
    with pytest.raises(ValueError, match="larger than 2 bytes"):
        read_below(tmp_path, "maps/a.PNG", ".png", 2)


@pytest.mark.parametrize(
    "name", ["/etc/a.png", "../a.png", "maps/../../a.png", "a.txt", "", "a\0.png", "a/" * 9999]
)
def test_path_outside_of_the_folder_is_rejected(tmp_path: Path, name: str) -> None:
    with pytest.raises(ValueError, match="must be a relative path to a file"):
        read_below(tmp_path, name, ".png", 9)


def test_links_and_devices_are_rejected(tmp_path: Path) -> None:
    world, secret = tmp_path / "world", tmp_path / "secret"
    world.mkdir()
    secret.mkdir()
    (secret / "a.png").write_bytes(b"abc")
    (world / "a.png").symlink_to(secret / "a.png")
    (world / "maps").symlink_to(secret)
    os.mkfifo(world / "pipe.png")
    (world / "folder.png").mkdir()
    for name in ("a.png", "maps/a.png"):
        with pytest.raises(ValueError, match="symbolic links"):
            read_below(world, name, ".png", 9)
    for name in ("pipe.png", "folder.png"):
        with pytest.raises(ValueError, match=r"regular file|directory"):
            read_below(world, name, ".png", 9)
    with pytest.raises(ValueError, match="no such file"):
        read_below(world, "b.png", ".png", 9)
