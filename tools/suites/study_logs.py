"""./steadyhand study on logs whose throughput is known."""

import csv
import json
import re
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import NormalDist

from study.rows import CONDITIONS
from suites.outcome import Outcome
from suites.process import ROOT, run

HEADER = (
    "trial,gesture,position,condition,start_s,end_s,duration_s,"
    "participant,amplitude_m,width_m,end_value_m,gesture_end_s\n"
)
# By hand, We = 4.133 SD, IDe = log2(Ae / We + 1).
# Ann: SD of 19, 20, 21 cm is 1 cm; log2(0.2 / 0.04133 + 1) = 2.545746 bits in 1 s.
# Bob: SD of 18, 22 cm is 2.828427 cm; log2(0.2 / 0.116899 + 1) = 1.438761 bits in 0.5 s. At half the way, with ends
# half as far apart, as many bits in 0.4 s: (2.877522 + 3.596903) / 2 = 3.237212 bits/s.
ANN = [(0.2, 0.19, 1.0), (0.2, 0.20, 0.8), (0.2, 0.21, 1.2)]
BOB = [(0.2, 0.18, 0.4), (0.2, 0.22, 0.6), (0.1, 0.09, 0.5), (0.1, 0.11, 0.3)]
BY_HAND = {"Ann, A.": [(2.545746, 2.545746)], "Bob": [(1.438761, 3.596903), (1.438761, 2.877522)]}
MEAN_BY_HAND = (2.545746 + 3.237212) / 2

DEVIATION_M = 0.012
# Share of the ends of a normal distribution within the effective width, by its definition.
SHARE_INSIDE = 0.96


def outcomes() -> Iterator[Outcome]:
    yield conditions()
    for test in (by_hand, known_deviation, bad_logs, bad_cells, rows_again, played_twice, no_study):
        with tempfile.TemporaryDirectory(prefix="steadyhand_study") as folder:
            yield from test(Path(folder))


def conditions() -> Outcome:
    """study/rows.py has the conditions of the scenes."""
    text = (ROOT / "demo_project/scripts/conditions.gd").read_text()
    names = re.search(r"^const NAMES.*= \[(.*)\]$", text, re.MULTILINE)[1]
    return Outcome.of("command/study: the conditions of the scenes", json.loads(f"[{names}]") == CONDITIONS, names)


def by_hand(folder: Path) -> Iterator[Outcome]:
    write_log(folder / "logs/first", "Ann, A.", ANN)
    write_log(folder / "logs/second", "Bob", BOB)
    # A trial without an end, one trial of another condition, and a blank line, as some editors add.
    with (folder / "logs/second/trials.csv").open("a") as file:
        file.write("live_900,tap,stable,synthesised,1.0,,,Bob,0.200000,0.004000,,\n")
        file.write("live_901,tap,stable,measured,1.0,1.9,0.9,Bob,0.200000,0.004000,0.2,2.0\n\n")
    # A folder inside of another is read once.
    status, output = run(["./steadyhand", "study", folder / "logs", folder / "logs/first", "--out", folder / "out"])
    yield Outcome.of("command/study: exit code", status == 0, output)
    if status != 0:
        return
    rows = read(folder / "out/throughput.csv")
    for name, expected in BY_HAND.items():
        own = [row for row in rows if row["participant"] == name and row["condition"] == "synthesised"]
        found = [(row["effective_difficulty_bits"], row["throughput_bits_s"]) for row in own]
        good = len(found) == len(expected) and all(
            near(float(value), wanted, 2e-6)
            for pair, wanted_pair in zip(found, expected, strict=True)
            for value, wanted in zip(pair, wanted_pair, strict=True)
        )
        yield Outcome.of(f"command/study: {name} as by hand", good, f"{own} instead of {expected}")
    blank = [row for row in rows if row["condition"] == "measured"]
    good = len(blank) == 1 and blank[0]["n"] == "1" and not blank[0]["throughput_bits_s"]
    yield Outcome.of("command/study: no throughput of one trial", good, f"{blank}")
    means = [row for row in read(folder / "out/throughput_means.csv") if row["condition"] == "synthesised"]
    good = (
        len(means) == 1
        and near(float(means[0]["throughput_bits_s"]), MEAN_BY_HAND, 2e-6)
        and (means[0]["participants"], means[0]["n"], means[0]["without_end"]) == ("2", "7", "1")
    )
    yield Outcome.of("command/study: a participant counts once", good, f"{means} instead of {MEAN_BY_HAND}")
    [alone] = [row for row in read(folder / "out/throughput_means.csv") if row["condition"] == "measured"]
    good = (alone["participants"], alone["n"], alone["throughput_bits_s"]) == ("0", "1", "")
    yield Outcome.of("command/study: a trial without a throughput is counted", good, f"{alone}")
    lines = [line for line in output.splitlines() if line.startswith(("gesture ", "tap "))]
    ends = {len(line) for line in lines if not line.endswith("-")}
    shown = [line.split()[-2] for line in lines if " synthesised " in line]
    good = len(lines) == 3 and len(ends) == 1 and shown == [f"{MEAN_BY_HAND:.2f}"]
    yield Outcome.of("command/study: one aligned table", good, output)


