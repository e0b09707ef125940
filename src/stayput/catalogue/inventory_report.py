"""What is printed and reported of an assessment."""

TEXTS: dict[str, tuple[str, str]] = {
    "title": ("Furniture at risk", "家具の転倒危険度"),
    "in_plane": (("Simulated in the plane of their depth: {rows}, of which no length along the wall is "
                  "known, or as the scenario says. The shaking along their length is left out, and measures "
                  "that hold here may fail in a real earthquake."),
                 ("奥行方向だけで計算した家具：{rows}（幅が分からないか、シナリオの指定による）。"
                  "幅の方向の揺れは含まれず、ここでは持ちこたえる対策も、実際の地震では外れることがあります。")),
    # Numbers
    "share": ("{value} %", "{value}%"),
    "given_up": ("all runs were given up", "すべての計算を打ち切り"),
    # Sums
    "event_heading": ("Event: {event}", "地震：{event}"),
    "expected": ("{fallen} of {pieces} {verb} expected to overturn: {share}{best}.",
                 "{pieces}のうち{fallen}点が転倒する見込みです：{share}{best}。"),
    "expected_best": (("; with the best of the compared measures on each that one clearly helps, "
                       "{fallen}: {share}"),
                      ("。対策の効果が偶然の差を超えて確認できた家具にその対策をとると{fallen}点："
                       "{share}です")),
    "needs_none_counted": (("No measure is needed for {pieces}: surely (95 %) less than {safe} % overturn "
                            "or slide too far."),
                           ("{pieces}は、対策なしでも転倒と大きな移動の95%区間の上限がいずれも{safe}%未満"
                            "で、対策不要です。")),
    "helped_counted": ("A compared measure helps {pieces} by more than chance ({against}).",
                       "{pieces}には、偶然の差を超えて効果のある対策があります（{against}）。"),
    "may_be_chance_counted": (("For {pieces} a measure does better ({against}), which may be chance: the "
                               "runs are too few."),
                              ("{pieces}には今回の計算で成績のよい対策がありますが（{against}）、"
                               "計算数が少なく、偶然の差かもしれません。")),
    "against_overturned": ("against overturning", "転倒の防止"),
    "against_slid": ("against sliding too far", "移動の抑制"),
    "against_device_failed": ("against a failing device", "器具の破損・脱落の防止"),
    "against_hit_wall": ("against hitting a wall", "壁への衝突の防止"),
    "against_counted": ("{count:,} {against}", "{against}{count:,}点"),
    "not_helped_counted": ("For {pieces} none of the compared measures is seen to help.",
                           "{pieces}では、比較した対策の効果を確認できませんでした。"),
    "none_possible_counted": (("For {pieces} no measure was compared: none of those that were asked for "
                               "is possible."),
                              "{pieces}では、指定した対策をどれも設置できないため、対策を比較していません。"),
    "none_compared_counted": ("For {pieces} no measure was asked for, so none was compared.",
                              "{pieces}では、対策の指定がないため、対策を比較していません。"),
    "too_few_runs_counted": (("For {pieces} there are not enough runs to tell whether a measure is needed "
                              "or helps; to show that less than {safe} % overturn or slide too far takes "
                              "{least} motions at least, and runs under all of them (precision = 0.03)."),
                             ("{pieces}は、計算数が足りず、"
                              "対策の要否や効果を判定できません（転倒や大きな移動が{safe}%未満であると示す"
                              "には、少なくとも{least}本の地震動が必要で、そのすべてで計算します"
                              "（precision = 0.03））。")),
    "expected_loss": ("Expected loss {loss}, with the best measures {best} (of what has a value{unstated}).",
                      ("損失の見込みは{loss}、最も有効な対策をとると{best}です（損失額の入力があるものだけ"
                       "の合計{unstated}）。")),
    "currency_unstated": (", in the currency of the table", "、通貨は表のとおり"),
    "inside_out": (("Of what is inside {pieces}, {share} is expected to come out; with the best measures "
                    "{best}."),
                   "{pieces}の収納物のうち{share}が飛び出す見込みです。最も有効な対策をとると{best}です。"),
    "nothing_known": ("Of {pieces} nothing is known: all runs were given up.",
                      "{pieces}はすべての計算を打ち切ったため、結果が分かりません。"),
    "without_mass": ("Without a mass: {rows}. It does not matter to how a free piece moves.",
                     "重量のない家具：{rows}。固定していない家具の動きは重量によりません。"),
    "fixed": (("Fixed already by {name}, L-brackets where that alone is said: {rows}. “Without a measure” "
               "means without a further one."),
              ("{name}ですでに固定してある家具（固定とだけあればL型金具）：{rows}。「対策なし」は、"
               "ほかに追加しないという意味です。")),
    # Maps
    "map_without": ("Share that overturns, in per cent, without a measure", "転倒する割合（%）：対策なし"),
    "map_best": ("The same with the best measure on each piece that one clearly helps",
                 "転倒する割合（%）：効果を確認できた対策をとったとき"),
    "map_same": ("As without: no measure lessens it by more than chance.",
                 "対策なしと同じ（偶然の差を超えて転倒を減らす対策がないため）。"),
    "left_out": ("{buildings}, with fewer pieces expected to overturn, {verb} in summary.csv.",
                 "転倒の見込みがより少ない残りの建物（{buildings}）は、summary.csvにあります。"),
    "no_building": ("no building", "建物の指定なし"),
    "floor": ("{storey}F", "{storey}階"),
    "basement": ("B{storey}F", "地下{storey}階"),
    "on_ground": ("ground", "地上"),
    "cell": ("{place}: {share} of {pieces}", "{place}：{pieces}の{share}"),
    "place": ("{building}, {floor}", "{building}、{floor}"),
    # The pieces
    "greatest": ("Pieces at greatest risk", "危険度の高い家具"),
    "greatest_order": ("By expected loss where a value is given, then by the probability of overturning.",
                       ("損失額の入力があるものは損失の見込みの大きい順、"
                        "次に転倒確率の高い順に並べています。")),
    "row": ("Row", "行"),
    "piece": ("Piece", "家具"),
    "event": ("Event", "地震"),
    "building": ("Building", "建物"),
    "storey": ("Storey", "階"),
    "count": ("Count", "数"),
    "overturns": ("Overturns", "転倒確率"),
    "contents_out": ("Contents out", "飛び出す収納物"),
    "best": ("Best measure", "最も有効な対策"),
    "overturns_best": ("Overturns with it", "対策後の転倒確率"),
    "contents_out_best": ("Contents out with it", "対策後に飛び出す収納物"),
    "best_by_cost": ("Best for its cost", "費用に見合う対策"),
    "loss": ("Expected loss", "損失の見込み"),
    "best_against": ("{measure}, {against}", "{measure}、{against}"),
    "may_be_chance": ("{measure} (may be chance)", "{measure}（偶然の可能性あり）"),
    "not_helped": ("none seen to help", "効果を確認できた対策なし"),
    "none_possible": ("none possible", "設置できる対策なし"),
    "none_compared": ("none compared", "対策の比較なし"),
    "needs_none": ("needs none", "対策不要"),
    "too_few_runs": ("not enough runs to tell", "計算数が足りず判定できない"),
    "not_worth": ("none shown to be worth it", "費用に見合うと確認できたものなし"),
    "not_possible": ("{name}: not possible. {reason} In {rows}.",
                     "{name}：設置できません。{reason}該当：{rows}。"),
    # Rejects
    "rejected": ("Rows that were not assessed", "評価できなかった行"),
    "rejects_counted": ("{rejects} of {rows}; rejects.csv has them all.",
                        "{rows}のうち{rejects}行です。すべてrejects.csvにあります。"),
    "rows_alike": ("{rows} ({places})", "{rows}（{places}行目）"),
    "such_as": ("such as: {reason}", "例：{reason}"),
    "reason_of_rows": ("  {rows}: {reason}", "  {rows}：{reason}"),
    "rows": ("Rows", "行"),
    "empty_column": ("{column} in {rows}", "{column}（{rows}）"),
    "empty_cells": (("Empty cells: {columns}. There a piece is called by its name and its row (the "
                     "headings are row 1), has the preset's size and mass, counts once, and is not fixed."),
                    ("空のセル：{columns}。番号の代わりに品名と行番号（見出しが1行目）、"
                     "寸法と質量はプリセットの値、数は1とし、固定していないものとします。")),
    "reason": ("Reason", "理由"),
    "none": ("None.", "ありません。"),
    # What was done
    "done": ("What was done", "計算の内容"),
    "read": ("{rows} below the header, read as {how}.", "見出しの下の{rows}を、{how}として読み込みました。"),
    "with_bars": ("{encoding} with bars", "{encoding}（縦棒区切り）"),
    "with_tabs": ("{encoding} with tabs", "{encoding}（タブ区切り）"),
    "with_semicolons": ("{encoding} with semicolons", "{encoding}（セミコロン区切り）"),
    "sheet": ("sheet {name}", "シート{name}"),
    "sheet_of_several": ("sheet {name}; not {others}", "シート{name}（ほかのシート{others}は対象外）"),
    "and_empty": ("{how}; {count} of them empty", "{how}（空の{count}行を除く）"),
    "not_used": ("Columns that were not used: {columns}.", "使わなかった列：{columns}。"),
    "scenario": (("Scenario {name}: {strength}{suite}, {motions}{synthetic}, at most {samples} for each, "
                  "seed {seed}."),
                 ("シナリオ「{name}」：{strength}{suite}、{motions}{synthetic}、"
                  "それぞれ標本が最大{samples}、乱数の種{seed}。")),
    "at_intensity": ("the ground at JMA intensity {value:.2f}; ", "地面の計測震度{value:.2f}、"),
    "one_motion": ("one motion", "地震動1つ"),
    "synthetic": (" (synthetic)", "（模擬地震動）"),
    "units": (("{choices} of piece, measures, floor and event; {units} of them simulated, each that "
               "differs once."),
              "家具・対策・床・地震の組み合わせ{choices}のうち、異なる{units}通りを1回ずつ計算しました。"),
    "slide_limit": (("A piece slid too far if it slid more than {limit} m. The expected loss counts "
                     "overturning only."),
                    ("{limit} mを超えて移動したものを「移動しすぎ」とします。"
                     "損失の見込みは転倒だけを数えます。")),
    "contents_followed": (("What is inside is followed in one run of each motion, {most} at most; the "
                           "shares are their means."),
                          "収納物は、地震動ごとに1回、最大{most}回の計算で追跡します。割合はその平均です。"),
    "intervals": (("Intervals are 95 %, over motions and draws. Pieces of one event meet the same "
                   "motions, so they fall together: the expected number does not say how far the number "
                   "may be off."),
                  ("区間は、地震動と不確かな量のばらつきによる95%区間です。"
                   "同じ地震の家具は同じ地震動を受けて一緒に倒れるため、見込みの数からは、"
                   "実際の数がどれだけ外れうるかは分かりません。")),
    "best_chosen": (("The best measure is chosen by the runs that score it, which flatters it; sums and "
                     "maps with the best measures count only those that help by more than chance, "
                     "compared run by run: of several sets, by intervals that hold together (Bonferroni)."),
                    ("最も有効な対策は、成績を示すのと同じ計算から選ぶため、効果がやや大きめに出ます。"
                     "対策後の合計と地図には、計算ごとに比べて偶然の差を超える効果のある対策だけを数えます"
                     "（複数の対策の比較では、全体で95%となる区間によります：ボンフェローニ法）。")),
    "shake_map": ("How strongly the ground shakes comes from a shake map: {map}.",
                  "地面の揺れの強さは地震動マップによります：{map}。"),
    "map_of_intensity": ("JMA intensity, rounded to 0.1", "計測震度（0.1刻みに丸め）"),
    "map_of_peak": ("{measure} of the larger horizontal component, rounded by at most 3 %",
                    "水平2成分の大きい方の{measure}（3%以内で丸め）"),
    "with_scatter": ("{about}, with its scatter", "{about}、ばらつき付き"),
    "renamed": ("Columns as they were understood: {columns}.", "列の読み取り方：{columns}。"),
    "without_coordinates": ("Without coordinates: {pieces}; on a map they have no point.",
                            "座標のない家具：{pieces}（地図には表示されません）。"),
    "map_of_sa": (("Sa at {period} s, {damping} % damping, geometric mean of both components, rounded by "
                   "at most 3 %"),
                  "周期{period}秒の加速度応答（減衰{damping}%、水平2成分の幾何平均、3%以内で丸め）"),
    "version": ("stayput {version}.", "stayput {version}。"),
    # Printed
    "printed_read": ("Read {rows} as {how}: {pieces} assessed.",
                     "{rows}を{how}として読み込み、{pieces}行を評価しました。"),
    "printed_rejects": ("Not assessed: {rows}; rejects.csv has them all.",
                        "評価できなかった行：{rows}。すべてrejects.csvにあります。"),
    "printed_runs": ("{choices}, {units} of them different; {runs}.",
                     "組み合わせ{choices}（うち異なるもの{units}通り）、計算{runs}。"),
    "of_event": ("{event}: {expected}", "{event}：{expected}"),
    "dashboard": ("Dashboard of the cluster: {link}", "クラスターの状況：{link}"),
}
