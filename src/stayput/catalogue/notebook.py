"""What notebooks show beside pictures."""

TEXTS: dict[str, tuple[str, str]] = {
    "capacity": ("{percent:.0f} % fall at", "{percent:.0f}%が転倒する強さ"),
    "name": ("motion", "地震動"),
    "intensity": ("JMA intensity", "計測震度"),
    "duration": ("duration [s]", "継続時間 [s]"),
    "step": ("time step [s]", "時間刻み [s]"),
    "structure": ("structure", "構造"),
    "storeys": ("storeys", "階数"),
    "height": ("height [m]", "高さ [m]"),
    "periods": ("natural periods [s]", "固有周期 [s]"),
    "friction": ("friction, static and kinetic", "摩擦係数（静止、動）"),
}
