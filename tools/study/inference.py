"""Statistical tests on participants' means, by pingouin and SciPy: a test that the design does not allow is refused.

Each test takes the cells of one measure and one gesture. It returns rows of results, or raises Refused with a reason.
"""

import itertools
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pandas as pd
import pingouin as pg
from scipy import stats
from study.measures import MOTIONS, Mean
from study.rows import POSITIONS

LEAST_PEOPLE = 3
# Relative to the largest value: less than this is rounding, not variance.
ROUNDING = 1e-9
EFFECTS = {"position": "position", "motion": "motion profile", "position * motion": "interaction"}


class Refused(Exception):
    """The design does not allow the test. The text says why in one sentence."""


@dataclass
class Design:
    """Values by participant, position and motion."""

    values: dict[tuple[str, str, str], float]
    people: list[str] = field(init=False)
    positions: list[str] = field(init=False)
    motions: list[str] = field(init=False)

    def __post_init__(self) -> None:
        self.people = sorted({person for person, _, _ in self.values})
        self.positions = [one for one in POSITIONS if any(key[1] == one for key in self.values)]
        self.motions = [one for one in MOTIONS if any(key[2] == one for key in self.values)]

    @classmethod
    def of(cls, means: list[Mean]) -> "Design":
        return cls({(one.participant, one.position, one.motion): one.value for one in means})

    def matrix(self, cells: list[tuple[str, str]]) -> np.ndarray:
        """A row for each participant, a column for each cell. Refused if there are too few people or a gap."""
        if len(self.people) < LEAST_PEOPLE:
            people = "1 person" if len(self.people) == 1 else f"{len(self.people)} people"
            raise Refused(f"The test needs {LEAST_PEOPLE} or more people, and there is data of {people}.")
        gaps = [(person, *cell) for person in self.people for cell in cells if (person, *cell) not in self.values]
        if gaps:
            person, position, motion = gaps[0]
            others = f" ({len(gaps) - 1} more gaps)" if len(gaps) > 1 else ""
            raise Refused(
                f"Participant {person} has no value in the cell {position or 'no position'}, {motion}{others}:"
                f" add the missing trials, or leave the participant out with --without {person}."
            )
        return np.array([[self.values[(person, *cell)] for cell in cells] for person in self.people])


def is_constant(values: np.ndarray, scale: float) -> bool:
    return bool(np.ptp(values) <= ROUNDING * max(scale, np.finfo(float).tiny))


def normality(design: Design, position: str, motion: str) -> dict:
    """Shapiro-Wilk, and the paper's one-sample Kolmogorov-Smirnov test with the sample's own mean and deviation."""
    column = design.matrix([(position, motion)])[:, 0]
    if is_constant(column, np.max(np.abs(column))):
        raise Refused("All participants have the same value.")
    shapiro = stats.shapiro(column)
    ks = stats.kstest((column - column.mean()) / column.std(ddof=1), "norm")
    return {
        "n": len(column),
        "mean": column.mean(),
        "sd": column.std(ddof=1),
        "shapiro_w": shapiro.statistic,
        "shapiro_p": shapiro.pvalue,
        "ks_d": ks.statistic,
        "ks_p": ks.pvalue,
    }


def anova(design: Design) -> list[dict]:
    """Two-way repeated-measures ANOVA: position x motion profile. Effects without an error variance are refused."""
    for name, levels in (("position", design.positions), ("motion profile", design.motions)):
        if len(levels) < 2:
            only = f"'{levels[0] or 'none'}'" if levels else "no value"
            raise Refused(f"A two-way ANOVA needs 2 or more levels of the {name}, and there is only {only}.")
    cells = list(itertools.product(design.positions, design.motions))
    matrix = design.matrix(cells)
    scale = np.max(np.abs(matrix))
    if is_constant(matrix, scale):
        raise Refused("All values are equal.")
    if any(np.max(np.abs(error)) <= ROUNDING * scale for error in errors(matrix, len(design.motions))):
        raise Refused("Participants do not differ in at least one effect: its error variance is zero.")
    long = pd.DataFrame(
        [(person, *cell, matrix[i, j]) for i, person in enumerate(design.people) for j, cell in enumerate(cells)],
        columns=["participant", "position", "motion", "value"],
    )
    arguments = {"dv": "value", "within": ["position", "motion"], "subject": "participant"}
    generalised = pg.rm_anova(long, **arguments, effsize="ng2").set_index("Source")
    partial = pg.rm_anova(long, **arguments, effsize="np2").set_index("Source")
    return [anova_row(effect, generalised.loc[effect], partial.loc[effect], len(design.people)) for effect in EFFECTS]


