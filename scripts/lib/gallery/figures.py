"""What the gallery shows: figures of rows, rows of panels."""

from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Panel:
    """One picture: of `isolume render`, or of `isolume reference` if `truth`."""

    caption: str
    options: tuple[str, ...]
    truth: bool = False
    channel: str = "irradiance.G"  # what is judged by the truth of the row
    scale: float = 1.0             # the truth of the row shows that much of what the panel should


@dataclass(frozen=True)
class Row:
    volume: str                   # key of VOLUMES
    panels: tuple[Panel, ...]
    view: tuple[str, ...] = ()


@dataclass(frozen=True)
class Figure:
    name: str
    title: str
    text: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Volume:
    """A sample of that name, or a file among the real volumes."""

    name: str
    surface: tuple[str, ...]
    sample: int = 0  # samples along each axis; 0: a file
    view: tuple[str, ...] = field(default=())


VOLUMES = {
    "corner": Volume("corner", ("--isovalue", "0", "--inside", "below"), 128),
    "capillaries": Volume("capillaries", ("--isovalue", "0", "--inside", "below"), 192),
    "vorticity": Volume("vorticity", ("--isovalue", "0", "--inside", "below"), 160),
    "gyroid": Volume("gyroid", ("--isovalue", "0", "--inside", "below"), 160),
    "cranium": Volume("cranium.nhdr", ("--isovalue", "300"), view=("--azimuth", "150", "--elevation", "8")),
    "betaGal": Volume("betaGal.mrc", ("--isovalue", "0.06")),
    "mni": Volume("mni152_2009.nii.gz", ()),
    "aorta": Volume("aorta_cta.mha", ("--isovalue", "800")),
}

PUBLISHED = ("--occlusion", "singh10", "--gamma", "2")
AMBIENT = Panel("reference", ("--integrand", "ambient"), truth=True, channel="ambient.Y")


def geometry_term(volume: str) -> Row:
    return Row(volume, (
        Panel("singh10, gamma 2", PUBLISHED, channel="ambient.Y"),
        Panel("combined, gamma 2", ("--occlusion", "combined", "--gamma", "2"), channel="ambient.Y"),
        Panel("ordinates", (), channel="ambient.Y"), AMBIENT))


def cloudy(volume: str, half_sky: Path) -> Row:
    return Row(volume, (
        Panel("octants, top four", ("--occlusion", "octants", "--light", "octants:top=only")),
        Panel("singh10, gamma 2", (*PUBLISHED, "--light", "octants:top=only")),
        Panel("ordinates, half a sky", ("--environment", str(half_sky))),
        Panel("reference", ("--integrand", "environment", "--environment", str(half_sky)), truth=True,
              channel="irradiance.G")))


def shadows(volume: str, light: str, octant: str) -> Row:
    """`light`, `octant`: directions; the second the diagonal of the octant that holds the first."""
    return Row(volume, (
        Panel("hard", ("--light", f"sun:direction={light}:shadow=hard")),
        Panel("one octant", ("--occlusion", "singh10", "--light", f"sun:direction={octant}")),
        Panel("turned octant", ("--light", f"sun:direction={light}:shadow=turned")),
        Panel("soft, 5 degrees", ("--light", f"sun:direction={light}:radius=5")),
        Panel("reference, 5 degrees", ("--integrand", "light", "--light-direction", light, "--light-radius", "5"),
              truth=True, channel="direct.Y")))


def translucent(volume: str, opacity: str) -> Row:
    return Row(volume, (
        Panel(f"octants, alpha {opacity}", ("--occlusion", "octants", "--opacity", opacity, "--exposure", "-.5")),
        Panel(f"ordinates, alpha {opacity}", ("--opacity", opacity, "--exposure", "-.5")),
        Panel(f"reference, alpha {opacity}", ("--integrand", "translucent", "--opacity", opacity), truth=True,
              channel="translucent.Y", scale=2 ** -.5)))


def reflections(volume: str) -> Row:
    return Row(volume, (
        Panel("openness", (), channel="ambient.Y"),
        Panel("openness, gamma 2", ("--gamma", "2"), channel="ambient.Y"),
        Panel("one reflection", ("--bounces", "1")),
        Panel("all reflections", ("--bounces", "all")),
        Panel("reference, 8 reflections", ("--integrand", "bounce", "--bounces", "8"), truth=True,
              channel="irradiance.G")))


def environment(volume: str, sky: Path) -> Row:
    return Row(volume, (
        Panel("ordinates", ("--environment", str(sky))),
        Panel("all reflections", ("--environment", str(sky), "--bounces", "all")),
        Panel("reference, no reflection", ("--integrand", "environment", "--environment", str(sky)), truth=True,
              channel="irradiance.G")))


def presets(volume: str) -> Row:
    return Row(volume, tuple(
        Panel(name, ("--preset", name, "--samples", "4"), channel="")
        for name in ("singh10", "clay", "studio", "cloudy", "translucent")))


def figures(half_sky: Path, sky: Path) -> tuple[Figure, ...]:
    """`half_sky`: white above the horizon, black below; `sky`: of many colours, with a sun."""
    return (
        Figure("geometry_term", "With and without the geometry term",
               "[Singh10] Fig. 6: eight octants with G_s, and their mean as one number.",
               (geometry_term("vorticity"), geometry_term("betaGal"))),
        Figure("cloudy", "A cloudy day",
               "[Singh10] Fig. 7: the top four octants alone, and an even sky over a black ground by ordinates.",
               (cloudy("vorticity", half_sky), cloudy("cranium", half_sky))),
        Figure("shadows", "Shadows",
               "[Singh10] Fig. 8 and 9: hard shadows by a ray, low-frequency ones by one octant of the grid and of a "
               "grid turned towards the light (Sec. 4.1), and a sun of 5 degrees by ordinates.",
               (shadows("corner", "1,-.6,1.3", "1,-1,1"), shadows("capillaries", "1,-.6,1.3", "1,-1,1"),
                shadows("aorta", "1,-.6,1.3", "1,-1,1"), shadows("cranium", "1,-.9,1.3", "1,-1,1"))),
        Figure("translucent", "Light through the solid",
               "[Singh10] Fig. 10: Eq. 8 with octants and with ordinates. Shown at half a stop less.",
               (*(translucent("capillaries", opacity) for opacity in ("1", ".7", ".4", ".1")),
                translucent("betaGal", ".4"), translucent("betaGal", ".1"))),
        Figure("reflections", "Light between surfaces",
               "What gamma 2 stands for in [Singh10]: the surface sends light on.",
               (reflections("gyroid"), reflections("cranium"))),
        Figure("environment", "Light from a map of the sky", "A map with a sun, a sky and a ground.",
               (environment("corner", sky), environment("betaGal", sky))),
        Figure("presets", "Presets", "`--preset` on real data, nothing else set.",
               (presets("cranium"), presets("mni"), presets("betaGal"), presets("aorta"))),
    )
