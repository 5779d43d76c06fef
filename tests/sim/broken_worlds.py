"""Worlds with one random error each, made from good ones.

A `Breakage` changes a good world and returns the content of its file. The other files in the folder
are made by `hostile_files`.
"""

from __future__ import annotations

import io
import random
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

from lxml import etree
from PIL import Image

Breakage = Callable[[random.Random, etree._Element], bytes]

NUMBERS = frozenset(
    [
        "x",
        "y",
        "x1",
        "y1",
        "x2",
        "y2",
        "length",
        "width",
        "radius",
        "thickness",
        "heading",
        "mass",
        "heat",
        "resolution",
        "edge",
        "height",
        "sonar",
        "infrared",
        "threshold",
        "timestep",
        "duration",
    ]
)
NO_NUMBERS = (
    "NaN", "nan", "inf", "-inf", "Infinity", "1e999", "-1e999", "9" * 400, "1e99999", "0x10", "1,5",
    "", " ", "-", ".", "+-1", "1e", "1..2", "1m2", "5 parsecs", "\u0661\u0662", "one",
    "1m 2m", "${x}", "%s%n", "1e308m", "99999999m", "<", "\u202e1", "1;2",
)  # fmt: skip
WRONG_UNITS = {"heading": "1kg", "mass": "2m", "timestep": "50cm", "duration": "9deg"}
NOT_NEGATIVE = frozenset(
    ["length", "width", "radius", "thickness", "mass", "heat", "resolution", "height"]
)
NAMES = ("1st", "a b", "a/b", "\u00e4", "a" * 65, "edge-x", "obstacle-1", "", "a\nb", "../a")


def text(root: etree._Element) -> bytes:
    """Return the file of a world."""
    return bytes(etree.tostring(root, xml_declaration=True, encoding="UTF-8"))


def pick(dice: random.Random, root: etree._Element, names: frozenset[str]) -> tuple[object, str]:
    """Return a random element, and which of its attributes is one of these."""
    found = [
        (node, name)
        for node in root.iter(etree.Element)
        for name in sorted(node.attrib)
        if name in names and node.tag != "map"
    ]
    return dice.choice(found)


def no_number(dice: random.Random, root: etree._Element) -> bytes:
    node, name = pick(dice, root, NUMBERS)
    value = dice.choice(NO_NUMBERS)
    node.set(name, value)
    return text(root)


def wrong_unit(dice: random.Random, root: etree._Element) -> bytes:
    node, name = pick(dice, root, NUMBERS)
    node.set(name, WRONG_UNITS.get(name, "3s"))
    return text(root)


def negative(dice: random.Random, root: etree._Element) -> bytes:
    node, name = pick(dice, root, NOT_NEGATIVE)
    node.set(name, "-1" + ("kg" if name == "mass" else ""))
    return text(root)


def lacks_attribute(dice: random.Random, root: etree._Element) -> bytes:
    node, name = pick(
        dice, root, frozenset(["x", "y", "x1", "y1", "x2", "y2", "length", "radius", "version"])
    )
    del node.attrib[name]
    return text(root)


def unknown_attribute(dice: random.Random, root: etree._Element) -> bytes:
    node = dice.choice(list(root.iter(etree.Element)))
    node.set(dice.choice(["colur", "onload", "z", "X", "xmlns-x", "a" * 300]), "1")
    return text(root)


def unknown_element(dice: random.Random, root: etree._Element) -> bytes:
    place = dice.choice(list(root.iter(etree.Element)))
    name = dice.choice(["wal", "script", "World", "robot-definition", "a" * 300])
    place.insert(0, etree.Element(name))
    return text(root)


def foreign_namespace(dice: random.Random, root: etree._Element) -> bytes:
    uri = dice.choice(["http://www.w3.org/2001/XInclude", "urn:x"])
    root.append(etree.Element(f"{{{uri}}}include", {"href": "/etc/passwd", "parse": "text"}))
    return text(root)


def stray_text(dice: random.Random, root: etree._Element) -> bytes:
    dice.choice(list(root.iter("area", "robot", "wall", "box"))).text = "x" * dice.randint(1, 5000)
    return text(root)


def second_area(dice: random.Random, root: etree._Element) -> bytes:
    root.insert(dice.randint(1, len(root)), etree.Element("area", length="1m", width="1m"))
    return text(root)


def nothing_left(dice: random.Random, root: etree._Element) -> bytes:
    tag = dice.choice(["area", "robot"])
    for node in root.findall(tag):
        root.remove(node)
    return text(root)


def wrong_version(dice: random.Random, root: etree._Element) -> bytes:
    root.set("version", dice.choice(["2", "", "1.0", "one", "-1", "1" * 500]))
    return text(root)


def wrong_time(dice: random.Random, root: etree._Element) -> bytes:
    name, value = dice.choice(
        [("timestep", "0"), ("timestep", "1us"), ("timestep", "2s"), ("duration", "0"),
         ("duration", "-1s"), ("seed", "-1"), ("seed", "1.5"), ("seed", "9" * 30),
         ("seed", "\u0661")]
    )  # fmt: skip
    root.set(name, value)
    return text(root)


