"""OpenEXR files of float32 channels, uncompressed: the little that a picture for `isolume compare` needs."""

import struct
from pathlib import Path

import numpy as np

MAGIC, VERSION = 20000630, 2
FLOAT = 2  # pixel type
HEADER_OF_LINE = 8  # bytes before each scan line: its number and its size


def _attribute(name: str, kind: str, value: bytes) -> bytes:
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def write_exr(path: Path, channels: dict[str, np.ndarray]) -> None:
    """Channels: arrays of the same shape (rows from the top, columns)."""
    names = sorted(channels)
    height, width = channels[names[0]].shape
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iBxxxii", FLOAT, 0, 1, 1) for name in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", MAGIC, VERSION) + b"".join([
        _attribute("channels", "chlist", listed),
        _attribute("compression", "compression", b"\0"),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]) + b"\0"
    lines = np.stack([np.asarray(channels[name], dtype="<f4") for name in names], axis=1)  # row, channel, column
    line_bytes = HEADER_OF_LINE + lines[0].nbytes
    start = len(header) + 8 * height  # the table of 64-bit offsets lies between
    offsets = b"".join(struct.pack("<Q", start + row * line_bytes) for row in range(height))
    body = b"".join(struct.pack("<ii", row, lines[row].nbytes) + lines[row].tobytes() for row in range(height))
    path.write_bytes(header + offsets + body)
