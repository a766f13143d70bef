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
    scale: float = 1.0             # of what is shown, so that nothing is brighter than the paper


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
    "terrain": Volume("terrain", ("--isovalue", "0", "--inside", "below"), 128, ("--elevation", "40")),
    "gyroid": Volume("gyroid", ("--isovalue", "0", "--inside", "below"), 160),
    "cranium": Volume("cranium.nhdr", ("--isovalue", "300"), view=("--azimuth", "150", "--elevation", "8")),
    "betaGal": Volume("betaGal.mrc", ("--isovalue", "0.06")),
    "mni": Volume("mni152_2009.nii.gz", ()),
    "aorta": Volume("aorta_cta.mha", ("--isovalue", "800")),
}

PUBLISHED = ("--occlusion", "singh10", "--gamma", "2")
AMBIENT = Panel("reference", ("--integrand", "ambient"), truth=True, channel="ambient.Y")


HALF_A_STOP = 2 ** -.5


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
        Panel(f"octants, alpha {opacity}", ("--occlusion", "octants", "--opacity", opacity), scale=HALF_A_STOP),
        Panel(f"ordinates, alpha {opacity}", ("--opacity", opacity), scale=HALF_A_STOP),
        Panel(f"reference, alpha {opacity}", ("--integrand", "translucent", "--opacity", opacity), truth=True,
              channel="translucent.Y", scale=HALF_A_STOP)))


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


def screen(volume: str, *names: str) -> Row:
    return Row(volume, (*(Panel(name, ("--occlusion", name), channel="ambient.Y") for name in names), AMBIENT))


def characteristics(volume: str, radius: str, *view: str) -> Row:
    volumetric = ("--occlusion", "szirmay10-volumetric", "--ao-radius", radius, "--ao-samples", "32")
    return Row(volume, (
        *(Panel(f"volumetric, {name}", (*volumetric, "--surface", name), channel="ambient.Y")
          for name in ("zbuffer", "heightfield", "implicit")),
        Panel("reference, same radius", ("--integrand", "ambient", "--radius", radius, "--membership", "volumetric"),
              truth=True, channel="ambient.Y")), view)


def bent(volume: str, map_file: Path) -> Row:
    map_options = ("--environment", str(map_file))
    return Row(volume, (
        *(Panel(f"{source}, {lookup}",
                ("--occlusion", "klehm11", "--bent-from", source, "--bent", lookup, *map_options))
          for source in ("crytek-3d", "sweep") for lookup in ("none", "normal", "cone")),
        Panel("env-importance", ("--occlusion", "env-importance", *map_options)),
        Panel("ordinates", map_options),
        Panel("reference", ("--integrand", "environment", *map_options), truth=True)))


def bleeding(volume: str, radius: str, *color: str) -> Row:
    screen_light = ("--occlusion", "szirmay10-volumetric", "--ao-radius", radius, "--ao-samples", "64", *color)
    return Row(volume, (
        Panel("ordinates", color, channel="ambient.Y"),
        Panel("from the screen", screen_light, channel="ambient.Y"),
        Panel("with light from nearby", (*screen_light, "--indirect", "on"), channel="ambient.Y")))


def presets(volume: str) -> Row:
    return Row(volume, tuple(
        Panel(name, ("--preset", name, "--samples", "4"), channel="")
        for name in ("singh10", "clay", "studio", "cloudy", "translucent")))


def figures(half_sky: Path, sky: Path, two_colours: Path) -> tuple[Figure, ...]:
    """`half_sky`: white above the horizon, black below; `sky`: of many colours, with a sun; `two_colours`: warm to one
    side, blue to the other."""
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
        Figure("screen", "Occlusion from the screen",
               "Each estimator that reads the picture alone, 12 samples per pixel, radius a tenth of the solid's longest "
               "side, against ambient occlusion without a limit, which none of them computes.",
               (screen("betaGal", "crytek", "hbao", "gtao", "bitmask", "ssdo", "gpu-disk"),
                screen("betaGal", "gpu-sphere", "gpu-hemisphere", "gpu-importance", "gpu-tangent",
                       "szirmay10-containment", "szirmay10-volumetric"),
                screen("betaGal", "loos10-point", "loos10-line", "loos10-area", "klehm11", "octants", "ordinates"))),
        Figure("characteristic", "What is taken for solid",
               "[Szirmay10] Sec. 3: behind what the picture shows, below the highest of the column along z, or by the "
               "volume itself, which has no blind spots.",
               (characteristics("terrain", ".1"), characteristics("betaGal", "40"))),
        Figure("bent", "Bent normals and cones",
               "[Klehm11]: light of two coloured halves of the sky, looked up by openness alone, by bent normals and by "
               "cones, from the screen and from the volume's ordinates.",
               (bent("corner", two_colours), bent("mni", two_colours))),
        Figure("bleeding", "Colour, and colour that bleeds",
               "`--color-by`: a coordinate, and another volume; and [SzirmayGpu] Sec. 2: what is closed receives the mean "
               "light of what it faces nearby.",
               (bleeding("corner", ".3", "--color-by", "x"), bleeding("cranium", "40", "--color-by", "z"))),
        Figure("presets", "Presets", "`--preset` on real data, nothing else set.",
               (presets("cranium"), presets("mni"), presets("betaGal"), presets("aorta"))),
    )
