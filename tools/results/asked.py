"""What is to be reached, where more than one page asks for it."""

# T_diff of 95 % of the trials, s: from so late to so early.
T_DIFF_S = {"stable": (-0.05, 0.015), "unstable": (-0.1, 0.1)}


def is_inside(t_diff_s: float, position: str) -> bool:
    latest_s, earliest_s = T_DIFF_S[position]
    return latest_s <= t_diff_s <= earliest_s
