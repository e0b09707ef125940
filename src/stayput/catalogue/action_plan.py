"""The plan to buy and do: what stands on the card, from its top to its foot."""

TEXTS: dict[str, tuple[str, str]] = {
    # Head
    "title": ("Plan to buy and do", "買うもの・することの計画"),
    "now": (
        "In shaking of JMA intensity {strength}, as the room is: {chances}.",
        "{strength}の揺れで、今の部屋では{chances}。",
    ),
    "then": (
        "With steps 1 to {last} together: {chances}.",
        "1～{last}をすべて行うと、{chances}。",
    ),
    "then_one": ("With step 1: {chances}.", "1を行うと、{chances}。"),
    "chance_hit": ("somebody is hit in {share} of the earthquakes", "人に家具が当たる確率は{share}です"),
    "chance_shut_in": ("somebody is shut in after {share}", "外に出られない確率は{share}です"),
    "chance_blocked": ("a door is blocked after {share}", "ドアがふさがる確率は{share}です"),
    "nothing": (
        "In these earthquakes no piece hits anybody or blocks a door: nothing has to be bought.",
        "この地震では、家具が人に当たることもドアをふさぐこともありません。買うものはありません。",
    ),
    "unsolved": (
        "Nothing that may be done here was found to help with: {pieces}.",
        "この条件では、効果のある対策が見つからなかった家具：{pieces}。",
    ),
    "rough": (
        (
            "Steps marked C rest on assumed values: their order is more certain than their chances. Put your own "
            "measurements in the room and plan again before you buy."
        ),
        (
            "Cの項目は仮定した値に基づきます。確率の値よりも順位のほうが確かです。買う前に、実際に測った値を入れて"
            "計画し直してください。"
        ),
    ),
    "home": ("Planned for: {conditions}", "計画の条件：{conditions}"),
    "no_drilling": ("no drilling", "壁に穴を開けない"),
    "tatami": ("tatami floor", "畳の床"),
    "plasterboard": (
        "walls of plasterboard without studs to screw to",
        "ねじを留める下地のない石こうボードの壁",
    ),
    "dropped_ceiling": ("a ceiling that hangs on wires", "吊り天井"),
    # The plan and the elevations
    "scale": (
        "Plan 1:{plan}, elevations 1:{elevation} on paper of size A4 at 100 %; lengths in metres.",
        "平面図1:{plan}、立面図1:{elevation}（等倍で印刷した場合）。長さの単位はメートル。",
    ),
    "elevation_alt": (
        "{piece} from the front and from the side, to scale",
        "「{piece}」の正面図と側面図（縮尺どおり）",
    ),
    "front": ("front", "正面"),
    "side": ("side", "側面"),
    # Columns
    "rank": ("Order", "順位"),
    "what": ("What to do", "すること"),
    "drawing": ("Drawing", "図"),
    # What a step is
    "fix": ("{piece}: {products}", "{piece}：{products}"),
    "product": ("{measure} × {count}", "{measure}×{count}"),
    "buy": ("Buy", "買うもの"),
    "where": ("Where", "取付け位置"),
    "check": ("Check before you buy", "買う前に確かめること"),
    "effect": ("Effect", "効果"),
    "instead": ("Without drilling", "穴を開けない場合"),
    "caution": ("Caution", "注意"),
    "free": ("free", "無料"),
    "cost": ("cost class {level} of 3", "費用の目安 3段階の{level}"),
    # What to buy
    "rated": ("{product}, each rated for {forces} or more", "{product}（1個あたり{forces}以上のもの）"),
    "pull": ("a pull of {force}", "引張り{force}"),
    "push": ("a push of {force}", "押し{force}"),
    "shear": ("a sideways force of {force}", "横向きの力{force}"),
    "and": (" and ", "、"),
    "plus": (" + ", "＋"),
    "next": ("; ", "。"),
    "newtons": ("{newtons:,.0f} N ({kilograms:.0f} kgf)", "{newtons:,.0f} N（{kilograms:.0f} kgf）"),
    "mats": (
        "{product} of {side:.1f} × {side:.1f} cm, for furniture of {mass:.0f} kg",
        "{product}（{side:.1f}×{side:.1f} cm、{mass:.0f} kgの家具に対応するもの）",
    ),
    "wedge": (
        "{product}, {length:.2f} m long and {thickness:.0f} mm thick",
        "{product}（長さ{length:.2f} m、厚さ{thickness:.0f} mm）",
    ),
    "not_enough": (
        "{measure}: as computed one holds about {holds} ({fails}), less than asked for",
        "{measure}：計算上1か所の強さは約{holds}（{fails}）で、必要な強さに足りない",
    ),
    # Where it goes
    "at_wall": (
        "on the wall {height:.2f} m above the floor, {apart}, each on a stud",
        "壁の床から{height:.2f} mの高さ、{apart}、それぞれ下地のある所",
    ),
    "at_wall_plain": (
        "on the wall {height:.2f} m above the floor, {apart}",
        "壁の床から{height:.2f} mの高さ、{apart}",
    ),
    "apart": (
        "{apart:.2f} m apart ({edge:.2f} m from its sides)",
        "間隔{apart:.2f} m（側面から{edge:.2f} m）",
    ),
    "in_the_middle": ("in the middle of the piece", "家具の中央"),
    "belt_top": (
        (
            "on top of the piece {setback:.2f} m from its back, up to the wall {height:.2f} m above the floor, "
            "{apart}, tight"
        ),
        "家具の天板の背面から{setback:.2f} mの所から、壁の床から{height:.2f} mの高さへ、{apart}、たるませない",
    ),
    "pole_top": (
        "on top of the piece {setback:.2f} m from its back, {apart}, {length:.2f} m long, under a ceiling joist",
        "家具の天板の背面から{setback:.2f} mの所、{apart}、長さ{length:.2f} m、天井の野縁の下",
    ),
    "mats_below": ("under the four corners", "底面の四隅"),
    "wedge_below": ("under the whole front edge", "前面の下端の全長"),
    # What to check
    "check_stud": (
        (
            "find the studs by tapping or with a stud finder (usually every {near:.0f} or {far:.0f} mm); the screws "
            "must go {depth:.0f} mm into them"
        ),
        (
            "下地センサーなどで下地（間柱）を探す（間隔は{near:.0f} mmか{far:.0f} mmが多い）。ねじは下地に{depth:.0f} "
            "mm以上入れる"
        ),
    ),
    "check_board": (
        "plasterboard alone holds little: use anchors made for it, or find a stud after all",
        "石こうボードだけでは弱い。専用アンカーを使うか、下地を探し直す",
    ),
    "check_concrete": (
        "drill with a masonry bit and use plugs; ask before drilling in a flat",
        "コンクリート用ドリルとプラグを使う。集合住宅では管理規約を確かめる",
    ),
    "check_strip": (
        "the strip must be nailed to the posts, and not only glued on",
        "付け鴨居・長押が柱に釘で留まっていることを確かめる",
    ),
    "check_top": (
        "the top board must be wood or particle board that takes a screw",
        "天板がねじの効く木材またはパーティクルボードであることを確かめる",
    ),
    "check_ceiling": (
        "push the ceiling up by hand: it must not give; put a board across the joists if it does",
        "天井を手で押し、動かないことを確かめる。動く場合は野縁をまたぐ当て板を入れる",
    ),
    "check_floor": (
        "the floor must be hard, even and free of dust and wax",
        "床が硬く平らで、ほこりやワックスがないことを確かめる",
    ),
    "check_hard": ("the floor must be hard", "床が硬いことを確かめる"),
    "check_move": (
        "empty it first; measure the new place; keep sockets and doors free",
        "中身を出してから動かす。移動先の寸法を測り、コンセントとドアをふさがない",
    ),
    "check_move_place": (
        "measure the new place; keep sockets and doors free",
        "移動先の寸法を測り、コンセントとドアをふさがない",
    ),
    # Effects
    "overturns": ("overturns {was} → {now}", "転倒{was}→{now}"),
    "alone": ("alone: {chance}", "これだけの場合：{chance}"),
    "with_others": ("with the steps above: {chance}", "上の項目と合わせて：{chance}"),
    "hit": ("hit {was} → {now}", "人に当たる{was}→{now}"),
    "shut_in": ("shut in {was} → {now}", "出られない{was}→{now}"),
    "blocked": ("door blocked {was} → {now}", "ドアがふさがる{was}→{now}"),
    "alone_unclear": ("alone: {chance}, not clear", "これだけの場合：{chance}、明らかではない"),
    # Marks
    "mark": ("How well this is known: {grade}", "根拠の確かさ：{grade}"),
    "weakest": ("Least well known here: {inputs}.", "この項目で最も不確かな入力：{inputs}。"),
    "weakest_of": ("Least well known", "最も不確かな入力"),
    # Foot
    "grades": ("Marks: {meanings}.", "記号：{meanings}。"),
    "grade": ("{grade}: {meaning}", "{grade}：{meaning}"),
    "strengths": (
        (
            "Strengths: force on one device that {share:.0f} % of {runs} runs do not exceed, found with one that "
            "cannot fail, times {margin:.1f}. The margin is from a product of median strength to the weakest 5 % "
            "of its kind, for the scatter that is assumed (coefficient of variation {cov:.1f})."
        ),
        (
            "強さ：壊れない器具で計算した1個あたりの力のうち、{runs}回の計算の{share:.0f}%が超えない値に{margin:.1f}を"
            "掛けたもの。この余裕は、仮定したばらつき（変動係数{cov:.1f}）で弱いほうから5%の製品でも耐えるための倍率です。"
        ),
    ),
    "costs": (
        (
            "Cost classes are conventions, not prices: 1 up to ¥{low:,} or €{low_euro}, 2 up to ¥{high:,} or "
            "€{high_euro}, 3 above, for one piece."
        ),
        "費用の目安は取り決めで、実際の価格ではありません：家具1台につき1は{low:,}円まで、2は{high:,}円まで、3はそれ以上。",
    ),
    "unclear": (
        "Not clear: the difference that a step makes alone may be chance, or another piece does the same harm.",
        "明らかではない：その項目だけの差は、偶然か、ほかの家具が同じ害を及ぼすためかもしれません。",
    ),
    "runs": (
        (
            "Shares with 95 % intervals, from {runs} runs of the room under the same {motions} earthquakes "
            "(seed {seed}), without and with each step. stayput {version}."
        ),
        (
            "割合と95%信頼区間は、同じ{motions}本の地震動で部屋を{runs}回計算し（シード{seed}）、各項目の前後を比べたもの。"
            "バージョン{version}。"
        ),
    ),
    "limits": (
        (
            "A calculation of stated furniture in stated earthquakes: no guarantee, and no replacement for the "
            "makers' instructions."
        ),
        "指定した家具と地震動についての計算です。安全を保証するものではなく、製品の説明書に代わるものでもありません。",
    ),
}
"""Texts by their keys: English, Japanese."""
