"""The colours of programs' drawings, by the X Window System's table (X11R6 `rgb.txt`)."""

from __future__ import annotations

from typing import Final

HEX: Final = {
    "Black": "#000000",
    "Blue": "#0000ff",
    "NavyBlue": "#000080",
    "RoyalBlue": "#4169e1",
    "SteelBlue": "#4682b4",
    "CadetBlue": "#5f9ea0",
    "Green": "#00ff00",
    "SeaGreen": "#2e8b57",
    "ForestGreen": "#228b22",
    "DarkGreen": "#006400",
    "LimeGreen": "#32cd32",
    "Yellow": "#ffff00",
    "Orange": "#ffa500",
    "LightCoral": "#f08080",
    "DeepPink": "#ff1493",
    "OrangeRed": "#ff4500",
    "Red": "#ff0000",
    "IndianRed": "#cd5c5c",
    "VioletRed": "#d02090",
    "Maroon": "#b03060",
}
