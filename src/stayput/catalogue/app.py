"""Refusals of the app's server."""

TEXTS: dict[str, tuple[str, str]] = {
    # The command that serves the page
    "at_address": ("stayput is at {address} (Ctrl-C ends it)", "アドレス：{address}（Ctrl-Cで終了）"),
    "reachable": (("Warning: other machines can reach stayput, at {where}. There is no password and no "
                   "encryption: whoever reaches it can use this machine's time and read what goes over "
                   "the network. Do this only in a network that you trust; without --host only this "
                   "machine can."),
                  ("注意：ほかの機器からも{where}でstayputにアクセスできます。"
                   "パスワードも暗号化もないため、アクセスした人はこの機器で計算でき、"
                   "ネットワーク上の通信も読まれるおそれがあります。"
                   "信頼できるネットワークだけで使ってください。--hostを付けなければ、"
                   "この機器からだけ使えます。")),
    "every_address": ("port {port} of every address of this machine", "この機器の全アドレスのポート{port}"),
    # Requests
    "no_mesh": (("The piece “{name}” is of a mesh's file; here every piece must be a preset, a box, a "
                 "cylinder or a cone."),
                ("家具「{name}」の形がメッシュのファイルで指定されています。ここではプリセット、箱、円柱、"
                 "円すい台のどれかにしてください。")),
    "duration_for_pieces": ("With {count} pieces the duration [s]", "家具が{count}個のときの揺れの長さ [s]"),
    "other_host": ("The Host header names another server; open the address that stayput printed.",
                   "別のサーバー宛てのリクエストです。stayputが表示したアドレスを開いてください。"),
    "other_site": ("Requests from other sites are refused.", "ほかのサイトからの要求は受け付けません。"),
    "body_too_large": ("The body is too large; at most {most} bytes are accepted.",
                       "送信されたデータが大きすぎます。{most}バイトまでです。"),
    "body_too_slow": ("The body came too slowly.", "送信に時間がかかりすぎました。もう一度お試しください。"),
    "not_json": ("The body is not JSON.", "送信されたデータがJSONではありません。"),
    "not_valid": ("{name}: {message}.", "{name}の値が正しくありません。"),
    # What is allowed in a body: see stayput.app.messages
    "at_least": ("at least {limit:g}", "{limit:g}以上"),
    "at_most": ("at most {limit:g}", "{limit:g}以下"),
    "characters": ("a text of at most {limit} characters", "{limit}文字までの文字列"),
    "items": ("a list of at most {limit}", "{limit}個までのリスト"),
    "words": ("a text", "文字列"),
    "field_missing": ("{name} is missing; it must be given.", "{name}がありません。指定してください。"),
    "field_unknown": ("{name} is not known here; it must be left out.",
                      "{name}という項目はありません。取り除いてください。"),
    "no_such_address": ("There is nothing at this address.", "このアドレスには何もありません。"),
    "wrong_method": ("This address does not take this method.", "このアドレスではそのメソッドは使えません。"),
    "the_body": ("The body", "送信されたデータ"),
    "http": ("{message}.", "リクエストを処理できませんでした。"),
    "half_character": ("A text holds half a character; it must be Unicode.",
                       "文字列に不完全な文字があります。Unicodeで指定してください。"),
    # Too much at once
    "busy": ("The server is busy; try again in a moment.", "混み合っています。少し待ってください。"),
    "many_jobs": ("There are {count} verifications already; wait for one to end, or cancel it.",
                  "すでに{count}件の検証があります。どれかが終わるまで待つか、中止してください。"),
    "little_memory": ("The server has too little memory for this; try something smaller.",
                      "サーバーのメモリが足りません。条件を小さくしてお試しください。"),
    "failed": ("The server failed; its log says why.", "サーバーでエラーが起きました。"),
    # Verifications
    "no_report_yet": ("The job is {state}; there is a report, or a plan of a room, once it is done.",
                      "報告書と「買う物とやること」（部屋だけ）は、計算が終わってから開いてください。"),
    "of_no_room": ("The job is of no room; a plan is there for the verification of a room.",
                   "部屋の計算ではありません。「買う物とやること」は部屋の検証で使えます。"),
    "of_a_room": ("The job is of a room; this is there for the verification of a single piece.",
                  "部屋の計算です。これは家具1点の検証で使えます。"),
    "another_room": (("before is another room than scene, in its {others}; it may differ in where pieces "
                      "and people are, and in measures."),
                     ("beforeがsceneとは別の部屋です（{others}が違います）。違ってよいのは、"
                      "家具と人の位置と対策だけです。")),
    "before_refused": (("The room as it was before the changes that are tried cannot be worked out: {why} "
                        "Take them back, or say that they are already done."),
                       ("試している変更の前の部屋は計算できません。{why}変更を元に戻すか、"
                        "「実施済み」を選んでください。")),
    "no_such_id": ("There is nothing of this id on this server; it may have expired.",
                   "このIDのものはサーバーにありません。保存期間が過ぎた可能性があります。"),
    "runs": ("The number of simulations", "計算回数"),
    "many": ("{name} is {value:.10g}; this server allows {most:.10g}.",
             "{name}が{value:.10g}になっています。このサーバーでは{most:.10g}までです。"),
    "no_such_record": ("{name} is not a motion that this server has; it must be uploaded (again).",
                       "{name}の記録がサーバーにありません。もう一度アップロードしてください。"),
    "suite_folder": ("shaking.suite is a folder; this server takes suites by family and count only.",
                     "shaking.suiteにフォルダーは指定できません。familyとcountで指定してください。"),
    "no_video": ("kind is {value}, which needs ffmpeg where the server runs; it must be one of {allowed}.",
                 ("kindが{value}になっていますが、サーバーにffmpegがありません。"
                  "{allowed}のいずれかを指定してください。")),
    "long_film": (("The motion lasts {value:.0f} s; this server draws a GIF of at most {most:g} s, and a "
                   "page of any."),
                  "揺れの長さは{value:.0f}秒です。GIFは{most:g}秒まで作れます。HTMLには制限がありません。"),
    # Records
    "motion_needed": ("A verification needs this motion; wait for its end, or cancel it.",
                      "計算中の検証がこの記録を使っています。終わるまで待つか、計算を中止してください。"),
    "duration": ("The motion's duration [s]", "揺れの長さ [s]"),
    "samples": ("The number of samples", "データの数"),
    "entries": ("The number of entries of {name}", "{name}の件数"),
    "reading_died": (("Reading the file needs too much, and was ended; it must be a record in one of the "
                      "known formats."),
                     "ファイルを読み込めないため、中止しました。"),
    "reading_slow": (("The file takes more than {seconds:g} s to read; it must be a record in one of the "
                      "known formats."),
                     "ファイルの読み込みに{seconds:g}秒以上かかるため、中止しました。"),
    # Forms
    "control": ("“{label}”", "「{label}」"),
    "flag": ("{flag} on the command line", "コマンドの{flag}"),
    "body_not_read": ("The body cannot be read; it must be JSON, or that of an upload multipart/form-data.",
                      ("送信されたデータを読み取れません。"
                       "JSON（アップロードではmultipart/form-data）で送ってください。")),
    "empty_file": ("The file is empty; it must hold a record.", "ファイルが空です。"),
    # Starting
    "not_served": ("The address is {host}, port {port}; it cannot be served: {reason}.",
                   "アドレス{host}、ポート{port}を使えません（{reason}）。"),
}