def bad_name(dice: random.Random, root: etree._Element) -> bytes:
    dice.choice(list(root.iter("robot", "wall", "box", "cylinder"))).set("id", dice.choice(NAMES))
    return text(root)


def same_name(dice: random.Random, root: etree._Element) -> bytes:
    attributes = {"id": "twin", "x1": "1m", "y1": "1m", "x2": "2m", "y2": "1m"}
    for _ in range(2):
        root.append(etree.Element("wall", attributes))
    return text(root)


def robots_on_each_other(dice: random.Random, root: etree._Element) -> bytes:
    robot = dice.choice(root.findall("robot"))
    for _ in range(dice.choice([1, 300])):
        root.append(etree.Element("robot", x=robot.get("x"), y=robot.get("y")))
    return text(root)


def robot_outside(dice: random.Random, root: etree._Element) -> bytes:
    dice.choice(root.findall("robot")).set(dice.choice("xy"), dice.choice(["9000m", "-9000m"]))
    return text(root)


def things_on_each_other(dice: random.Random, root: etree._Element) -> bytes:
    for name in ("a1", "a2"):
        place = {"x": "500m", "y": "500m", "radius": "1m", "mass": "1kg"}
        root.append(etree.Element("cylinder", place, id=name))
    return text(root)


def bad_polygon(dice: random.Random, root: etree._Element) -> bytes:
    points = ["", "1,1", "0,0 1,1 2,2", "0,0 2,2 2,0 0,2", "0,0,0 1,1,1 2,0,0", "1,1 1,1 1,1"]
    points += ["0,0 nan,1 1,0", "1 " * 9999, "0,0 1,0 " * 200, "0,0 1e-9,0 0,1", ",,, ,,, ,,,"]
    root.append(etree.Element("polygon", points=dice.choice(points)))
    return text(root)


def bad_surface(dice: random.Random, root: etree._Element) -> bytes:
    name, value = dice.choice(
        [("colour", "reddish"), ("colour", "#12345"), ("colour", ""), ("sonar", "1.5"),
         ("sonar", "-0.1"), ("infrared", "NaN"), ("material", "unobtainium"), ("heat", "-5"),
         ("heat", "1e9"), ("height", "0")]
    )  # fmt: skip
    root.append(
        etree.Element("wall", {"x1": "1m", "y1": "1m", "x2": "2m", "y2": "2m", name: value})
    )
    return text(root)


def bad_robot(dice: random.Random, root: etree._Element) -> bytes:
    name, value = dice.choice(
        [("definition", "tank"), ("definition", "../../etc/passwd"), ("definition", "world.xml"),
         ("definition", "bare.xml"), ("definition", "bomb.xml"), ("definition", "missing.xml"),
         ("program", "missing.c"), ("program", "/etc/passwd"), ("program", "../../x.c"),
         ("program", "link.c"), ("program", "folder.c"), ("program", "a" * 5000 + ".c"),
         ("setup", "wild"), ("dialect", "klingon"), ("heat", "hot")]
    )  # fmt: skip
    dice.choice(root.findall("robot")).set(name, value)
    return text(root)


def bad_map(dice: random.Random, root: etree._Element) -> bytes:
    image = dice.choice(
        ["missing.png", "bomb.png", "cut.png", "text.png", "link.png", "/etc/passwd", "../a.png",
         "folder.png", "pipe.png", "noise.png", "", "a" * 5000 + ".png", "gif.png"]
    )  # fmt: skip
    root.append(etree.Element("map", image=image, resolution="1cm"))
    return text(root)


def bad_include(dice: random.Random, root: etree._Element) -> bytes:
    file = dice.choice(
        ["missing.xml", "broken.xml", "cycle-a.xml", "/etc/passwd", "../a.xml", "link.xml", "",
         "bomb.xml", "cut.xml", "folder.xml", "pipe.xml", "bad-material.xml", "a" * 5000 + ".xml"]
    )  # fmt: skip
    root.append(etree.Element("include", file=file))
    return text(root)


def bad_object(dice: random.Random, root: etree._Element) -> bytes:
    kind = dice.randrange(4)
    if kind == 0:
        root.append(etree.Element("object", ref="nothing", x="1m", y="1m"))
    elif kind == 1:
        define = etree.SubElement(root, "define", name="self")
        etree.SubElement(define, "object", ref="self", x="0", y="0")
    elif kind == 2:
        etree.SubElement(root, "define", name="empty")
    else:  # each of ten of the one before
        for level in range(9):
            define = etree.SubElement(root, "define", name=f"level{level}")
            for number in range(10):
                if level:
                    ref = f"level{level - 1}"
                    etree.SubElement(define, "object", ref=ref, x=str(number), y="0")
                else:
                    etree.SubElement(define, "cylinder", x=str(number), y="0", radius="1")
    return text(root)


