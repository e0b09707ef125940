"""Standards beside the simulation: what their quantities are called."""

TEXTS: dict[str, tuple[str, str]] = {
    "height_ratio": ("Height z/h in the building", "建物内の高さの比z/h"),
    "edition": ("Edition of ASCE 7", "ASCE 7の版"),
    "lowest": ("Lowest frequency to be matched", "合わせる最低の振動数"),
    "storeys": ("Number of storeys", "建物の階数"),
    "storey": ("Storey", "階"),
    "position": ("Position in the building", "建物内の位置"),
    "grade": ("Class of the equipment", "耐震クラス"),
    "zone": ("Regional factor Z", "地域係数Z"),
    "coefficient": ("Horizontal coefficient K_H", "設計用水平震度K_H"),
    "spacing": ("Spacing of the anchors", "アンカーの間隔"),
    "anchors": ("Number of anchors", "アンカーの本数"),
    "lifted": (
        (
            "The peak vertical acceleration is {vertical:.3g} m/s²; it must be below {most:.3g} m/s², at which the "
            "method leaves no friction."
        ),
        (
            "鉛直方向の最大加速度が{vertical:.3g} m/s²です。この方法では{most:.3g} m/s²以上で摩擦がなくなるため、"
            "それより小さくしてください。"
        ),
    ),
    "friction": ("Friction coefficient", "摩擦係数"),
}
"""Texts by their keys: English, Japanese."""
