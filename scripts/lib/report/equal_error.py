"""What a picture by rays costs that is no worse than one of ours: times at equal error."""

from .section import Row, table
from .stats import digits


def error(row: Row) -> float:
    """RMSE, less the reference's own noise where that is known: it is no method's fault."""
    known = row.get("rmse_without_noise")
    return row["rmse"] if known is None else known


def compare(ours: list[Row], peers: list[Row]) -> list[Row]:
    """For each of ours the peer's first setting, by rising knob, whose error is no larger. Where there is none, its
    last: `reached` is false, and the ratios are below what equal error would take."""
    ordered = sorted(peers, key=lambda row: row["knob"])
    found = []
    for own in ours:
        as_good = next((row for row in ordered if error(row) <= error(own)), None)
        peer = as_good or ordered[-1]
        found.append({"knob": own["knob"], "error": error(own), "peer_knob": peer["knob"], "peer_error": error(peer),
                      "reached": as_good is not None, "first": peer["first_seconds"] / own["first_seconds"],
                      "further": peer["further_seconds"] / own["further_seconds"]})
    return found


def table_of(rows: list[Row], peer: str) -> str:
    lines = []
    for row in rows:
        more = "" if row["reached"] else "> "
        lines.append([f"{row['knob']:g} ordinates", digits(row["error"]), f"{more}{row['peer_knob']:g}",
                      digits(row["peer_error"]), f"{more}{digits(row['first'], 2)}",
                      f"{more}{digits(row['further'], 2)}"])
    return table(["Isolume", "RMSE", f"{peer} for no more", "RMSE", "first picture, times as long",
                  "further picture, times as long"], lines)


def finding(name: str, rows: list[Row], peer: str) -> str:
    """The most exact of ours."""
    best = min(rows, key=lambda row: row["error"])
    more = "" if best["reached"] else "more than "
    return (f"**{name}**: for the error of {best['knob']:g} ordinates ({digits(best['error'])}) it takes "
            f"{more}{best['peer_knob']:g} {peer} ({digits(best['peer_error'])}): {more}{digits(best['first'], 2)} times "
            f"as long for the first picture, {more}{digits(best['further'], 2)} for a further one.")
