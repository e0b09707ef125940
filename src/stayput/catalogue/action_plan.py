"""The plan to buy and do: what stands on the card, from its top to its foot."""

TEXTS: dict[str, tuple[str, str]] = {
    # Head
    "title": ("Plan to buy and do", "買う物とやること"),
    "print": ("Print", "印刷"),
    "back": ("Back to the room", "部屋に戻る"),
    "now": ("Chances {shaking}, as the room is: {chances}.", "{shaking}では、今の部屋だと{chances}です。"),
    "shaking": ("in shaking of JMA intensity {strength}", "{strength}の揺れ"),
    "shaking_of_one": ("under {motion}, of JMA intensity {strength}", "{motion}（{strength}の揺れ）"),
    "then": ("Chances after all {last} steps: {chances}.", "1～{last}をすべて行うと、{chances}です。"),
    "then_one": ("Chances after step 1: {chances}.", "1を行うと、{chances}です。"),
    "meets": (("Then {first} and {second} strike each other in {fell} of {runs} runs; what they do to each "
               "other is not followed."),
              "その場合、計算{runs}回中{fell}回、{first}と{second}がぶつかります。互いに及ぼす影響は計算していません。"),
    "chance": ("{share} that {what}", "{what}確率は{share}"),
    "falls": ("Chance of overturning: {pieces}.", "倒れる確率：{pieces}。"),
    "piece_falls": ("{piece} {was}", "「{piece}」{was}"),
    "piece_falls_then": ("{piece} {was} → {now}", "「{piece}」{was}→{now}"),
    "only_falls": ("it falls less; no other clear difference in these runs",
                   "倒れにくくなりますが、計算した範囲では、ほかに明らかな差はありません"),
    "no_gain": ("no clear difference in these runs", "計算した範囲では、明らかな差はありません"),
    "decided": ("your choice", "決めた変更"),
    "nothing": ("In the runs no piece did harm or overturned often: nothing has to be bought.",
                "計算では、家具が被害を与えることも、何度も倒れることもありませんでした。買う物はありません。"),
    "in_place": ("Taken as in place already: {measures}.", "取り付け済みとした対策：{measures}。"),
    "unsolved": ("Nothing that was tried helps with: {pieces}.",
                 "試した対策では効果がなかった家具：{pieces}。"),
    "rough": (("Steps marked C rest on assumed values: trust their order more than their chances. Before "
               "you buy, measure or look up these inputs, enter them in the room, and make this plan "
               "again."),
              ("Cの印がある項目は、仮定した値に基づきます。確率の値よりも、順位のほうが確かです。"
               "買う前に、次の値を測るか調べて部屋に入力し、作り直してください。")),
    "home": ("Conditions: {conditions}.", "条件：{conditions}。"),
    "no_drilling": ("no drilling", "壁に穴を開けない"),
    "tatami": ("tatami floor", "畳の床"),
    "plasterboard": ("walls of plasterboard without studs", "ねじを留める下地のない石こうボードの壁"),
    "dropped_ceiling": ("a ceiling that hangs on wires", "吊り天井"),
    # The plan and the elevations
    "scale": ("Plan 1:{plan}{elevations} when printed at 100 %; lengths in metres.",
              "平面図1:{plan}{elevations}（等倍で印刷した場合）。長さの単位はメートルです。"),
    "elevations": (", elevations 1:{scale}", "、立面図1:{scale}"),
    "elevation_alt": ("{piece} from front and side, to scale", "「{piece}」の正面図と側面図（縮尺どおり）"),
    "front": ("front", "正面"),
    "side": ("side", "側面"),
    # Columns
    "rank": ("Order", "順位"),
    "what": ("What to do", "やること"),
    "drawing": ("Drawing", "図"),
    # What a step is
    "product": ("{measure} × {count}", "{measure}×{count}"),
    "buy": ("Buy", "買う物"),
    "where": ("Where", "取付け位置"),
    "check": ("Check before you buy or move anything", "買う前・動かす前に確かめること"),
    "steps_instead": ("{steps} without drilling:", "{steps}（穴を開けない場合）"),
    "effect": ("Effect", "効果"),
    "instead": ("Without drilling", "穴を開けない場合"),
    "drilled": ("If drilling is allowed", "壁に穴を開けてよい場合"),
    "drilled_on": ("If drilling is allowed: {piece}", "「{piece}」を壁にねじで留めてよい場合"),
    "reaches": ("Effect anyway", "それでも見込める効果"),
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
    # What is not strong enough
    "weak": ("Too weak for JMA intensity {strength}: {in_runs}.",
             "{strength}の揺れには弱すぎます（{in_runs}）。"),
    "no_reserve": ("No reserve for JMA intensity {strength}: {in_runs}.",
                   "{strength}の揺れに対して余裕がありません（{in_runs}）。"),
    "in_runs": ("it gives way in {fails} of the runs, and the piece overturns in {share}",
                "器具が壊れるか外れる計算は{fails}、家具が倒れる計算は{share}"),
    "weak_bears": ("{measure}: each needs {needed}, holds about {holds} ({fails})",
                   "{measure}：1個あたり{needed}必要なところ、約{holds}（{fails}）"),
    "not_enough": ("Not enough for {pieces}: what else you can do",
                   "強さや効果が足りない家具（{pieces}）に、ほかにできること"),
    "more_runs": (("Where there is no clear difference, the runs may be too few to show one: verify the room "
                   "with more of them."),
                  ("明らかな差がない場合は、計算の回数が足りないことがあります。"
                   "回数を増やして確かめてください。")),
    "ask_landlord": (("Ask the landlord, before you buy, whether furniture may be screwed to the studs of "
                      "the wall. In Japan the Ministry of Land's guideline on restoring rented homes "
                      "names this consent for holding furniture."),
                     ("買う前に、家具を壁の下地にねじで留めてよいか、"
                      "大家さんや管理会社に相談してください。国土交通省の原状回復のガイドラインも、"
                      "家具の転倒防止では前もって貸主の承諾を得る方法を挙げています。")),
    "out_of_reach": ("Put beds and desks out of its reach.",
                     "ベッドや机を、家具が届かない所に移す方法があります。"),
    "lower_piece": ("Keep heavy things at the bottom, or choose a lower piece.",
                    "重い物を下の段に入れる、背の低い家具に替える、という方法もあります。"),
    # Why measures were not taken
    "not_taken": ("What was not taken, and why", "選ばなかった対策と理由"),
    "not_possible": ("cannot be put there ({why})", "取り付けられません（{why}）"),
    "drills": ("needs holes in the wall", "壁に穴を開ける必要があります"),
    "too_weak": ("too weak: {in_runs}", "弱すぎます（{in_runs}）"),
    "helps_not": ("does not help: the piece still overturns in {share} of the runs",
                  "効果がありません（家具が倒れる計算は{share}）"),
    "helps_less": ("helps less: {what} in {share} of the runs", "効果が小さめです（{what}計算は{share}）"),
    "costs_more": ("brings no more, and costs more", "効果が変わらず、費用が高くなります"),
    "brings_no_more": ("brings no more", "効果は変わりません"),
    "pair_not_tried": ("two together are tried only where one of them helps but is too weak",
                       "2つの併用は、1つでは効果があっても強度が足りないときだけ試します"),
    "not_needed": ("the steps bring as much without it", "ほかの項目だけで効果が変わりません"),
    # Moves
    "check_move": ("{empty}measure the new place; keep sockets and doors free",
                   "{empty}移動先の寸法を測り、コンセントとドアをふさがない"),
    "empty": ("empty it first; ", "中身を出してから動かす。"),
    # Effects
    "overturns": ("overturns {was} → {now}", "倒れる確率{was}→{now}"),
    "unclear": ("{chance}; no clear difference", "{chance}（明らかな差なし）"),
    "alone": ("alone: {chance}", "これだけ行うと、{chance}"),
    "only_together": ("helps only together with {steps}", "これだけでは効かず、{steps}も必要です"),
    "after_others": ("after the steps above: {chance}", "上の項目に続けて行うと、{chance}"),
    "changes": ("{what} {was} → {now}", "{what}確率{was}→{now}"),
    # Marks
    "mark": ("How well this is known: {grade}", "根拠の確かさ：{grade}"),
    "weakest": ("Least well known here: {inputs}.", "この項目で最も不確かな入力：{inputs}。"),
    "weakest_of": ("What is least well known", "最も不確かな入力"),
    # Foot
    "grades": ("Marks: {meanings}.", "記号：{meanings}。"),
    "grade": ("{grade}: {meaning}", "{grade}：{meaning}"),
    "strengths": (("Strengths asked for: the force on one device, computed with one that cannot break, "
                   "that is not exceeded in {share:.0f} % of {runs} runs, times {margin:.1f}. The margin "
                   "covers the weakest 5 % of the products, for the scatter of strengths that is assumed "
                   "(coefficient of variation {cov:.1f})."),
                  ("必要な強さ：壊れない器具として計算した1個あたりの力のうち、"
                   "{runs}回の計算の{share:.0f}%で超えなかった値の{margin:.1f}倍です。"
                   "弱いほうから5%の製品でも耐えるための余裕で、"
                   "強さのばらつき（変動係数{cov:.1f}）は仮定です。")),
    "costs": (("Cost classes are rough, not prices: for one piece, 1 is up to ¥{low:,} or €{low_euro}, 2 "
               "up to ¥{high:,} or €{high_euro}, 3 more."),
              ("費用の目安は大まかな区分で、実際の価格ではありません。家具1台につき、1は{low:,}円まで、"
               "2は{high:,}円まで、3はそれより高いものです。")),
    "runs": (("Chances with their 95 % intervals, and shares of the runs without one, are from {runs} runs "
              "of the room, under {motions} (seed {seed}) without and with each step. stayput {version}."),
             ("確率とかっこ内の95%区間、区間のない計算の割合は、各項目を行う前と後を、"
              "{motions}（乱数のシード{seed}）で{runs}回ずつ計算したものです。バージョン{version}。")),
    "same_motions": ("the same {count} motions", "同じ{count}本の地震動"),
    "limits": (("This is a calculation for the furniture and the earthquakes that were stated: no "
                "guarantee, and no replacement for the makers' instructions."),
               ("指定した家具と地震についての計算です。安全を保証するものではなく、"
                "製品の説明書に代わるものでもありません。")),
}
