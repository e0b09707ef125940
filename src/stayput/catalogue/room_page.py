"""Texts of the page of a room and of the editor of its plan; its script fills in what stands in braces."""

TEXTS: dict[str, tuple[str, str]] = {
    "roomTitle": ("stayput: is everybody in this room safe in an earthquake?",
                  "stayput：地震のとき、この部屋にいる人は安全か"),
    "roomClaim": ("Is everybody in this room safe in an earthquake?", "地震のとき、この部屋にいる人は安全か"),
    "toPiece": ("One piece", "家具1つ"),
    "skipToVerdict": ("Skip to the verdict", "判定へ移動"),
    "setUp": ("Set up the room", "部屋を作る"),
    "whatToDo": ("What to do", "対策する"),
    "toDo": ("What to do about it", "どう対策するか"),
    "roomItself": ("The room and the house", "部屋と建物"),
    "ceilingThere": ("There is a ceiling", "天井がある"),
    "dropRoom": ("A scenario file of a room opens that room.", "部屋の条件ファイルは、その部屋を開きます。"),
    # The verdict
    "answerTitle": ("What happens in this room", "この部屋で起こること"),
    "rough": ("First, rough numbers from few runs of the room ({runs}); the intervals are still wide.",
              "まだ回数の少ない計算（{runs}回）による目安です。確率にはまだ大きな幅があります。"),
    "before": ("Waiting for the server: {n} before you.", "順番を待っています。前に{n}件あります。"),
    "roomBetter": ("More runs make the numbers surer …", "計算を続けて、数値を確かにしています…"),
    "counting": ("counting …", "計算中…"),
    "state_empty": ("Nothing in the room that can fall yet.", "倒れるおそれのある家具がまだありません。"),
    "serverAway": ("The server does not answer; waiting for it.", "応答がありません。戻りしだい続けます。"),
    "briefHit": ("somebody hit: {share}", "人に当たる：{share}"),
    "briefShutIn": ("shut in: {share}", "出られない：{share}"),
    "briefOld": ("before the change: {said}", "変更前：{said}"),
    "briefRefused": ("The room cannot be worked out; see why.", "この部屋は計算できません。理由を見る"),
    "bestChange": ("Best single change: {sentence}", "最も効果のある変更：{sentence}"),
    "amongBest": ("One of the best single changes: {sentence} Others may help as much ({count}).",
                  "最も効果のある変更の1つ：{sentence}ほかに{count}件が同じくらい効く可能性があります。"),
    "noBest": ("None of the single changes that may be made here makes it clearly better.",
               "ここで行える変更のうち、明らかに良くなるものはありませんでした。"),
    "makeBest": ("Try this change", "この変更を試す"),
    "basisOfRoom": (("Runs of the room: {whole}, under {motions} earthquakes, each time with other "
                     "friction and weights. Runs of single pieces for that and for all changes: {runs}. "
                     "Seed {seed}, {seconds} s of computing."),
                    ("部屋の計算{whole}回（地震{motions}種類、"
                     "毎回摩擦や重さを変えます）の結果です。変更を試した分を含め、"
                     "家具1つずつの計算は{runs}回です。乱数のシードは{seed}、計算時間は{seconds}秒です。")),
    "basisOfOneMotion": (("Runs of the room under this one motion: {whole}, each time with other friction "
                          "and weights. Runs of single pieces for that and for all changes: {runs}. Seed "
                          "{seed}, {seconds} s of computing."),
                         ("この1つの地震動による、部屋の計算{whole}回（毎回摩擦や重さを変えます）の結果で"
                          "す。変更を試した分を含め、家具1つずつの計算は{runs}回です。"
                          "乱数のシードは{seed}、計算時間は{seconds}秒です。")),
    "careOwn": ("as the file says", "ファイルの指定どおり"),
    "pointsBetween": ("{low} to {high} points", "{low}～{high}ポイント"),
    "noClearDifference": ("no clear difference", "明らかな差なし"),
    "medianAndMost": ("{median}, in 10 % of the hits over {most}", "{median}（10%の場合は{most}を超える）"),
    # What it rests on
    "whoIsHit": ("Who is hit, and by what?", "誰に何が当たるか"),
    "noPlaces": ("There is no place of a person in the room yet.", "人のいる場所がまだありません。"),
    "dayAndNight": ("Counting how often somebody is there: {day} by day, {night} at night.",
                    "人がいる時間の割合を掛けると、昼は{day}、夜は{night}です。"),
    "fallsOn": ("“{piece}” falls on them", "「{piece}」が倒れかかる"),
    "touches": ("“{piece}” touches them without falling", "「{piece}」が倒れずに触れる"),
    "hitByNothing": ("Nothing hits there.", "当たる家具はありません。"),
    "crushedOrTouched": (("Crushed, hit with {energy} J or more: {crushed}. Touched without a fall: "
                          "{touched}."),
                         "{energy} J以上で当たる（下敷き）：{crushed}。倒れない家具が触れる：{touched}。"),
    "impact": ("It weighs {mass} kg. Speed there: {speed}. Energy: {energy}.",
               "重さは{mass} kg。その場所での速さは{speed}。エネルギーは{energy}。"),
    "htmlOfRoom": ("Animation (HTML)", "動画（HTML）"),
    "gifOfRoom": ("Animation, 10 s (GIF)", "動画、10秒（GIF）"),
    "mp4OfRoom": ("Animation, 10 s (MP4)", "動画、10秒（MP4）"),
    "noInjury": (("Chances are for somebody who is there. Speed and energy are upper bounds: no bed and "
                  "no person holds the piece up. Whether such a blow injures is not computed."),
                 ("確率は、その場所に人がいる場合のものです。速さとエネルギーは、"
                  "ベッドや人が家具を支えないとした上限です。けがをするかどうかは計算していません。")),
    "waysOut": ("Doors and ways out", "ドアと避難経路"),
    "noDoors": ("There is no door in the room yet.", "部屋にまだドアがありません。"),
    "doorBlocked": ("{door}: stays blocked", "{door}がふさがる"),
    "shutInAt": ("No way out from here: {place}", "{place}から外に出られない"),
    "whichPieces": ("Which piece does most harm?", "最も危ない家具はどれか"),
    "piecesOrder": ("Most harm first; bars: chance of falling over.", "危ない順です。棒は倒れる確率です。"),
    "contributes": ("It makes up {share} of the harm to people.", "人への被害の{share}を占めます。"),
    "inTheWay": (("It is in the way out: somebody is shut in {now}, and in {then} with this change: "
                  "{change}."),
                 "外への通り道をふさぎます。出られない確率は{now}で、「{change}」と{then}になります。"),
    "fallsToo": ("Overturning, hitting nobody: {pieces}.", "倒れる家具（人には当たらない）：{pieces}。"),
    "fallsOften": ("{piece} ({share})", "{piece}（{share}）"),
    "pieceSlides": ("Slides far in {share}.", "大きく滑る確率は{share}。"),
    "pieceFails": ("What holds it fails in {share}.", "固定が外れる確率は{share}。"),
    # What helps
    "whatHelpsRoom": ("Which single change helps most?", "どの変更が最も効くか"),
    "changesWait": ("The changes are being worked out one by one …", "変更を1つずつ計算しています…"),
    "changesNote": (("The bar is the chance of what is named above it, after the change; the thin line is "
                     "how sure that is. Each change is tried alone, under the same shaking. One that was "
                     "made can be undone in the plan. Points are percentage points: from 40 % to 30 % is "
                     "−10 points."),
                    ("棒はその上に書いたことの、変更後の確率です。細い線はその確かさを表します。"
                     "変更は1つずつ、同じ揺れで試しています。行った変更は、間取り図で元に戻せます。"
                     "ポイントは確率の差で、40%が30%になれば−10ポイントです。")),
    "allChanges": ("Show all {n}", "{n}件すべてを表示"),
    "itOverturns": ("It overturns", "この家具が倒れる"),
    "hitChange": ("Somebody is hit: {share}; {by}.", "人に当たる確率：{share}、差：{by}。"),
    "shutChange": ("Shut in: {share}; {by}.", "出られない確率：{share}、差：{by}。"),
    "fallChange": ("It overturns: {share}; {by}.", "倒れる確率：{share}、差：{by}。"),
    "withTried": ("With what is being tried: {changes}.", "試している変更を含みます：{changes}。"),
    "triedTitle": ("Being tried: steps of the plan", "試している変更（「やること」に入ります）"),
    "triedMoved": ("{what} moved", "{what}を移動"),
    "triedMeasures": ("{what} with {measures}", "{what}に{measures}"),
    "triedNone": ("nothing more", "追加なし"),
    "takeBack": ("Take back", "元に戻す"),
    "isMade": ("Already done", "実施済み"),
    "planTitle": ("Plan to buy and do", "買う物とやること"),
    "planMake": ("Work out the plan", "「買う物とやること」を作る"),
    "planWait": ("It can be worked out once the verdict is complete.", "判定の計算が終わると作れます。"),
    "planRuns": ("Runs so far: {runs}", "これまでの計算：{runs}回"),
    "planOpen": ("Open the plan to buy and do, for printing", "「買う物とやること」を開く（印刷用）"),
    "allowed_no_drilling": ("No drilling (rented)", "穴を開けられない（賃貸）"),
    "allowed_tatami": ("The floor is tatami", "床が畳"),
    "allowed_plasterboard": ("The walls are plasterboard without studs", "壁が石こうボードだけ"),
    "allowed_dropped_ceiling": ("The ceiling is a dropped one", "天井が吊り天井"),
    # The picture in space
    "slidBy": ("moves up to {slide}", "最大{slide}移動"),
    "inThisHit": ("In this one somebody is hit (by: {pieces}); that is so in {share}.",
                  "この揺れでは人に当たります（{pieces}）。人に当たる割合は{share}です。"),
    "inThisNone": ("In this one nothing reaches anybody; that is so in {share}.",
                   "この揺れでは誰にも当たりません。誰にも当たらない割合は{share}です。"),
    "inThisShut": ("Somebody is shut in, as in {share}.", "出られない人がいます。その割合は{share}です。"),
    # Rooms that are kept
    "scenesTitle": ("Rooms kept on this device", "この端末に保存した部屋"),
    "sceneName": ("Name of this room", "この部屋の名前"),
    "keepScene": ("Keep this room", "この部屋を保存"),
    "unnamed": ("Room", "部屋"),
    "noScenes": ("None yet. They stay on this device and are sent to nobody.",
                 "まだありません。保存した部屋はこの端末だけに残り、どこにも送られません。"),
    "openScene": ("Open", "開く"),
    "renameScene": ("Rename", "名前を変更"),
    "removeScene": ("Remove", "削除"),
    "markScene": ("Mark to compare", "比較する"),
    "newName": ("New name of the room", "部屋の新しい名前"),
    "removeSure": ("Remove “{name}” from this device?", "「{name}」をこの端末から削除しますか。"),
    "keptScene": ("Kept as “{name}”.", "「{name}」として保存しました。"),
    "keptBeside": (("The room of this name was changed in another tab; this one is kept beside it, as "
                    "“{name}”."),
                   "同じ名前の部屋が別のタブで変更されたため、「{name}」として別に保存しました。"),
    "removedScene": ("“{name}” has been removed.", "「{name}」を削除しました。"),
    "scenesFull": (("Not kept: the browser's storage for this page is full. Remove rooms that you no "
                    "longer need, or save this one as a file."),
                   ("保存できませんでした。このページ用の保存領域がいっぱいです。不要な部屋を削除するか、"
                    "ファイルに保存してください。")),
    "scenesClosed": (("Not kept: this browser keeps nothing for the page, as in a private window. Save "
                      "the room as a file, or keep its link."),
                     ("保存できませんでした。このブラウザーでは、"
                      "プライベートウィンドウなどのため保存が許されていません。"
                      "ファイルかリンクで保存してください。")),
    "planOf": ("Plan of “{name}”", "「{name}」の間取り図"),
    # Two of them
    "compare": ("Compare the two that are marked", "印を付けた2つを比べる"),
    "compareTitle": ("Two rooms compared", "2つの部屋の比較"),
    "compareNote": (("Both under the same shaking, which is that of the first, and with the same random "
                     "numbers."),
                    "どちらも同じ揺れ（1つ目の部屋の設定）と同じ乱数で計算しています。"),
    "compareWhat": ("What happens", "起こること"),
    "compareDifference": ("Difference", "差"),
    "compareSaid": ("{what}: {second} in “{b}” instead of {first}; difference: {by}.",
                    "{what}確率：「{b}」では{first}ではなく{second}です。差：{by}。"),
    "compareAlike": ("{what}: no clear difference between “{a}” and “{b}”.",
                     "{what}確率：「{a}」と「{b}」に、明らかな差はありません。"),
    "compareUnpaired": (("The 95 % intervals of the differences take the two rooms as counted apart, "
                         "although they meet the same earthquakes; so they are rather too wide."),
                        ("差の95%区間は、2つの部屋を別々に数えたものとして求めています。"
                         "実際には同じ地震なので、区間はやや広めです。")),
    "basisOf": ("{name}: {basis}", "{name}：{basis}"),
    "notThere": ("not there", "なし"),
    "pieceFalls": ("{piece} overturns", "「{piece}」が倒れる"),
    "compareEnd": ("Close the comparison", "比較を閉じる"),
    "somebodyHit": ("Somebody is hit", "誰かに当たる"),
    "hitAt": ("Hit here: {place}", "{place}にいる人に当たる"),
    "somebodyShutIn": ("Somebody is shut in", "誰かが出られなくなる"),
    # Link and files
    "filesTitle": ("Link and files", "リンクとファイル"),
    "roomLinkLong": (("This room is too large for a link: save it as a file. This tab shows it again when "
                      "it is loaded anew."),
                     ("この部屋は大きいため、リンクにはできません。ファイルに保存してください。"
                      "このタブでは、読み込み直しても表示されます。")),
    "openFile": ("Open a scenario file", "条件ファイルを開く"),
    "openedFile": ("“{name}” is open.", "「{name}」を開きました。"),
    "noRoomInFile": (("This scenario has no plan of a room: [plan] is missing. One piece is set on the "
                      "other page."),
                     ("この条件ファイルには部屋の間取りがありません。家具1つの条件は、"
                      "もう一方のページで設定してください。")),
    "roomDamaged": ("The link is damaged: it does not hold all of a room. What you see is another one.",
                    "リンクが壊れていて、部屋の内容がそろっていません。表示しているのは別の部屋です。"),
    "recordGoneHere": (("The record of this room is no longer on the server; drop it again. Until then a "
                        "computed earthquake takes its place."),
                       ("この部屋の地震記録はサーバーに残っていません。もう一度ドロップしてください。"
                        "それまでは、計算で作った地震の揺れを使います。")),
    # The editor
    "door": ("Door", "ドア"),
    "window": ("Window", "窓"),
    # Palette
    "paletteFurniture": ("Furniture", "家具"),
    "palettePlaces": ("Places of people", "人のいる場所"),
    "paletteOpenings": ("Doors and windows", "ドアと窓"),
    # Plan
    "planAlt": ("Plan to scale of a room {width} wide and {length} long: {content}",
                "幅{width}、奥行き{length}の部屋の平面図（縮尺どおり）：{content}"),
    "planEdited": ("Plan of a room {width} wide and {length} long, to be edited",
                   "幅{width}、奥行き{length}の部屋の平面図（編集できます）"),
    "planHelp": ("How to edit the plan", "平面図の編集のしかた"),
    "planKeys": (("Drag things with the mouse or a finger; near a wall a piece turns its back to it. Pull "
                  "the round handles to change a size or to turn it; with Alt held down nothing snaps. "
                  "With the keyboard: Tab goes from thing to thing, the arrows move by 5 cm, with Shift "
                  "by 1 cm, R turns by 90°, D makes another of the same, Delete removes, Enter goes to "
                  "its numbers and Escape back, Escape gives up a drag, Ctrl+Z takes a change back and "
                  "Ctrl+Y makes it again."),
                 ("マウスや指で動かせます。家具は壁に近づけると背を壁に向けて付きます。"
                  "丸い印を引くと大きさや向きが変わります。"
                  "〔Alt〕キーを押している間は壁や辺に吸着しません。キーボードでは、〔Tab〕で次へ移り、"
                  "矢印で5 cm（〔Shift〕と一緒に1 cm）ずつ動かし、〔R〕で90°回し、"
                  "〔D〕で同じものを増やし、〔Delete〕で取り除きます。〔Enter〕で数値の欄に移り、"
                  "〔Esc〕で戻ります。〔Esc〕でドラッグをやめ、〔Ctrl+Z〕で元に戻し、"
                  "〔Ctrl+Y〕でやり直します。")),
    "pullToSize": ("Pull to change the size", "引いて大きさを変える"),
    "pullToTurn": ("Pull to turn", "引いて向きを変える"),
    "undoIt": ("Undo", "元に戻す"),
    "redoIt": ("Redo", "やり直す"),
    "turnIt": ("Turn by 90°", "90°回す"),
    "removeIt": ("Remove", "取り除く"),
    "emptyIt": ("Empty room", "部屋を空にする"),
    "emptied": ("The room is empty; Undo brings it back.", "空にしました。「元に戻す」で戻ります。"),
    "undone": ("The last change is taken back.", "直前の変更を元に戻しました。"),
    "redone": ("The change is made again.", "変更をやり直しました。"),
    "added": ("Added: {what}", "追加：{what}"),
    "removed": ("Removed: {name}", "取り除いたもの：{name}"),
    "layer_fell": ("Where pieces fall", "倒れる範囲"),
    "layer_stood": ("Where they slide to", "滑って止まる範囲"),
    "layer_hit": ("Who is hit", "人に当たる確率"),
    "layer_blocked": ("Blocked doors", "ふさがるドア"),
    "layersHint": (("On the floor, the colour of what falls shows where it lies, that of what moves where "
                    "it comes to stand. The stronger the colour, the more often."),
                   ("床の「倒れる」の色は倒れている範囲、「動く」の色は立ったまま止まる範囲です。"
                    "濃いほど多く起こります。")),
    # Where something is
    "metresLong": ("{value} m", "{value} m"),
    "atWall": ("at the {wall}", "{wall}に背を付けて"),
    "inTheWall": ("in the {wall}", "{wall}"),
    "fromWall": ("{distance} from the {wall}", "{wall}から{distance}"),
    "fromTo": ("from {start} to {end}", "{start}から{end}まで"),
    "facesTo": ("facing the {wall}", "{wall}向き"),
    "headTo": ("head towards the {wall}", "頭は{wall}の側"),
    "turnedBy": ("turned by {angle}°", "{angle}°回転"),
    "standsOn": ("on the {name}", "「{name}」の上"),
    "opens_inwards": ("opens inwards", "内開き"),
    "opens_outwards": ("opens outwards", "外開き"),
    "opens_sliding": ("slides", "引き戸"),
    # What stands wrong
    "inWall": ("{name} reaches {depth} into a wall.", "「{name}」が壁に{depth}入り込んでいます。"),
    "inOther": ("{name} and {other} overlap by {depth}.", "「{name}」と「{other}」が{depth}重なっています。"),
    "opensAgainst": ("{name} does not open fully: {other} is in its way.",
                     "「{name}」が「{other}」に当たり、全開できません。"),
    "noFurniture": ("The room is empty; put at least one piece of furniture into it.",
                    "部屋に家具がありません。1つ以上置いてください。"),
    # What is selected
    "inspector": ("What is selected", "選んだもの"),
    "selectHint": ("Select something on the plan to see its numbers.",
                   "平面図で選ぶと、その数値を変えられます。"),
    "roomSize": ("Size of the room", "部屋の大きさ"),
    "roomWidth": ("From the left to the right wall", "左の壁から右の壁まで"),
    "roomLength": ("From the near to the far wall", "手前の壁から奥の壁まで"),
    "name": ("Name", "名前"),
    "nameEmpty": ("A name must be given.", "名前を入力してください。"),
    "nameTaken": ("{name} is the name of something else; each must have a name of its own.",
                  "「{name}」はほかで使われています。それぞれに異なる名前を付けてください。"),
    "standsAt": ("Stands with its back to", "背を付ける壁"),
    "freely": ("no wall", "壁に付けない"),
    "alongWall": ("Its middle along it, from the near or left end", "壁の手前または左の端から中心まで"),
    "fromLeft": ("Its middle from the left wall", "左の壁から中心まで"),
    "fromNear": ("Its middle from the near wall", "手前の壁から中心まで"),
    "turnedDegrees": ("Turned by", "向き"),
    "pieceDepth": ("Depth, back to front", "奥行き"),
    "pieceLength": ("Length, side to side", "幅"),
    "filling": ("What is in it", "中身"),
    "filling_full": ("full", "いっぱい"),
    "filling_empty": ("empty", "空"),
    "placeWidth": ("Width", "幅"),
    "placeLength": ("Length", "長さ"),
    "personLow": ("The person is from this height", "人がいる高さ（下端）"),
    "personHigh": ("up to this height", "人がいる高さ（上端）"),
    "byDay": ("Share of the day with somebody there", "昼に人がいる割合"),
    "atNight": ("Share of the night with somebody there", "夜に人がいる割合"),
    "inWhichWall": ("In which wall", "どの壁か"),
    "startsAt": ("Begins along the wall, from its near or left end", "壁の手前または左の端から始まりまで"),
    "clearWidth": ("Clear width", "幅（有効）"),
    "howOpens": ("How it opens", "開き方"),
    "hingeAt": ("Hinge", "ちょうつがい"),
    "hinge_start": ("where it begins", "始まりの側"),
    "hinge_end": ("where it ends", "終わりの側"),
    "wayOut": ("It leads out", "外への避難経路になる"),
    "sill": ("Sill above the floor", "床から窓の下端まで"),
    "doubleIt": ("Another of the same", "同じものを追加"),
}
