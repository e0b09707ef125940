"""Buildings, their isolators, and shear models."""

TEXTS: dict[str, tuple[str, str]] = {
    # Refusals
    "modes": ("The number of modes", "モードの数"),
    "structure": ("The structure", "建物の構造"),
    "of_linear": ("for a linear building", "線形の建物"),
    "period_of_isolated": (("The building's fixed-base period is {period:g} s; it must be below the "
                            "isolators', {isolators:g} s."),
                           ("基礎固定時の建物の固有周期が{period:g}秒です。"
                            "免震層の周期{isolators:g}秒より短くしてください。")),
    "isolation_too_damped": (("Isolation damping is {damping:g}; with post_yield {post_yield:g} it must "
                              "be below {most:.3f}."),
                             ("免震層の減衰定数が{damping:g}です。"
                              "降伏後の剛性比{post_yield:g}では{most:.3f}未満にしてください。")),
    "masses": ("The number of masses", "質点の数"),
    "period_too_short": (("The building's shortest period is {period:g} s; if it yields it must be at "
                          "least {least:.2g} s."),
                         ("建物の最も短い固有周期が{period:g}秒になっています。"
                          "降伏を考える場合は{least:.2g}秒以上にしてください。")),
}
