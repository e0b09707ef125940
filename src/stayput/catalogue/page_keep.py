"""Texts of the page's last step, where what was found is kept."""

TEXTS: dict[str, tuple[str, str]] = {
    "linkRecord": (
        "The record “{name}” is too large for the link, which shows it only while this server still has it: send the file too.",
        "記録「{name}」は大きいため、リンクには入りません。リンクで表示できるのは、このサーバーに記録が残っている間だけです。記録のファイルも一緒に渡してください。",
    ),
    "withoutVertical": (
        "What you see is the horizontal record alone, without a vertical component.",
        "今の図は、上下成分を除いた水平方向の記録だけによるものです。",
    ),
    "linkLong": (
        "This file is too large for a link, and for the page to show it again when it is loaded anew: keep the file itself.",
        "このファイルは大きいため、リンクにはできません。ページを読み込み直したときも、もう一度ファイルを開いてください。",
    ),
    "addressLabel": ("A link that shows this scene again", "この条件を再現するリンク"),
    "copy": ("Copy", "コピー"),
    "copied": ("The link is on the clipboard.", "リンクをコピーしました。"),
    "toml": ("Scenario (TOML)", "条件ファイル（TOML）"),
    "report": ("Report (HTML)", "報告書（HTML）"),
    "table": ("Verdict as a table (CSV)", "判定の表（CSV）"),
    "csvWithout": ("Run without measures (CSV)", "対策なしの計算結果（CSV）"),
    "csvWith": ("Run with the measures (CSV)", "対策ありの計算結果（CSV）"),
    "htmlWithout": ("Animation without measures (HTML)", "対策なしの動画（HTML）"),
    "htmlWith": ("Animation with the measures (HTML)", "対策ありの動画（HTML）"),
    "gifWithout": ("Animation without measures, 10 s (GIF)", "対策なしの動画、10秒（GIF）"),
    "gifWith": ("Animation with the measures, 10 s (GIF)", "対策ありの動画、10秒（GIF）"),
    "mp4Without": ("Animation without measures, 10 s (MP4)", "対策なしの動画、10秒（MP4）"),
    "mp4With": ("Animation with the measures, 10 s (MP4)", "対策ありの動画、10秒（MP4）"),
    "drawingNow": ("Drawing …", "作成中…"),
    "drawing": (
        "Drawing the animation, which may take half a minute …",
        "動画を作っています。30秒ほどかかることがあります…",
    ),
    "reportWait": (
        "Report and table are there once the chances have been worked out.",
        "報告書と表は、確率の計算が終わると保存できます。",
    ),
}
"""Texts by their keys: English, Japanese."""
