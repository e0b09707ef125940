"""What progress bars are called, and what they count."""

TEXTS: dict[str, tuple[str, str]] = {
    "compiling": ("Compiling the mechanics once", "計算プログラムの準備（初回のみ）"),
    "drawing": ("Drawing", "描画"),
    "left": ("{time} left", "残り{time}"),
    "matching": ("Matching", "目標スペクトルに適合"),
    "planning": ("Planning", "対策計画の作成"),
    "reading": ("Reading", "読み込み"),
    "simulating": ("Simulating", "シミュレーション"),
    "verifying": ("Verifying", "検証"),
    "writing": ("Writing", "書き出し"),
    "cases": ("cases", "件"),
    "frames": ("frames", "コマ"),
    "functions": ("functions", "関数"),
    "motions": ("motions", "波"),
    "rows": ("rows", "行"),
    "settings": ("settings", "条件"),
    "units": ("units", "件"),
}
