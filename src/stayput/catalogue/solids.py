"""Bodies in space, and the meshes that they are read from."""

TEXTS: dict[str, tuple[str, str]] = {
    # What numbers are called
    "width": ("Width", "奥行き"),
    "length": ("Length", "幅"),
    "height": ("Height", "高さ"),
    "diameter": ("Diameter", "直径"),
    "bottom": ("Bottom diameter", "下端の直径"),
    "top": ("Top diameter", "上端の直径"),
    "mass": ("Mass", "質量"),
    "density": ("Density", "密度"),
    "vertices": ("the vertices", "頂点（vertices）"),
    "feet": ("the feet", "脚（feet）"),
    "number_of_feet": ("The number of feet", "脚の数"),
    "rims": ("the rims", "縁の円（rims）"),
    "centre_of_gravity": ("the centre of gravity", "重心（centre_of_gravity）"),
    "inertia": ("the inertia", "慣性テンソル（inertia）"),
    "up": ("The direction up", "上の向き（up）"),
    "unit": ("The unit", "単位（unit）"),
    # Shapes
    "not_finite": (("One of the numbers of {name} is NaN or too large; all must be finite and at most "
                    "{largest:g}."),
                   ("{name}にNaNか大きすぎる数値が含まれています。"
                    "すべて{largest:g}以下の有限の数値にしてください。")),
    "flat": ("The points lie in a plane, or nearly so; a body must have a volume.",
             "すべての点がほぼ1つの平面上にあります。体積のある形にしてください。"),
    "size": ("The body is {extents} m; each side must be between {low:g} and {high:g} m{hint}.",
             "大きさが{extents} mになっています。各辺を{low:g}～{high:g} mにしてください{hint}。"),
    "corners": ("corners", "頂点"),
    "is_the_unit": (" (is the unit {unit!r}?)", "（単位は{unit!r}ではありませんか）"),
    "not_convex": (("The shape fills {share:.4g} of its convex hull; it must be convex and fill at least "
                    "{least:g}."),
                   "形の体積が凸包の{share:.4g}倍しかありません。凸形状（{least:g}倍以上）にしてください。"),
    "foot_astray": (("A foot is at {point} m; feet must be below the middle of the body, and no more than "
                     "{reach:.3g} m beyond its sides."),
                    ("脚の位置が{point} mになっています。脚は立体の中ほどより下で、"
                     "側面から{reach:.3g} m以内にしてください。")),
    "rims_wrong": ("The rims must each have an axis of length 1 and a radius above 0 m.",
                   "縁の円（rims）の軸は長さ1、半径は0 mより大きくしてください。"),
    # Mass
    "cg_outside": (("The centre of gravity {point} m lies {depth:.3g} m outside the body; it must lie "
                    "inside."),
                   "重心{point} mが形の外側に{depth:.3g} m出ています。内側にしてください。"),
    "inertia_not_symmetric": (("The inertia is not symmetric: two entries across the diagonal differ by "
                               "{difference:.3g} kg m²."),
                              ("慣性テンソルが対称ではありません（対角線を挟む成分の差{difference:.3g} kg "
                               "m²）。対称にしてください。")),
    "moments": ("The principal moments of inertia", "主慣性モーメント"),
    "possible_moments": ("positive, and each at most the sum of the others",
                         "どれも正で、ほかの2つの和以下の値"),
    "usual_moments": ("between {low:.3g} and {high:.3g} kg m² for this body",
                      "この形では{low:.3g}～{high:.3g} kg m²の値"),
    "mass_or_density": ("A mesh needs either a mass [kg] or a density [kg/m³]; give one of them.",
                        ("メッシュには質量（mass）[kg] か密度（density）[kg/m³] のどちらか一方だけを指定し"
                         "てください。")),
    "no_length": ("the size across the shaking [m], for space", "揺れに直角な方向の寸法 [m] "),
    # Mesh files
    "mesh_empty": ("a file with a closed surface of triangles", "三角形の閉じた表面のあるファイル"),
    "mesh_file": ("The mesh file", "メッシュのファイル"),
    "mesh_unreadable": ("No triangles can be read from {file}; it must be a mesh in the format {format}.",
                        "ファイル{file}から三角形を読めません。{format}形式のメッシュを指定してください。"),
    "mesh_open": (("The mesh has edges that do not join exactly two triangles ({count}); it must be "
                   "closed, without holes."),
                  ("ちょうど2つの三角形をつないでいない辺がメッシュに{count}本あります。"
                   "穴のない閉じた表面にしてください。")),
    "mesh_inside_out": ("The triangles of the mesh, or some of them, face inwards; all must face outwards.",
                        "メッシュの三角形の全部または一部が内側を向いています。すべて外側に向けてください。"),
}