def too_many(dice: random.Random, root: etree._Element) -> bytes:
    return text(root).replace(b"</world>", b"<robot x='far' y='1'/>" * 2000 + b"</world>")


# -- not well-formed -------------------------------------------------------------------------------


def cut(dice: random.Random, root: etree._Element) -> bytes:
    whole = text(root)
    return whole[: dice.randint(0, len(whole) - 9)]


def null_byte(dice: random.Random, root: etree._Element) -> bytes:
    whole = text(root)
    place = dice.randint(1, len(whole) - 9)
    return whole[:place] + dice.choice([b"\0", b"\x01", b"\xff\xfe", b"\x80"]) + whole[place:]


def junk(dice: random.Random, root: etree._Element) -> bytes:
    return dice.choice(
        [b"", b" \n", b"\xef\xbb\xbf", b"<", b"<>", b"<?xml?>", b"<!--", b"PK\3\4" * 99,
         dice.randbytes(3000), b"<world>" * 20_000, b"<world" + b" a='1'" * 20_000 + b"/>",
         b"<?xml version='1.0' encoding='klingon'?><world/>", b"\xfe\xff\0<", b"{\"world\": 1}"]
    )  # fmt: skip


def deep(dice: random.Random, root: etree._Element) -> bytes:
    depth = dice.choice([100, 300, 100_000])
    inner = b"<define name='d'>" * depth + b"</define>" * depth
    return text(root).replace(b"</world>", inner + b"</world>")


def document_type(dice: random.Random, root: etree._Element) -> bytes:
    laughs = b"".join(
        b'<!ENTITY a%d "%s">' % (n, b"&a%d;" % (n - 1) * 10 if n else b"ha" * 10) for n in range(12)
    )
    kinds = [
        (b"<!DOCTYPE world [" + laughs + b"]>", b"&a11;"),
        (b'<!DOCTYPE world [<!ENTITY x SYSTEM "file:///etc/passwd">]>', b"&x;"),
        (b'<!DOCTYPE world [<!ENTITY % x SYSTEM "http://localhost:1/x">%x;]>', b""),
        (b'<!DOCTYPE world SYSTEM "http://localhost:1/world.dtd">', b""),
        (b'<!DOCTYPE world [<!ATTLIST world name CDATA "x">]>', b""),
    ]
    head, use = dice.choice(kinds)
    whole = text(root).split(b"?>", 1)[1]
    return head + whole.replace(b"</world>", use + b"</world>")


BREAKAGES: tuple[Breakage, ...] = (
    no_number, wrong_unit, negative, lacks_attribute, unknown_attribute, unknown_element,
    foreign_namespace, stray_text, second_area, nothing_left, wrong_version, wrong_time, bad_name,
    same_name, robots_on_each_other, robot_outside, things_on_each_other, bad_polygon, bad_surface,
    bad_robot, bad_map, bad_include, bad_object, too_many, cut, null_byte, junk, deep,
    document_type, no_number, bad_robot, bad_map, bad_include,
)  # fmt: skip


# -- other files in the folder ---------------------------------------------------------------------


def hostile_files(folder: Path) -> None:
    """Put files that worlds refer to into a folder: truncated, endless, foreign, or elsewhere."""
    bomb = b'<!DOCTYPE x [<!ENTITY a "aaaa">]><definitions version="1">&a;</definitions>'
    (folder / "bomb.xml").write_bytes(bomb)
    (folder / "cut.xml").write_bytes(b'<definitions version="1"><material')
    (folder / "bare.xml").write_bytes(b'<robot-definition version="1" name="b"/>')
    for one, other in ("ab", "ba"):
        cycle = f'<definitions version="1"><include file="cycle-{other}.xml"/></definitions>'
        (folder / f"cycle-{one}.xml").write_text(cycle)
    material = '<definitions version="1"><material name="m" sonar="7"/></definitions>'
    (folder / "bad-material.xml").write_text(material)
    for ending in ("c", "png", "xml"):
        (folder / f"folder.{ending}").mkdir()
        (folder / f"link.{ending}").symlink_to("/etc/hostname")
    for name in ("pipe.png", "pipe.xml"):
        (folder / name).symlink_to("/dev/zero")
    noise = io.BytesIO()
    Image.effect_noise((300, 300), 200.0).save(noise, "PNG")
    (folder / "noise.png").write_bytes(noise.getvalue())
    (folder / "cut.png").write_bytes(noise.getvalue()[:2000])
    (folder / "text.png").write_text("no picture")
    (folder / "gif.png").write_bytes(b"GIF89a" + bytes(100))
    head = struct.pack(">IIBBBBB", 2**31 - 1, 2**31 - 1, 8, 0, 0, 0, 0)
    chunk = b"IHDR" + head
    bomb = (
        b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + chunk + struct.pack(">I", zlib.crc32(chunk))
    )
    (folder / "bomb.png").write_bytes(bomb)