def known_deviation(folder: Path) -> Iterator[Outcome]:
    count = 4001
    normal = NormalDist(0.2, DEVIATION_M)
    ends = [normal.inv_cdf((i + 0.5) / count) for i in range(count)]
    write_log(folder / "logs", "Ann", [(0.2, end, 1.0) for end in ends])
    status, output = run(["./steadyhand", "study", folder / "logs/trials.csv", "--out", folder / "out"])
    rows = read(folder / "out/throughput.csv") if status == 0 else []
    width = float(rows[0]["effective_width_m"]) if len(rows) == 1 else 0.0
    inside = sum(abs(end - 0.2) < width / 2 for end in ends) / count
    yield Outcome.of("command/study: width of a known deviation", near(width, 4.133 * DEVIATION_M, 5e-5), output)
    yield Outcome.of("command/study: 96 % of the ends are inside", near(inside, SHARE_INSIDE, 0.002), f"{inside}")


def bad_logs(folder: Path) -> Iterator[Outcome]:
    write_log(folder / "logs/good", "Ann", ANN)
    (folder / "logs/old").mkdir()
    (folder / "logs/old/trials.csv").write_text(HEADER.replace(",end_value_m,gesture_end_s", ""))
    for name, separator in (("spreadsheet", ";"), ("copied", "\t")):
        (folder / f"logs/{name}").mkdir()
        (folder / f"logs/{name}/trials.csv").write_text(HEADER.replace(",", separator))
    write_log(folder / "logs/broken", "Bob", [])
    with (folder / "logs/broken/trials.csv").open("a") as file:
        file.write("a,tap,stable,measured,1.0,2.0,1.0,Bob,0.2,0.004,nan,2.0\n")
        file.write("b,tap,stable,measured,1.0,2.0,1.0,Bob,0.2,0.004,0.2,0.5\n")
        file.write("c,tap,stab")
    (folder / "logs/binary").mkdir()
    (folder / "logs/binary/trials.csv").write_bytes(bytes((197 * i + i // 7) % 256 for i in range(4000)))
    command = ["./steadyhand", "study", folder / "logs", folder / "nowhere", "--out", folder / "out"]
    status, output = run(command)
    messages = [
        f"{folder}/nowhere: not there",
        f"{folder}/logs/old/trials.csv:1: no column gesture_end_s, end_value_m",
        f"{folder}/logs/spreadsheet/trials.csv:1: cells are separated by ';'",
        f"{folder}/logs/copied/trials.csv:1: cells are separated by tabs",
        f"{folder}/logs/broken/trials.csv:2: end_value_m: 'nan'",
        f"{folder}/logs/broken/trials.csv:3: gesture_end_s: 0.5 is not after start_s 1.0",
        f"{folder}/logs/broken/trials.csv:4: 3 cells",
        f"{folder}/logs/binary/trials.csv:1: this is no UTF-8 text",
    ]
    missing = [text for text in messages if text not in output]
    yield Outcome.of(
        "command/study: bad logs are reported", status == 1 and not missing, f"{status}, {missing}\n{output}"
    )
    rows = read(folder / "out/throughput.csv") if status == 1 else []
    good = [row["participant"] for row in rows] == ["Ann"] and near(float(rows[0]["throughput_bits_s"]), 2.545746, 2e-6)
    yield Outcome.of("command/study: the other logs count", good, f"{rows}")
    status, output = run(["./steadyhand", "study", folder / "logs/binary", "--out", folder / "none"])
    good = status == 2 and "no trial was read" in output and not (folder / "none").exists()
    yield Outcome.of("command/study: nothing can be read", good, f"{status}\n{output}")


def bad_cells(folder: Path) -> Iterator[Outcome]:
    """Each bad row is reported with its line, and affects no other row."""
    good = "tap,stable,measured,1.0,2.0,1.0,Bob,0.2,0.004,0.2,2.0"
    rows: dict[str, str] = {
        good.replace("Bob", '"Bob'): "a quote is opened in this line, and not closed",
        good.replace("Bob", '"Bob" B.'): "text after a cell's closing quote",
        good.replace("Bob", "B\udcf6b"): "this is no UTF-8 text",
        good.replace(
            "measured", "mesured"
        ): "condition: 'mesured' is none of measured, average, one_euro, kalman, synth",
        good.replace("stable", "steady"): "position: 'steady' is none of stable, unstable",
        good.replace("tap", "none"): "gesture: 'none' is no gesture's name",
        good.replace(",0.2,2.0", ",inf,2.0"): "end_value_m: 'inf' is no finite number",
        good.replace(",0.2,2.0", ",0.2,2.1e6"): "gesture_end_s: '2.1e6' is not within +-1000000",
        good.replace(",0.2,2.0", ",-1e300,2.0"): "end_value_m: '-1e300' is not within +-1000000",
        good.replace("0.004", "0"): "width_m: '0' is no length",
    }
    (folder / "logs").mkdir()
    lines = [
        HEADER,
        *(f"a{number},{row}\n" for number, row in enumerate(rows)),
        f"swiped,{good}\n".replace("tap", "swpe"),
    ]
    lines += [f"ends,{good}\n"]
    path = folder / "logs/trials.csv"
    path.write_bytes("".join(lines).encode("utf-8", "surrogateescape"))
    status, output = run(["./steadyhand", "study", folder / "logs", "--out", folder / "out"])
    messages = [f"study: {path}:{line}: {fault}" for line, fault in enumerate(rows.values(), start=2)]
    missing = [text for text in messages if text not in output]
    good_lines = status == 1 and not missing and output.count(f"{path}:") == len(messages) + 1
    yield Outcome.of(
        "command/study: bad cells are reported with their line", good_lines, f"{status}, {missing}\n{output}"
    )
    own = "study: 'swpe' is none of the demo's tasks, horizontal_drag, vertical_drag, tap, zoom; the first is in "
    yield Outcome.of("command/study: a custom gesture is reported", f"{own}{path}:12\n" in output, output)
    read_rows = read(folder / "out/throughput.csv") if status == 1 else []
    names = [row["gesture"] for row in read_rows]
    yield Outcome.of("command/study: rows after bad rows are read", names == ["swpe", "tap"], f"{names}")


def rows_again(folder: Path) -> Iterator[Outcome]:
    """Equal rows of a trial count once. A trial without a start counts in each session."""
    write_log(folder / "logs/first", "Ann", ANN)
    write_log(folder / "logs/second", "Ann", [*ANN, (0.2, 0.22, 1.0)])
    for session in ("first", "second"):
        with (folder / f"logs/{session}/trials.csv").open("a") as file:
            file.write("live_009,tap,stable,synthesised,,,,Ann,0.200000,0.004000,,\n")
    with (folder / "logs/second/trials.csv").open("a") as file:
        file.write("live_003,tap,stable,synthesised,3.0,3.5,0.5,Ann,0.2,0.004,0.22,4.0\n")
    status, output = run(["./steadyhand", "study", folder / "logs", "--out", folder / "out"])
    first, second = folder / "logs/first/trials.csv", folder / "logs/second/trials.csv"
    messages = [
        f"study: {second}:2: the same row as {first}:2, and 2 more rows of these files: counted once",
        f"study: {second}:7: the same row as {second}:5: counted once",
    ]
    missing = [text for text in messages if text not in output]
    yield Outcome.of("command/study: repeated rows are reported", status == 1 and not missing, f"{missing}\n{output}")
    rows = read(folder / "out/throughput.csv") if status == 1 else []
    counts = [(row["n"], row["without_end"]) for row in rows]
    yield Outcome.of("command/study: repeated rows count once", counts == [("4", "2")], f"{counts}")


def played_twice(folder: Path) -> Iterator[Outcome]:
    """Two demos play the same trials. Their subjects are no persons. An old log has no column `origin`."""
    write_log(folder / "logs/person", "Ann", ANN)
    for session, added in (("first", ""), ("second", ""), ("third", ",replay")):
        write_log(folder / f"logs/{session}", "evaluate_0", ANN)
        path = folder / f"logs/{session}/trials.csv"
        lines = path.read_text().replace("live_", "evaluate_0_tap_").splitlines()
        header = lines[0] + (",origin" if added else "")
        path.write_text("\n".join([header, *(line + added for line in lines[1:]), ""]))
    status, output = run(["./steadyhand", "study", folder / "logs", "--out", folder / "out"])
    good = status == 0 and output.count("counted once") == 2
    yield Outcome.of("command/study: a trial played in two sessions is a note, exit 0", good, f"{status}\n{output}")
    means = read(folder / "out/throughput_means.csv") if status == 0 else []
    found = [(row["origin"], row["participants"], row["n"]) for row in means]
    good = found == [("person", "1", "3"), ("replay", "1", "3")]
    yield Outcome.of("command/study: played trials do not count as a person's", good, f"{found}")


def no_study(folder: Path) -> Iterator[Outcome]:
    """Other files of the demo: replays, and the played trial set."""
    write_log(folder / "logs/first", "Ann", ANN)
    write_log(folder / "replays/second", "Bob", BOB)
    (folder / "replays/no_study.txt").touch()
    (folder / "synthetic").mkdir()
    (folder / "synthetic/trials.csv").write_text(
        "trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_z,axis_x,axis_y,axis_z,amplitude_m\n"
    )
    status, output = run(["./steadyhand", "study", folder, "--out", folder / "out"])
    notes = [
        f"study: {folder}/replays is left out: it has a no_study.txt",
        f"study: {folder}/synthetic/trials.csv is left out: it is a trial set's, no log",
    ]
    missing = [text for text in notes if text not in output]
    yield Outcome.of("command/study: only the logs of the demo's folder are read", status == 0 and not missing, output)
    people = {row["participant"] for row in read(folder / "out/throughput.csv")} if status == 0 else {}
    yield Outcome.of("command/study: no replay counts", people == {"Ann"}, f"{people}")
    status, output = run(["./steadyhand", "study", folder / "replays", "--out", folder / "out"])
    yield Outcome.of("command/study: a named folder of replays is read", status == 0, f"{status}\n{output}")


def write_log(folder: Path, participant: str, trials: list[tuple[float, float, float]]) -> None:
    """Taps in `synthesised`: amplitude (m), end (m) and duration (s) of each."""
    folder.mkdir(parents=True)
    with (folder / "trials.csv").open("w", newline="") as file:
        file.write(HEADER)
        rows = csv.writer(file, lineterminator="\n")
        for number, (amplitude_m, end_m, time_s) in enumerate(trials):
            rows.writerow(
                [f"live_{number:03}", "tap", "stable", "synthesised", "3.0", "3.5", "0.5", participant]
                + [f"{amplitude_m:.6f}", "0.004000", f"{end_m:.9f}", f"{3.0 + time_s:.6f}"]
            )


def read(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def near(value: float, expected: float, tolerance: float) -> bool:
    return abs(value - expected) <= tolerance
