"""Medians with their spread, and numbers as the report prints them."""

import math
import statistics
from dataclasses import dataclass
from typing import Iterable


@dataclass(frozen=True)
class Timing:
    """Seconds of several runs: the median, and the fastest and slowest of them."""

    median: float
    least: float
    most: float

    @staticmethod
    def of(seconds: Iterable[float]) -> "Timing":
        values = list(seconds)
        return Timing(statistics.median(values), min(values), max(values))


def sums(*lists: list[float]) -> list[float]:
    """Run by run: the whole of several stages."""
    return [sum(parts) for parts in zip(*lists, strict=True)]


def digits(value: float | None, significant: int = 3) -> str:
    """Three significant digits without an exponent; a dash for what does not exist."""
    if value is None or math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞"
    if value == 0:
        return "0"
    places = significant - 1 - math.floor(math.log10(abs(value)))
    rounded = round(value, places)
    if abs(rounded) >= 10 ** (significant - places):  # 9.999 becomes 10.0, not 10.00
        places -= 1
    return f"{rounded:.{max(0, places)}f}"


def seconds_text(timing: Timing | None) -> str:
    """`median (least to most)`, and the median alone where nothing was repeated."""
    if timing is None:
        return "–"
    if timing.least == timing.most:
        return digits(timing.median)
    return f"{digits(timing.median)} ({digits(timing.least)} to {digits(timing.most)})"


def range_text(values: Iterable[float], unit: str = "") -> str:
    """`least to most`, or one number where they print alike."""
    listed = list(values)
    low, high = digits(min(listed), 2), digits(max(listed), 2)
    return f"{low}{unit}" if low == high else f"{low} to {high}{unit}"
