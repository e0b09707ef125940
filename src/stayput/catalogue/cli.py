"""The command line's refusals and warnings. Flags stand as they are typed."""

TEXTS: dict[str, tuple[str, str]] = {
    "strength": ("Stated shaking", "指定した揺れ"),
    "baseline": ("Baseline", "基線"),
    "mean_removed": ("the mean of each component taken off", "各成分の平均を除去"),
    "of_a_motion": ("for a motion", "揺れのコマンド"),
    "one_storey": ("without --building, or with --storey", "--buildingのない、または--storeyのある場合"),
    "other_format": ("the ending of the file {out}", "ファイル{out}の拡張子と同じもの"),
    "standard_output": ("standard output", "標準出力"),
    "standard_input": ("{flag}, standard input,", "{flag}（標準入力）"),
    "input_too_large": ("{flag} is -, standard input, which has more than {most:,} bytes; give a file.",
                        ("{flag}が-（標準入力）になっていますが、{most:,}バイトを超えています。"
                         "ファイルを指定してください。")),
    "closed": ("it is closed", "閉じられています"),
    "written_like": ("written like {example}", "{example}のような値"),
    "wrote": ("Wrote {file}", "{file}を書き出しました"),
    "wrote_motion": ("Wrote {file}: {count} samples every {dt:g} s, {components}",
                     "{file}を書き出しました（{dt:g}秒間隔、{count}点、成分：{components}）"),
    "wrote_suite": ("Wrote {folder}: the motions, suite.csv, suite.png",
                    "{folder}に地震動とsuite.csv、suite.pngを書き出しました"),
    "curve": ("{name}: {told}", "{name}：{told}"),
    # A building
    "building": ("{name}, T1 = {period:.3g} s, {kind}", "{name}、T1 = {period:.3g} s、{kind}"),
    "building_ground": ("Ground: {motion}", "地盤の揺れ：{motion}"),
    "building_no_energy": ("Energy, {component}: none.", "エネルギー（{component}）：なし。"),
    "building_energy": (("Energy, {component}: {share:.0f} % of the input went into yielding; the balance "
                         "closes to {imbalance:.1e}."),
                        ("エネルギー（{component}）："
                         "入力の{share:.0f}%が降伏による変形で吸収されました（収支の誤差は"
                         "{imbalance:.1e}）。")),
    # A motion
    "samples": ("{count} samples every {dt:g} s: {duration:g} s", "{dt:g}秒間隔、{count}点、{duration:g}秒"),
    "intensities_of_floor": (("{intensity:.1f} by JMA's formula for the motion on {name}, not the "
                              "intensity of the place; Sva {sva:.3g} cm/s at long periods"),
                             ("{name}の揺れによる計測震度相当値{intensity:.1f}（その場所の震度ではない）、"
                              "長周期のSva {sva:.3g} cm/s")),
    "intensities": (("JMA intensity {intensity:.1f}, class {name}; long-period class {long_period} (Sva "
                     "{sva:.3g} cm/s); modified Mercalli about {mmi:.1f}"),
                    ("計測震度{intensity:.1f}（{name}）、"
                     "長周期地震動階級{long_period}（Sva {sva:.3g} cm/s）、改正メルカリ震度 約{mmi:.1f}")),
    "along": ("x (along)", "x（加振方向）"),
    "across": ("y (across)", "y（直交方向）"),
    "up": ("z (up)", "z（上下）"),
    "pga": ("PGA [m/s²]", "最大加速度 [m/s²]"),
    "pgv": ("PGV [cm/s]", "最大速度 [cm/s]"),
    "pgd": ("PGD [cm]", "最大変位 [cm]"),
    "arias": ("Arias intensity [m/s]", "アリアス強度 [m/s]"),
    "cav": ("CAV [m/s]", "累積絶対速度 CAV [m/s]"),
    "d5_95": ("Duration D5-95 [s]", "継続時間 D5-95 [s]"),
    "housner": ("Housner intensity [m]", "ハウスナー強度 [m]"),
    "si": ("SI, 20 % [cm/s]", "SI値、減衰20% [cm/s]"),
    "largest_sa": ("Period of largest Sa [s]", "Saが最大の周期 [s]"),
    "mean_period": ("Mean period Tm [s]", "平均周期 Tm [s]"),
    "spectra": ("{motion}: response spectra, {damping:g} % damping",
                "{motion}：応答スペクトル、減衰{damping:g}%"),
    "suite": ("{count}: JMA intensity {low:.1f} to {high:.1f}", "{count}：計測震度{low:.1f}～{high:.1f}"),
    "suite_off": (("Median spectrum against {target}, {first:g} to {last:g} s: {mean:.1f} % off on "
                   "average, {worst:.1f} % at most (at {at:.2g} s)"),
                  ("スペクトルの中央値と{target}との差（周期{first:g}～{last:g}秒）：平均{mean:.1f}%、"
                   "最大{worst:.1f}%（{at:.2g}秒）")),
    "interrupted": ("Interrupted.", "中断しました。"),
    "unwritten": ("The output could not be written: {reason}.", "出力を書き込めませんでした（{reason}）。"),
    "compiling": ("Compiling the mechanics once, which takes up to half a minute ...",
                  "計算プログラムを準備しています（初回のみ、30秒ほどかかります）…"),
    "warning": ("Warning: {sentence}", "注意：{sentence}"),
    "no_such_flag": ("There is no flag {flag}; `{command} --help` lists those that there are.",
                     "{flag}というオプションはありません。{command} --helpで一覧を確認してください。"),
    "missing": ("{name} is missing; `{command} --help` says how the command is written.",
                "{name}が指定されていません。書き方は{command} --helpで確認してください。"),
    "misused": ("{said}; `{command} --help` says how the command is written.",
                "コマンドを読み取れません（{said}）。書き方は{command} --helpで確認してください。"),
    "same_file": ("{flag} and {other} are both {value}; one of them must be another file, or be left out.",
                  ("{flag}と{other}がどちらも{value}になっています。一方を別のファイルにするか、"
                   "省いてください。")),
    "long_name": ("The name of the file or folder {file} is too long; it must be shorter.",
                  "ファイルまたはフォルダーの名前{file}が長すぎます。短くしてください。"),
    "no_row": ("No row of the inventory could be assessed; {rejects} says why, row by row.",
               "評価できる行がありませんでした。理由は行ごとに{rejects}に書かれています。"),
    "targets": ("japan[:LEVEL[,SOIL]], asce7:SDS,SD1[,TL] or a file that exists",
                "japan[:LEVEL[,SOIL]]、asce7:SDS,SD1[,TL]、または存在するファイル"),
}
