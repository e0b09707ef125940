"""What notebooks show beside pictures."""

TEXTS: dict[str, tuple[str, str]] = {
    "capacity": ("{percent:.0f} % fall at", "{percent:.0f}%が転倒する強さ"),
    "lognormal": ("lognormal", "対数正規分布"),
    "name": ("motion", "地震動"),
    "pga": ("PGA [m/s²]", "最大加速度 [m/s²]"),
    "pgv": ("PGV [cm/s]", "最大速度 [cm/s]"),
    "intensity": ("JMA intensity", "計測震度"),
    "duration": ("duration [s]", "継続時間 [s]"),
    "step": ("time step [s]", "時間刻み [s]"),
    "structure": ("structure", "構造"),
    "storeys": ("storeys", "階数"),
    "height": ("height [m]", "高さ [m]"),
    "periods": ("natural periods [s]", "固有周期 [s]"),
    "size": ("R [m]", "R [m]"),
    "slenderness": ("α [rad]", "α [rad]"),
    "frequency": ("p [rad/s]", "p [rad/s]"),
    "overturning": ("g tan α [m/s²]", "g tan α [m/s²]"),
    "friction": ("friction, static and kinetic", "摩擦係数（静止、動）"),
}
