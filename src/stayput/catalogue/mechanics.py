"""Mechanics: force elements that the solver cannot take."""

TEXTS: dict[str, tuple[str, str]] = {
    "elements": ("force elements", "力要素"),
    "the_body": ("The body", "家具"),
    "element_value": ("Element {name}", "力要素の{name}"),
    "elements_need_coulomb": ("'coulomb' with measures of force elements", "力を伝える器具があれば'coulomb'"),
    # what an element's value must be
    "known_kind": ("1 (axial) or 2 (planar)", "1（軸方向）または2（平面）"),
    "finite": ("finite", "有限の数値"),
    "anchor": ("finite, or NaN for where the point is at rest", "有限の数値、または静止時の位置を表すNaN"),
    "not_negative": ("0 or more", "0以上"),
    "slack": ("a length, or inf", "長さ、またはinf"),
    "friction": ("0 or more, or NaN for none", "0以上、または摩擦なしを表すNaN"),
    "no_damping_without_stiffness": ("0 where there is no stiffness", "剛性がない場合は0"),
    "no_damping_with_friction": ("0 where the tangent slips by friction", "接線方向が摩擦ですべる場合は0"),
    "brittle_with_interaction": ("0 where pull and shear act together", "引張とせん断が連成する場合は0"),
    "axial_has_no_shear": ("0 for an axial one, which has no shear", "せん断のない軸方向要素では0"),
}
