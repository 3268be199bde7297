"""Numbers as the pages show them."""


def percent(share: float) -> str:
    return f"{100 * share:.1f} %"


def ms(value_s: float) -> str:
    return f"{1000 * value_s:+.0f} ms"
