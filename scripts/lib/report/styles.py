"""Colours and markers of the figures."""

# Okabe and Ito's palette: told apart with every kind of colour vision.
BLACK, ORANGE, SKY, GREEN, BLUE, VERMILION, PURPLE, GREY = ("#000000", "#e69f00", "#56b4e9", "#009e73", "#0072b2",
                                                            "#d55e00", "#cc79a7", "#999999")
OTHERS = (BLUE, ORANGE, GREEN, PURPLE, SKY)
OURS = ("o", "*", "X", "p", "h", "<", ">", "d")
MARKERS = ("s", "^", "D", "v", "P")


def style_of(names: list[str]) -> dict[str, tuple[str, str]]:
    """Colour and marker of each: Isolume's own stand out in one colour, the others go through the palette. ValueError:
    more names than there are styles."""
    ours = [name for name in names if name.startswith("Isolume")]
    others = [name for name in names if name not in ours]
    if len(ours) > len(OURS) or len(others) > len(OTHERS):
        raise ValueError(f"expected at most {len(OURS)} series of Isolume and {len(OTHERS)} others, found {len(ours)} "
                         f"and {len(others)}")
    return {**dict(zip(ours, ((VERMILION, marker) for marker in OURS))),
            **dict(zip(others, zip(OTHERS, MARKERS)))}
