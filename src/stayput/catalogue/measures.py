"""Measures: what they are, and why one cannot be put in place. Labels of parameters stand beside these."""

TEXTS: dict[str, tuple[str, str]] = {
    # What each is called; how it works and what makes it fail
    "against_wall": ("Moved against the wall", "壁に寄せる"),
    "against_wall_about": (("Against the wall the piece cannot rock back, which often keeps the rocking "
                            "from building up; it can still fall forwards."),
                           ("壁に寄せると後ろへ揺れないため揺れが大きくなりにくいが、"
                            "手前への転倒は防げない。")),
    "away_from_wall": ("Moved away from the wall", "壁から離す"),
    "away_from_wall_about": (("Away from the wall the piece does not bounce off it towards the room; "
                              "nothing limits its rocking then."),
                             "壁から離すと壁に当たってはね返ることはないが、揺れを止めるものもなくなる。"),
    "ballast": ("Ballast at the bottom", "底部のおもり"),
    "ballast_about": (("Extra mass near the base lowers the centre of gravity, so that it takes more to "
                       "tip the piece; it ties nothing down, and strong shaking tips it all the same."),
                      ("底近くにおもりを足して重心を下げ、倒れにくくするが、"
                       "固定するわけではないので強い揺れでは倒れる。")),
    "lower_shelves": ("Heavy things on the lower shelves", "重い物を下段に収納"),
    "lower_shelves_about": (("Heavy things moved from the upper half to the lower one lower the centre of "
                             "gravity; it costs nothing, and holds nothing once the piece is lifted off "
                             "its edge far enough."),
                            ("重い物を上段から下段へ移して重心を下げるもので、費用はかからないが、"
                             "固定の代わりにはならない。")),
    "l_bracket": ("Screwed L-brackets", "L型金具（ねじ留め）"),
    "l_bracket_about": (("Brackets screwed to the top and to the wall tie the piece to it; they fail "
                         "where the screws are drawn out, sooner with the bracket below the edge and its "
                         "screws pointing up."),
                        ("家具の上部と壁をL型金具でねじ留めするが、ねじが引き抜けると効かなくなり、"
                         "上向きの取付けは弱い。")),
    "l_bracket_board": ("L-brackets in gypsum board", "L型金具（石こうボードに固定）"),
    "l_bracket_board_about": (("Brackets on anchors in gypsum board look the same as those in studs, but "
                               "each holds a pull of only about 300 N and then comes out of the board "
                               "without warning."),
                              ("下地のない石こうボードに留めたL型金具は、"
                               "見た目は同じでも1個あたり約300 Nの引張りにしか耐えず、"
                               "超えると前触れなく抜ける。")),
    "belt": ("Belts", "ベルト式"),
    "belt_about": (("Belts to the wall stop the piece once they are taut; they act only in tension, and a "
                    "jerk after slack may tear them or their anchors."),
                   ("壁とつないだベルトが張ると転倒を止めるが、引張りにしか効かず、"
                    "たるみがあると急な力で破損または脱落することがある。")),
    "chain": ("Chains", "チェーン式"),
    "chain_about": (("Chains to the wall stop the piece once they are taut; they are usually slack, and "
                     "the jerk bends their hooks open or tears their screws out."),
                    ("壁とつないだチェーンが張ると転倒を止めるが、たるみやすく、"
                     "急な力でフックが伸びたりねじが抜けたりする。")),
    "anti_slip_sheet": ("Anti-slip sheet", "滑り止めシート"),
    "anti_slip_sheet_about": (("Rubber under the base keeps the piece from sliding; it does not keep it "
                               "from tipping, and a tall piece that can no longer slide may tip sooner."),
                              ("底面のゴムで滑りを防ぐが、転倒は防げず、"
                               "背の高い家具では滑れないぶん早く倒れることがある。")),
    "felt_glides": ("Felt glides", "フェルトパッド"),
    "felt_glides_about": (("Felt under the base lets the piece slide before it tips; it then wanders and "
                           "may hit what stands near."),
                          ("底面のフェルトで滑りやすくして転倒を避けるが、家具が移動し、"
                           "周囲の物にぶつかることがある。")),
    "sliding_glides": ("Sliding glides (PTFE)", "すべりパッド（フッ素樹脂）"),
    "sliding_glides_about": (("PTFE under the base lets the piece slide at a small force, so that it does "
                              "not tip; it travels far and may hit what stands near."),
                             ("底面のフッ素樹脂で小さな力でも滑らせて転倒を避けるが、大きく移動し、"
                              "周囲の物にぶつかることがある。")),
    "free_casters": ("Casters, free", "キャスター（ロックなし）"),
    "free_casters_about": (("Rolling casters hardly pass the shaking on, so the piece does not tip; it "
                            "rolls far and hits what stands near."),
                           ("キャスターが転がって揺れが伝わりにくく倒れにくいが、大きく動き回り、"
                            "周囲の物に衝突する。")),
    "locked_casters": ("Casters, locked", "キャスター（ロックあり）"),
    "locked_casters_about": (("Locked casters that hold slide like feet; in shake-table tests of hospital "
                              "equipment, locking did not always lessen how far it moved, and a piece "
                              "that tips under shaking tips on them too."),
                             ("ロックが効けば転がらず脚のように滑るだけになるが、"
                              "医療機器の振動台実験では移動量が必ずしも減らず、"
                              "強い揺れでの転倒も防げない。")),
    "base_isolator": ("Furniture base isolator", "家具用免震装置"),
    "base_isolator_about": (("The piece stands on a tray that slides easily, so that little shaking "
                             "reaches it, and slides within its stroke do not count; where the floor "
                             "moves more than that, the stops hit and may tip it."),
                            ("滑りやすい台に載せて揺れを伝えにくくする。"
                             "可動範囲内の滑りは移動に数えないが、"
                             "床の動きがこれを超えるとストッパーに当たり、倒れることがある。")),
    "gel_mats": ("Adhesive gel mats", "耐震ゲルマット（粘着マット式）"),
    "gel_mats_about": (("Sticky gel under the corners holds the base down and sideways; it tears off for "
                        "good where pull and shear together exceed its bond, which dust, rough floors and "
                        "age weaken."),
                       ("四隅の粘着ゲルで底面を床に留めるが、"
                        "引きはがす力とずれの力が粘着力を超えるとはがれて元に戻らず、ほこりや凹凸、"
                        "劣化で弱くなる。")),
    "wedge_stopper": ("Wedge stopper", "ストッパー式（くさび）"),
    "wedge_stopper_about": (("A rubber wedge under the front edge leans the piece back towards the wall; "
                             "it only shifts the balance by about a degree, so strong shaking tips the "
                             "piece all the same."),
                            ("前下部にくさび状のゴムを挟んで家具を壁側へわずかに傾けるが、"
                             "傾きは1度ほどなので強い揺れでは倒れる。")),
    "tension_pole": ("Tension poles", "ポール式（突っ張り棒）"),
    "tension_pole_about": (("Poles jammed against the ceiling press the piece down; they drop out when "
                            "the ceiling gives way, the top moves away from it, or they lean too far."),
                           ("天井との間に突っ張って家具を押さえるが、天井が弱くてへこんだり、"
                            "上部が離れて緩んだり、傾いたりすると脱落する。")),
    # Refusals
    "own_class": (("{name} has no kind or no label; a measure's kind must be a text, its label two: "
                   "English and Japanese."),
                  ("自作の対策{name}に、種類（kind）または名称（label）がありません。kindは文字列、"
                   "labelは英語と日本語の2つの文字列にしてください。")),
    "twice": ("{measure} is given twice, both {place}; only one of them can be there.",
              "「{measure}」が2回指定されています。同じ場所（{place}）に使えるのは1つだけです。"),
    "same_place": ("{first} and {second} are given together, both {place}; only one of them can be there.",
                   ("「{first}」と「{second}」は同じ場所（{place}）に取り付けるため、"
                    "どちらか1つしか使えません。")),
    "room_of_several": (("{measure} cannot be given to one piece of several; say where it stands by its "
                         "place (at) instead."),
                        ("「{measure}」は複数の家具のうちの1つには使えません。"
                         "位置（at）で置き場所を指定してください。")),
    "base_on_another": (("{measure} belong on the floor, and the piece stands {height:g} m above it; join "
                         "it to the one below."),
                        ("「{measure}」は床に使うものですが、家具は床から{height:g} mの高さにあります。"
                         "下の家具と接合してください。")),
    # Places that a measure takes up
    "under_base": ("under the base", "底面の下"),
    "on_wall": ("on the wall at {height:g} times the height", "家具の高さの{height:g}倍の位置の壁"),
    "at_distance": ("at a distance from the wall", "壁から離した位置"),
    "tied": ("tied to the wall at {height:g} times the height", "家具の高さの{height:g}倍の位置と壁との間"),
    "on_top": ("on the top, {setback:g} m from the back", "天板の上、背面から{setback:g} mの位置"),
    "on_shelves": ("on the shelves", "棚の上"),
    # What to buy
    "mats_to_buy": ("{product} of {side:.1f} × {side:.1f} cm, for furniture of {mass:.0f} kg",
             "{product}（{side:.1f}×{side:.1f} cm、{mass:.0f} kgの家具に対応するもの）"),
    "wedge_to_buy": ("{product}, {length:.2f} m long and {thickness:.0f} mm thick",
              "{product}（長さ{length:.2f} m、厚さ{thickness:.0f} mm）"),
    "ballast_to_buy": ("{product}, {mass:g} kg", "{product}（{mass:g} kg）"),
    # Where it goes on a piece
    "at_wall": ("on the wall {height:.2f} m above the floor, {apart}{studs}",
                "壁の床から{height:.2f} mの高さ、{apart}{studs}"),
    "on_studs": (", on studs every {pitch:.0f} mm", "、下地（間隔{pitch:.0f} mmの場合）の所"),
    "on_one_stud": (", on a stud: the piece is too narrow for two studs",
                    "、下地のある所（幅が狭く、2本の下地には届きません）"),
    "on_a_strip": ((", more than there are studs behind it: on a strip of wood that is screwed across the "
                    "studs"),
                   "、下地の数より多いので、下地に渡してねじで留めた横木の所"),
    "apart": ("{apart:.3g} m apart ({edge:.3g} m from its sides)",
              "間隔{apart:.3g} m（側面から{edge:.3g} m）"),
    "in_the_middle": ("in the middle of the piece", "家具の中央"),
    "tied_top": (("on top of the piece {setback:.2f} m from its back, up to the wall {height:.2f} m above "
                  "the floor, {apart}{studs}, tight"),
                 ("家具の天板の背面から{setback:.2f} mの所から、壁の床から{height:.2f} mの高さへ、"
                  "{apart}{studs}、たるませない")),
    "pole_top": (("on top of the piece {setback:.2f} m from its back, {apart}, {length:.2f} m long, under "
                  "a ceiling joist"),
                 "家具の天板の背面から{setback:.2f} mの所、{apart}、長さ{length:.2f} m、天井の野縁の下"),
    "under_corners": ("under the four corners", "底面の四隅"),
    "under_front": ("under the whole front edge", "前面の下端の全長"),
    "in_bottom": ("at the bottom, its centre {height:.2f} m above the base",
                  "家具の下部、中心の高さは底面から{height:.2f} m"),
    "shelves_down": ("{mass:.0f} kg from the shelves of the upper half to those of the lower half",
                     "上半分の棚から下半分の棚へ{mass:.0f} kg"),
    # What to look at first
    "check_stud": (("find the studs by tapping or with a stud finder (usually every {near:.0f} or "
                    "{far:.0f} mm); the screws must go {depth:.0f} mm into them"),
                   ("下地センサーなどで下地（間柱）を探す（間隔は{near:.0f} mmか{far:.0f} mmが多い）。"
                    "ねじは下地に{depth:.0f} mm以上入れる")),
    "check_plasterboard": (("plasterboard alone holds little: use anchors made for it, or find a stud "
                            "after all"),
                           "石こうボードだけでは弱い。専用アンカーを使うか、下地を探し直す"),
    "check_concrete": ("drill with a masonry bit and use plugs; ask before drilling in a flat",
                       "コンクリート用ドリルとプラグを使う。集合住宅では管理規約を確かめる"),
    "check_hanging strip": ("the strip must be nailed to the posts, and not only glued on",
                            "付け鴨居・長押が柱に釘で留まっていることを確かめる"),
    "check_top": ("the top board must be wood or particle board that takes a screw",
                  "天板がねじの効く木材またはパーティクルボードであることを確かめる"),
    "check_ceiling": (("push the ceiling up by hand: it must not give; put a board across the joists if "
                       "it does"),
                      "天井を手で押し、動かないことを確かめる。動く場合は野縁をまたぐ当て板を入れる"),
    "check_clean": ("the floor must be hard, even and free of dust and wax",
                    "床が硬く平らで、ほこりやワックスがないことを確かめる"),
    "check_hard": ("the floor must be hard", "床が硬いことを確かめる"),
    # What gives way; the links of a chain say it beside their numbers
    "as_given": ("they reach the strength that is given for them", "指定された強さに達する"),
    "mats_peel": ("the mats peel off", "マットがはがれる"),
    "mats_shear": ("the mats shear off", "マットがずれてはがれる"),
    "drops_out": ("the poles lose their hold and drop out", "ポールが緩んで外れる"),
    # How a measure is often installed
    "beside_the_studs": ("screws beside the studs, in plasterboard",
                         "ねじが下地を外れて石こうボードだけに留まる"),
    "hangs_loose": ("hangs loose", "たるませたまま取り付ける"),
    "hardly_tightened": ("hardly tightened", "締付けが足りない"),
    "on_dust": ("on dust or an uneven floor", "ほこりや凹凸のある床に貼る"),
    "too_short": ("too short, with its thin part under the edge", "短く、薄い部分だけが挟まる"),
    # Why a measure may not do much here
    "in_plasterboard": (("{measure} are fixed to plasterboard alone, which holds less than a stud and "
                         "lets go without warning; look for the studs"),
                        ("「{measure}」を下地のない石こうボードに留めています。下地より弱く、"
                         "前触れなく抜けるので、下地を探してください")),
    "pole_on_board": (("{measure} push against plasterboard between the joists, which they break; put a "
                       "board between, or move them under a joist"),
                      ("「{measure}」が野縁のない石こうボードを押しています。突き破るので、"
                       "当て板をするか野縁の下に移してください")),
    "pole_long": ("{measure} are longer than {most:g} m and lean at a small force",
                  "「{measure}」が{most:g} mより長く、小さな力で傾きます"),
    "glides_stick": (("“{measure}” slides like this on hard floors; on a soft one it sinks in and slides "
                      "less easily"),
                     ("「{measure}」のすべりやすさは硬い床での値です。柔らかい床では沈み込み、"
                      "滑りにくくなります")),
    "locks_slip": (("“{measure}” may roll or slip all the same: in shake-table tests locking did not "
                    "always lessen how far equipment moved"),
                   ("「{measure}」はロックしても転がったり滑ったりすることがあります（振動台実験では、"
                    "ロックしても移動量が必ずしも減っていません）")),
    "rubber_slips": (("“{measure}” grips like this on hard, clean floors; on a soft one it slips with the "
                      "pile or the weave"),
                     ("「{measure}」の摩擦は硬くきれいな床での値です。"
                      "柔らかい床では毛足や畳の目に沿って滑ります")),
    "wedge_sinks": ("“{measure}” sinks into a soft floor, and leans the piece less",
                    "「{measure}」は柔らかい床では沈み込み、傾きが小さくなります"),
    "wedge_squat": (("{measure}: on its own base this piece slides before it tips (width/height "
                     "{slender:.2f}, friction {friction:.2f}); the rubber stops the sliding and may tip it"),
                    ("「{measure}」なしでは転倒する前に滑る家具です（奥行き／高さ{slender:.2f}、"
                     "摩擦{friction:.2f}）。ゴムで滑りが止まり、かえって転倒することがあります")),
    # Measures whose numbers do not go with the piece, the room or each other
    "no_wall": ("There is no wall behind the piece; for “{measure}” the room must have a left_wall.",
                "「{measure}」には背面の壁が必要です。"),
    "gap_for": ("The gap to the wall for “{measure}”", "「{measure}」のための家具と壁のすき間"),
    "no_ceiling": ("{measure} need a ceiling; the room must have one, or ceiling_height be given.",
                   "「{measure}」には天井が必要です。天井の高さを指定してください。"),
    "dropped_ceiling": (("{measure} need a ceiling that bears them; a dropped ceiling lifts. Give "
                         "strength if it is known."),
                        ("「{measure}」には力に耐える天井が必要です。吊り天井は持ち上がります。"
                         "強さが分かる場合は指定してください。")),
    "does_not_stick": ("{measure} do not stick to carpet or tatami; the floor must be hard and smooth.",
                       "「{measure}」はカーペットや畳には粘着しません。硬く平らな床で使ってください。"),
    "anchor": (("“{measure}” angle is {angle:.3g} rad, which puts its anchor at {height:.3g} m; it must "
                "be between floor and ceiling."),
               ("「{measure}」の壁側の取付け位置が高さ{height:.3g} mになります。"
                "床と天井の間になる角度にしてください。")),
    "preload": (("“{measure}” preload is {preload:g} N; it must be below the ceiling's strength, "
                 "{strength:g} N."),
                ("「{measure}」の突っ張り力は{preload:g} Nです。"
                 "天井の強さ（{strength:g} N）より小さくしてください。")),
    "space_for": ("The space below the ceiling for “{measure}”", "「{measure}」のための天井までの空き"),
    "upper_half": ("no more than the upper half of this piece holds", "家具の上半分にある分以下"),
    "kinetic_friction": ("The kinetic friction of “{measure}”", "「{measure}」の動摩擦係数"),
}