def anova_row(effect: str, found: pd.Series, partial: pd.Series, people: int) -> dict:
    # With two levels there is one difference between levels: sphericity holds, and nothing is corrected.
    is_corrected = found["ddof1"] > 1
    return {
        "effect": EFFECTS[effect],
        "people": people,
        "df1": int(found["ddof1"]),
        "df2": int(found["ddof2"]),
        "f": float(found["F"]),
        "p": float(found["p_unc"]),
        "gg_epsilon": float(found["eps"]) if is_corrected else None,
        "p_gg": float(found["p_GG_corr"]) if is_corrected else None,
        "generalised_eta2": float(found["ng2"]),
        "partial_eta2": float(partial["np2"]),
    }


def errors(matrix: np.ndarray, motions: int) -> list[np.ndarray]:
    """What is left of each effect when a participant's mean and the effect's mean are taken away."""
    cube = matrix.reshape(len(matrix), -1, motions)
    cube = cube - cube.mean(axis=(1, 2), keepdims=True)
    position = cube.mean(axis=2, keepdims=True)
    motion = cube.mean(axis=1, keepdims=True)
    parts = [position, motion, cube - position - motion]
    return [part - part.mean(axis=0, keepdims=True) for part in parts]


def pairs(design: Design) -> list[tuple[tuple[str, str], tuple[str, str]]]:
    """The post hoc comparisons: motions in each position, then positions in each motion."""
    motions = [
        ((position, a), (position, b))
        for position in design.positions
        for a, b in itertools.combinations(design.motions, 2)
    ]
    positions = [
        ((a, motion), (b, motion)) for motion in design.motions for a, b in itertools.combinations(design.positions, 2)
    ]
    return [*motions, *positions]


def paired_t(design: Design, a: tuple[str, str], b: tuple[str, str], comparisons: int) -> dict:
    """A paired t-test, its p multiplied by the number of comparisons (Bonferroni)."""
    matrix = design.matrix([a, b])
    differences = matrix[:, 0] - matrix[:, 1]
    if is_constant(differences, np.max(np.abs(matrix))):
        raise Refused("All participants have the same difference: its variance is zero.")
    found = stats.ttest_rel(matrix[:, 0], matrix[:, 1])
    p = float(found.pvalue)
    return {
        "a": " ".join(filter(None, a)),
        "b": " ".join(filter(None, b)),
        "people": len(matrix),
        "difference": differences.mean(),
        "t": float(found.statistic),
        "df": int(found.df),
        "p": p,
        "comparisons": comparisons,
        "p_bonferroni": min(1.0, p * comparisons),
        "cohen_d": float(pg.compute_effsize(matrix[:, 0], matrix[:, 1], paired=True, eftype="cohen")),
        "cohen_dz": differences.mean() / differences.std(ddof=1),
    }


def friedman(design: Design, position: str) -> dict:
    """Friedman's test of the motion profiles in one position."""
    if len(design.motions) < 3:
        raise Refused(f"Friedman's test needs 3 or more motion profiles, and there are {len(design.motions)}.")
    matrix = design.matrix([(position, motion) for motion in design.motions])
    if all(is_constant(row, np.max(np.abs(matrix))) for row in matrix):
        raise Refused("Every participant has the same value for all motion profiles.")
    frame = pd.DataFrame(matrix, columns=design.motions)
    found = pg.friedman(frame).iloc[0]
    return {
        "position": position,
        "people": len(matrix),
        "df": int(found["ddof1"]),
        "q": float(found["Q"]),
        "p": float(found["p_unc"]),
        "kendall_w": float(found["W"]),
    }


@dataclass
class Results:
    """Of one measure and one gesture."""

    kind: str
    measure: str
    gesture: str
    normality: list[dict] = field(default_factory=list)
    anova: list[dict] = field(default_factory=list)
    post_hoc: list[dict] = field(default_factory=list)
    friedman: list[dict] = field(default_factory=list)
    refused: list[dict] = field(default_factory=list)

    def attempt(self, test: str, run: Callable[[], list[dict]]) -> list[dict]:
        try:
            return run()
        except Refused as reason:
            self.refused.append({"test": test, "reason": str(reason)})
            return []


def all_tests(means: list[Mean]) -> list[Results]:
    groups: dict[tuple[str, str, str], list[Mean]] = {}
    for one in means:
        groups.setdefault((one.kind, one.measure, one.gesture), []).append(one)
    return [tests(*key, Design.of(own)) for key, own in groups.items()]


def tests(kind: str, measure: str, gesture: str, design: Design) -> Results:
    results = Results(kind, measure, gesture)
    for position, motion in itertools.product(design.positions, design.motions):
        cell = {"position": position, "motion": motion}
        results.normality += results.attempt(
            f"normality, {position} {motion}", lambda cell=cell: [cell | normality(design, **cell)]
        )
    results.anova = results.attempt("two-way ANOVA", lambda: anova(design))
    compared = pairs(design)
    for a, b in compared:
        name = f"t-test, {' '.join(a)} against {' '.join(b)}"
        results.post_hoc += results.attempt(name, lambda a=a, b=b: [paired_t(design, a, b, len(compared))])
    for position in design.positions if kind == "answer" else ():
        results.friedman += results.attempt(
            f"Friedman, {position}", lambda position=position: [friedman(design, position)]
        )
    return results
