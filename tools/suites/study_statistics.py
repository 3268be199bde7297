"""The tests of ./steadyhand study against a textbook, against other computations, and on data of known effect."""

import itertools
import warnings
from collections.abc import Iterator

import numpy as np
from suites.outcome import Outcome

# Table 12.1 of Maxwell & Delaney 2004, "Designing Experiments and Analyzing Data", 2nd ed., p. 574, hypothetical
# reaction times in ms: noise (absent, present) x angle (0, 4, 8 degrees) of ten people. The same data is md_12.1 of
# the R package afex. By hand from the table: the sums of squares are 285660, 289920 and 105120.
TEXTBOOK = """
420 420 480 480 600 780
420 480 480 360 480 600
480 480 540 660 780 780
420 540 540 480 780 900
540 660 540 480 660 720
360 420 360 360 480 540
480 480 600 540 720 840
480 600 660 540 720 900
540 600 540 480 720 780
480 420 540 540 660 780
"""
# F, df, and the Greenhouse-Geisser epsilon: published.
PUBLISHED = {
    "position": (33.77, 1, 9, None),
    "motion profile": (40.72, 2, 18, 0.9616),
    "interaction": (45.31, 2, 18, 0.9040),
}
POSITIONS, MOTIONS = ["stable", "unstable"], ["measured", "synthesised", "average"]
CELLS = list(itertools.product(POSITIONS, MOTIONS))
NULL_STUDIES = 200
# Of 200 null studies at 5 %, 10 are expected; a binomial count is outside of these once in 10 000 times.
NULL_RANGE = (1, 24)


def outcomes() -> Iterator[Outcome]:
    yield from textbook()
    yield from other_computations()
    yield null_studies()
    yield known_effect()
    yield from pairs()
    yield from refusals()


def design(matrix: np.ndarray, cells: list[tuple[str, str]] = CELLS):
    from study.inference import Design

    return Design({(f"p{i:02}", *cell): float(row[j]) for i, row in enumerate(matrix) for j, cell in enumerate(cells)})


def textbook_matrix() -> np.ndarray:
    return np.array([line.split() for line in TEXTBOOK.split("\n") if line], dtype=float)


def textbook() -> Iterator[Outcome]:
    from study.inference import anova

    for row in anova(design(textbook_matrix())):
        f, df1, df2, epsilon = PUBLISHED[row["effect"]]
        same = abs(row["f"] - f) < 0.005 and (row["df1"], row["df2"]) == (df1, df2)
        same_epsilon = row["gg_epsilon"] == epsilon if epsilon is None else abs(row["gg_epsilon"] - epsilon) < 5e-5
        name = f"command/study report: ANOVA of a textbook's table, {row['effect']}"
        yield Outcome.of(name, same and same_epsilon, f"{row} instead of {PUBLISHED[row['effect']]}")


def sums_of_squares(cube: np.ndarray) -> dict[str, tuple[float, float]]:
    """Of each effect and its error, term by term from the means (participants x positions x motions)."""
    n, a, b = cube.shape
    grand = cube.mean()
    of_a, of_b, of_s = cube.mean((0, 2)), cube.mean((0, 1)), cube.mean((1, 2))
    of_ab, of_sa, of_sb = cube.mean(0), cube.mean(2), cube.mean(1)
    error_a = of_sa - of_s[:, None] - of_a[None, :] + grand
    error_b = of_sb - of_s[:, None] - of_b[None, :] + grand
    effect_ab = of_ab - of_a[:, None] - of_b[None, :] + grand
    error_ab = (
        cube - of_sa[:, :, None] - of_sb[:, None, :] - of_ab[None]
        + of_s[:, None, None] + of_a[None, :, None] + of_b[None, None, :] - grand
    )  # fmt: skip
    return {
        "position": (n * b * np.sum((of_a - grand) ** 2), b * np.sum(error_a**2)),
        "motion profile": (n * a * np.sum((of_b - grand) ** 2), a * np.sum(error_b**2)),
        "interaction": (n * np.sum(effect_ab**2), np.sum(error_ab**2)),
    }


