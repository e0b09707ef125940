"""What ``--help`` says of commands, arguments and flags. Flags, values and types stand as they are typed.

The first paragraph of a command also stands in the list of commands, and beside its name in a shell.
"""

TEXTS: dict[str, tuple[str, str]] = {
    # Headings, and what stands in brackets after a text; Typer has the English ones
    "usage": ("Usage", "使い方"),
    "arguments": ("Arguments", "引数"),
    "options": ("Options", "オプション"),
    "commands": ("Commands", "コマンド"),
    "required": ("required", "必須"),
    "default": ("default: {value}", "既定値：{value}"),
    "range": ("{low}<=x<={high}", "{low}～{high}"),
    # Commands
    "stayput": ("Verify earthquake-proof measures for furniture.", "家具の地震対策の効果を検証する"),
    "simulate": (("Simulate what stands under one motion: a piece, several, or a room.\n\nFlags stand in "
                  "the place of what the file says; --body without a file stands free of walls."),
                 ("家具（1つ、複数、または部屋）に1つの揺れを与えて計算する\n\nオプションの値はシナリオフ"
                  "ァイルの値に優先する。ファイルなしで--bodyを指定した場合、壁はないものとする。")),
    "verify": (("Compare what a scenario's measures do, over its motions and over what is not known.\n\n"
                "Without measures in the file the usual ones are compared, those that can be applied "
                "there. Of several pieces ([[furniture]]) joints and measures on each are compared. Of a "
                "room with a [plan] it is said who is hit, which door stays shut, and which single change "
                "helps most; with --card also what to move and to buy. Flags stand in the place of what "
                "the file says."),
               ("シナリオの対策の効果を、地震動や不確かさを考慮して比較する\n\nファイルに対策がなければ、"
                "そこで使える一般的な対策を比較する。家具が複数（[[furniture]]）の場合は、"
                "連結とそれぞれの対策を比較する。[plan]のある部屋の場合は、誰に家具が当たるか、"
                "どの扉が開かなくなるか、どの変更が最も効くかを示し、"
                "--cardを指定すると移動や購入の計画も作る。オプションの値はファイルの値に優先する。")),
    "assess": (("Assess every piece of an inventory: how likely it overturns, and which measure helps "
                "most.\n\nInterrupted, the same command goes on from what is complete."),
               ("家具一覧のすべての家具の転倒確率と、最も効く対策を求める\n\n中断しても、"
                "同じコマンドで続きから再開する。")),
    "app": ("Serve the app: set a scene, see it shaken, see what holds it.",
            "アプリを起動する（揺れと対策の効果を画面で見る）"),
    "motion": ("Look at a motion of the floor, or make one.", "揺れを調べる、変換する、作る"),
    "info": (("Say how long and how strong a motion is: its intensities, and its peaks by component.\n\n"
              "With --building and no --storey: the peaks of every floor, and where the energy went."),
             ("揺れの長さと強さ（震度、"
              "成分ごとの最大値など）を表示する\n\n--buildingだけを指定すると（--storeyなし）、"
              "各階の床の最大応答とエネルギーの収支を表示する。")),
    "plot": (("Plot acceleration, velocity and displacement of every component.\n\nWith --building and no "
              "--storey: the peaks of every floor, and floor spectra."),
             ("各成分の加速度、速度、変位の波形を描く\n\n--buildingだけを指定すると（--storeyなし）、"
              "各階の床の最大応答と床のスペクトルを描く。")),
    "spectrum": ("Print the response spectra of a motion.", "揺れの応答スペクトルを表示する"),
    "convert": ("Write a motion in another format, or changed.", "揺れを別の形式で、または変更して書き出す"),
    "suite": ("Make or read a suite, scale it, and write it.", "地震動群を作るか読み、調整して書き出す"),
    # Flags of every program
    "version": ("Print the version.", "バージョンを表示する"),
    "help": ("Show this message and exit.", "この説明を表示して終了する"),
    "install_completion": ("Install completion for the current shell.", "使用中のシェルに補完を設定する"),
    "show_completion": ("Show completion for the current shell.", "シェルの補完スクリプトを表示する"),
    "quiet": ("Print results and refusals alone.", "結果とエラーだけを表示する"),
    "lang": ("Language of what is printed, drawn and reported.", "表示、図、レポートの言語"),
    "of_locale": ("the locale's", "ロケールの言語"),
    "json": ("Print one JSON object.", "結果を1つのJSONオブジェクトとして表示する"),
    "threads": ("Threads; by default as many as cores.", "スレッド数。指定しなければコアの数"),
    "set": (("Any key of the scenario, as its file would say it: shaking.pgv=0.5, room.left_wall.gap=0.1, "
             "furniture[1].heading=0.3. May be repeated."),
            ("シナリオのキーをファイルに書くのと同じ形で指定する（例：shaking.pgv=0.5、"
             "room.left_wall.gap=0.1、furniture[1].heading=0.3）。複数回指定できる")),
    "unit": ("The record's unit, where its file states none.", "記録の単位（ファイルにない場合）"),
    "dt": ("The record's time step [s], if its file has none.", "記録の時間刻み [s]（ファイルにない場合）"),
    "record_columns": ("Columns of time and components: t=1,x=acc; or rows of one series.",
                       "時刻と各成分の列（例：t=1,x=acc）、または1つの時系列の並ぶ行（rows）"),
    "set_shaking": (("Any key of [shaking], as a scenario's file would say it: shaking.unit=gal, "
                     "shaking.scale=0.5, shaking.across=ew.AT2, shaking.building.period=0.8. May be "
                     "repeated."),
                    ("シナリオの[shaking]のキーをファイルに書くのと同じ形で指定する（例："
                     "shaking.unit=gal、shaking.scale=0.5、shaking.across=ew.AT2、"
                     "shaking.building.period=0.8）。複数回指定できる")),
    # The shaking
    "motion_argument": ("A record's file, - (standard input), near-fault, or sine:A,F[,T].",
                        "記録のファイル、-（標準入力）、near-fault、sine:A,F[,T]のいずれか"),
    "motion_option": (("A record's file, the built-in motion, or a sine of A [m/s²], F [Hz] and T [s]; in "
                       "the place of the file's whole [shaking]."),
                      ("記録のファイル、組み込みの地震動、または正弦波（振幅A [m/s²]、振動数F [Hz]、"
                       "時間T [s]）。ファイルの[shaking]全体に代わる")),
    "intensity": ("JMA intensity of the ground to scale to: a number, or a class such as 6-upper.",
                  "地面の揺れをこの震度に合わせる：計測震度の数値、または6強（6-upper）などの震度階級"),
    "pga": ("Peak ground acceleration to scale to [m/s²].", "地面の最大加速度をこの値に合わせる [m/s²]"),
    "building": ("The building between, such as 10,RC.", "間にある建物（例：10,RC）"),
    "storey": ("The storey whose floor shakes; 1 is the ground floor.", "建物のどの階の床か（1が地上階）"),
    # simulate
    "example_scenario": (("A scenario file; - is standard input. Default: a bookcase before a wall and a "
                          "synthetic near-fault motion."),
                         "シナリオファイル（-は標準入力）。指定しなければ、壁際の本棚と断層近傍の模擬地震動"),
    "body": ("A body: width along the shaking x height [m] x mass [kg].",
             "家具：揺れの方向の寸法 x 高さ [m] x 質量 [kg]"),
    "floor": ("A surface, such as 'carpet'.", "床の表面の種類（例：'carpet'）"),
    "measure_in_place": ("A measure in place: a type, or a name in the file; repeatable.",
                         "取り付ける対策（種類か名前。複数可）"),
    "plot_run": ("Plot the histories: .png, .svg or .pdf.", "時刻歴を描く：.png、.svg、.pdf"),
    "animate": ("Animate the run: .html, .gif or .mp4.", "動きのアニメーションを作る：.html、.gif、.mp4"),
    "speed": ("Speed of the animation: 0.25 is slow motion.", "再生速度（0.25でスローモーション）"),
    "fps": ("Frames a second of a .gif or .mp4.", ".gifや.mp4の1秒当たりのフレーム数"),
    # verify
    "scenario": ("The scenario file; - is standard input.", "シナリオファイル（-は標準入力）"),
    "report": ("Write a report that needs nothing else: .html.", "それだけで読めるレポートを書き出す：.html"),
    "markdown": ("Write the verdict as .md; - prints it.", "判定を.mdに書き出す（-は標準出力）"),
    "csv": ("Write the ranking as .csv; - prints it.", "順位を.csvに書き出す（-は標準出力）"),
    "card": ("Write what to buy and do in a room: .html.", "部屋の対策計画を書き出す：.html"),
    "no_drilling": ("With --card: nothing may be screwed to a wall.", "--cardの条件：壁にねじ留めできない"),
    "tatami": ("With --card: the floor is tatami.", "--cardの条件：床が畳"),
    "plasterboard": ("With --card: the walls have no studs to screw to.", "--cardの条件：壁に間柱がない"),
    "dropped_ceiling": ("With --card: the ceiling hangs on wires.", "--cardの条件：天井が吊り天井"),
    "curves": (("Write fragility curves, the probability of overturning over the strength of the shaking: "
                "curves.csv and observed.csv, a figure, pelicun's file and OpenQuake's NRML."),
               ("フラジリティ曲線（揺れの強さに対する転倒確率）を書き出すフォルダー：curves.csv、"
                "observed.csv、図、pelicun用ファイル、OpenQuake用のNRML")),
    "slide_limit": ("Slide that counts as too far [m].", "移動しすぎと見なす移動量 [m]"),
    "im": (("With --curves: what they are over, JMA by default; SA(0.3): spectral acceleration at 0.3 s; "
            "PFA, PFV: the floor's peaks."),
           ("--curvesの横軸とする揺れの強さの指標（既定はJMA）。SA(0.3)は周期0.3 sの加速度応答スペクトル、"
            "PFAとPFVは床の最大加速度と最大速度")),
    "only_measure": ("Only this measure beside none; repeatable.", "対策なしと比べる対策（複数可）"),
    # motion
    "floor_spectra": ("With --building: storeys of floor spectra, such as 3,8.",
                      "--building：スペクトルを描く階（例：3,8）"),
    "picture": ("Picture to write: .png, .svg or .pdf.", "書き出す図：.png、.svg、.pdf"),
    "oscillator_damping": ("Damping ratio of the oscillators, 0 to 0.95.", "応答の減衰定数（0～0.95）"),
    "spectra_out": ("Write the spectra to a .csv; - prints it.", "全成分のスペクトル：.csv（-は標準出力）"),
    "plot_spectra": ("Plot them and Fourier's: .png, .svg or .pdf.", "応答・フーリエの図：.png、.svg、.pdf"),
    "converted": ("File to write: .csv or .at2; - prints it.", "書き出すファイル：.csv、.at2（-は標準出力）"),
    "only": ("Keep this component alone, as x; for .at2.", "この成分だけをxとして残す（.at2用）"),
    "step": ("New time step [s], a whole part or multiple.", "新しい時間刻み [s]（整数分の1か整数倍）"),
    "format": ("Format of what is printed.", "標準出力に書き出すときの形式"),
    "suite_out": ("Folder for the motions, their table and figure.", "地震動と表、図を書き出すフォルダー"),
    "family": ("mixed, near-fault, crustal, subduction or basin; made, so synthetic.",
               ("模擬地震動の種類：mixed（いろいろな地震）、near-fault（直下型）、"
                "crustal（内陸の地殻内）、subduction（海溝型の巨大地震）、basin（平野の長周期地震動）")),
    "count": ("How many motions to make.", "作る地震動の数"),
    "seed": ("Seed: the same one gives the same motions.", "乱数のシード（同じ値からは同じ地震動）"),
    "records": ("A folder of records to read, in place of making any.", "模擬地震動に代わる記録のフォルダー"),
    "target": ("Target spectrum: japan[:very-rare|rare[,SOIL]], asce7:SDS,SD1[,TL], or a table's file.",
               "目標スペクトル：japan[:very-rare|rare[,SOIL]]、asce7:SDS,SD1[,TL]、または表のファイル"),
    "band": ("Periods that the target holds for [s].", "目標スペクトルに合わせる周期の範囲 [s]"),
    "fit": (("How to meet the target: scale (one factor a motion), match (every spectrum) or together "
             "(the median alone, the scatter stays)."),
            ("目標への合わせ方：scale（地震動ごとに1つの倍率）、match（それぞれのスペクトルを適合）、"
             "together（中央値だけを適合し、ばらつきを残す）")),
    "select": ("Keep the N whose spectra are most like the target.", "スペクトルが目標に最も近いN個を残す"),
    # assess
    "inventory": (("The inventory, a row a piece: .csv, .tsv, .xlsx or .parquet; - is a CSV on standard "
                   "input."),
                  "1行に1点の家具一覧：.csv、.tsv、.xlsx、.parquet（-は標準入力のCSV）"),
    "events": ("A scenario, or a folder of them: events or stations.", "シナリオ、またはそのフォルダー"),
    "assessment_out": ("Folder of the results; the same command goes on in it.",
                       "結果のフォルダー（同じコマンドで再開）"),
    "shakemap": ("ShakeMap's grid.xml, or CSV of lat, lon and intensity, sa_0.3, pga[%g], pgv[cm/s] or mmi.",
                 ("ShakeMapのgrid.xml、またはlatとlonのほかにintensity、sa_0.3、pga[%g]、pgv[cm/s]、"
                  "mmiのいずれかの列を持つCSV")),
    "field": ("Field of the shake map that counts, such as PGV.", "地震動マップの使う項目（例：PGV）"),
    "uncertainty": ("ShakeMap's uncertainty.xml: scatter of the shaking.",
                    "ShakeMapのuncertainty.xml（揺れのばらつき）"),
    "columns": ("Which columns of the table are which: width=奥行[mm],ignore=備考; or a TOML or JSON file.",
                "表の列の対応（例：width=奥行[mm],ignore=備考）、またはそれを書いたTOMLかJSONのファイル"),
    "export": ("Results also as csv and geojson: csv,geojson.", "結果の別の形式（例：csv,geojson）"),
    "scheduler": ("A Dask scheduler to use: tcp://host:8786.", "Daskのスケジューラー（例：tcp://host:8786）"),
    "memory": ("Memory to stay below.", "使うメモリの上限"),
    # app
    "host": ("Address to bind to; others than loopback let other machines in.",
             "待ち受けるアドレス。ループバック以外では、ほかのマシンからも接続できる"),
    "server_name": ("Name of the server behind a proxy; repeatable.",
                    "プロキシ経由で使うときのサーバー名（複数可）"),
    "port": ("Port; 0 takes a free one.", "ポート番号（0なら空いているもの）"),
    "browser": ("Open the page.", "ブラウザーでページを開くかどうか"),
}
