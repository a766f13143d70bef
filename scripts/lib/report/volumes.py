"""The volumes of the matrix as files: samples are made, others are looked for."""

from dataclasses import dataclass
from pathlib import Path

from .matrix import Volume
from .process import Programs, output_of


@dataclass(frozen=True)
class Scene:
    """An input of `isolume`, with the options that choose its surface."""

    name: str
    path: Path
    surface: tuple[str, ...]

    def arguments(self) -> list[str]:
        return [str(self.path), *self.surface, "--quiet"]


def sample(programs: Programs, name: str, size: int) -> Scene:
    """A sample scene as VDB."""
    path = programs.work / f"{name}_{size}.vdb"
    if not path.exists():
        output_of([programs.isolume, "sample", name, "--size", str(size), "--quiet", "-o", path])
    return Scene(f"{name} {size}³", path, ("--isovalue", "0", "--inside", "below"))


def shared(programs: Programs, volume: Volume) -> Scene | None:
    """A volume that is not part of the project, or None on a machine that does not have it."""
    path = programs.shared / volume.file
    return Scene(volume.name, path, volume.surface) if path.exists() else None