def other_computations() -> Iterator[Outcome]:
    """Explicit sums of squares, and statsmodels."""
    import pandas as pd
    from statsmodels.stats.anova import AnovaRM
    from study.inference import anova

    random = np.random.default_rng(5)
    noisy = random.normal(size=(7, 6)) + random.normal(size=(7, 1)) + [0.0, 0.5, 1.0, 0.0, 1.5, 3.0]
    names = {"position": "position", "motion": "motion profile", "position:motion": "interaction"}
    for title, matrix in (("textbook", textbook_matrix()), ("random", noisy)):
        rows = {row["effect"]: row for row in anova(design(matrix))}
        squares = sums_of_squares(matrix.reshape(len(matrix), 2, 3))
        long = pd.DataFrame(
            [(i, *cell, row[j]) for i, row in enumerate(matrix) for j, cell in enumerate(CELLS)],
            columns=["person", "position", "motion", "value"],
        )
        other = AnovaRM(long, "value", "person", within=["position", "motion"]).fit().anova_table
        for effect, row in other.iterrows():
            ours = rows[names[effect]]
            within, error = squares[names[effect]]
            by_hand = {
                "f": (within / ours["df1"]) / (error / ours["df2"]),
                "partial_eta2": within / (within + error),
                "generalised_eta2": within
                / (within + person_squares(matrix) + sum(one for _, one in squares.values())),
            }
            good = all(np.isclose(ours[key], value, rtol=1e-6) for key, value in by_hand.items())
            yield Outcome.of(
                f"command/study report: {title} ANOVA by sums of squares, {names[effect]}", good, f"{ours} {by_hand}"
            )
            good = np.isclose(ours["f"], row["F Value"], rtol=1e-6) and np.isclose(ours["p"], row["Pr > F"], rtol=1e-6)
            yield Outcome.of(
                f"command/study report: {title} ANOVA as statsmodels, {names[effect]}", good, f"{ours}\n{row}"
            )


def person_squares(matrix: np.ndarray) -> float:
    return matrix.shape[1] * np.sum((matrix.mean(1) - matrix.mean()) ** 2)


def null_studies() -> Outcome:
    """Without an effect, 5 % of studies have p < 0.05."""
    from study.inference import anova

    random = np.random.default_rng(6)
    found = 0
    for _ in range(NULL_STUDIES):
        matrix = random.normal(size=(9, 6)) + random.normal(size=(9, 1))
        found += anova(design(matrix))[2]["p"] < 0.05
    good = NULL_RANGE[0] <= found <= NULL_RANGE[1]
    return Outcome.of("command/study report: no effect gives p < 0.05 in about 5 % of studies", good, f"{found}")


def known_effect() -> Outcome:
    """An interaction, and nothing else: main effects cancel."""
    from study.inference import anova

    random = np.random.default_rng(7)
    matrix = random.normal(0.0, 0.5, size=(9, 6)) + np.array([1.0, -1.0, 0.0, -1.0, 1.0, 0.0])
    p = {row["effect"]: row["p"] for row in anova(design(matrix))}
    good = p["interaction"] < 1e-4 and p["position"] > 0.05 and p["motion profile"] > 0.05
    return Outcome.of("command/study report: a planted interaction is found, and no main effect", good, f"{p}")


def pairs() -> Iterator[Outcome]:
    from study.inference import Design, friedman, normality, paired_t, tests

    # Differences 1, 2, 3, 4, 5: mean 3, SD 1.5811, t = 3 / (1.5811 / sqrt(5)) = 4.2426, d_z = 1.8974.
    first, second = CELLS[0], CELLS[1]
    values = {(f"p{i}", *first): 10.0 + i for i in range(5)} | {(f"p{i}", *second): 9.0 for i in range(5)}
    row = paired_t(Design(values), first, second, 9)
    good = np.isclose(row["t"], 4.242641, atol=1e-6) and np.isclose(row["cohen_dz"], 1.897367, atol=1e-6)
    good = good and row["df"] == 4 and np.isclose(row["p_bonferroni"], 9 * row["p"])
    yield Outcome.of("command/study report: a t-test as by hand, p times 9", good, f"{row}")
    values = {(f"p{i}", *first): 0.999 + 1e-3 * i for i in range(3)} | {(f"p{i}", *second): 0.0 for i in range(3)}
    with warnings.catch_warnings(record=True) as issued:
        warnings.simplefilter("always")
        row = paired_t(Design(values), first, second, 9)
    yield Outcome.of(
        "command/study report: a t-test of nearly equal differences is silent", not issued, f"{issued}, {row}"
    )
    results = tests("curve", "r2", "tap", design(textbook_matrix()))
    good = len(results.post_hoc) == 9 and all(one["comparisons"] == 9 for one in results.post_hoc)
    yield Outcome.of("command/study report: 6 pairs of motions and 3 of positions", good, f"{results.post_hoc}")
    # Ranks of three motions, equal for all of four people: Q = 12 / (4 * 3 * 4) * (4^2 + 8^2 + 12^2) - 3 * 4 * 4 = 8.
    row = friedman(design(np.array([[1, 2, 3, 1, 2, 3]] * 4) + np.arange(4)[:, None]), "stable")
    good = np.isclose(row["q"], 8.0) and np.isclose(row["kendall_w"], 1.0) and row["df"] == 2
    yield Outcome.of("command/study report: Friedman's test as by hand", good, f"{row}")
    random = np.random.default_rng(8)
    skewed = design(np.exp(2.0 * random.normal(size=(30, 6))))
    normal = design(random.normal(size=(30, 6)))
    p = [normality(one, "stable", "measured")["shapiro_p"] for one in (skewed, normal)]
    yield Outcome.of(
        "command/study report: Shapiro-Wilk distinguishes skewed from normal", p[0] < 1e-3 < 0.05 < p[1], f"{p}"
    )


def refusals() -> Iterator[Outcome]:
    from study.inference import anova, friedman, normality, paired_t, tests

    matrix = textbook_matrix()
    gap = design(matrix)
    del gap.values[("p03", "unstable", "average")]
    constant = design(np.full((5, 6), 2.0))
    additive = design(np.arange(5.0)[:, None] + np.arange(6.0)[None, :])
    for name, run, message in (
        ("two people", lambda: anova(design(matrix[:2])), "3 or more people, and there is data of 2 people"),
        ("one person", lambda: anova(design(matrix[:1])), "3 or more people, and there is data of 1 person"),
        ("a gap", lambda: anova(gap), "Participant p03 has no value in the cell unstable, average"),
        ("equal values", lambda: anova(constant), "All values are equal"),
        ("no error variance", lambda: anova(additive), "its error variance is zero"),
        ("one position", lambda: anova(design(matrix[:, :3], CELLS[:3])), "2 or more levels of the position"),
        ("one motion", lambda: anova(design(matrix[:, ::3], CELLS[::3])), "2 or more levels of the motion profile"),
        ("equal differences", lambda: paired_t(additive, *CELLS[:2], 9), "its variance is zero"),
        ("equal values", lambda: normality(constant, "stable", "measured"), "have the same value"),
        ("equal values", lambda: friedman(constant, "stable"), "the same value for all motion profiles"),
        ("two motions", lambda: friedman(design(matrix[:, :2], CELLS[:2]), "stable"), "needs 3 or more motion"),
    ):
        yield Outcome.of(f"command/study report: {name} refused: {message}", *refused(run, message))
    results = tests("answer", "paper/smoothness", "tap", gap)
    done = (len(results.anova), len(results.post_hoc), len(results.normality), len(results.friedman))
    # A gap takes the ANOVA, 3 of 9 pairs, one normality test and one of two Friedman tests.
    yield Outcome.of("command/study report: after a refusal other tests go on", done == (0, 6, 5, 1), f"{done}")


def refused(run, message: str) -> tuple[bool, str]:
    from study.inference import Refused

    try:
        return False, f"not refused: {run()}"
    except Refused as reason:
        return message in str(reason), str(reason)
