"""What single formats of motions' files lack; the ids are those of `stayput.catalogue.motion`."""

TEXTS: dict[str, tuple[str, str]] = {
    # COSMOS.
    "cosmos_no_end": (
        "The samples have no line End-of-data after them; the file must be complete.",
        "データの後に「End-of-data」の行がありません。ファイルが途中で切れています。",
    ),
    "cosmos_no_header": (
        "The header has no {kind}-header block; it must have one.",
        "ヘッダーに「{kind}-header」のブロックがありません。",
    ),
    "cosmos_header_count": (
        "The {kind} header has {count} values; it must have the {stated} it states.",
        "「{kind}-header」の値が{count}個です。書かれたとおり{stated}個必要です。",
    ),
    "cosmos_short_header": (
        "The real header has {count} values; it must have 64 or more.",
        "「real-header」の値が{count}個です。64個以上必要です。",
    ),
    "cosmos_no_format": (
        "The line {line} stands where a channel begins; it must state the format.",
        "チャンネルの最初の行が{line}になっています。ここには形式を書く必要があります。",
    ),
    "cosmos_no_layout": (
        "The line {line} stands before the samples; it must state their number and format.",
        "データの前の行が{line}になっています。ここにはデータの数と書式を書く必要があります。",
    ),
    "no_samples_announced": (
        "The line {line} announces no samples; it must announce some.",
        "{line}の行に書かれたデータの数が0です。1以上でなければなりません。",
    ),
    "cosmos_another_end": (
        "A block of {begun} ends as one of {ended}; it must be the same.",
        "「{begun}」のブロックが「{ended}」として終わっています。同じでなければなりません。",
    ),
    "cosmos_duration": (
        (
            "The header states about {stated} s and {count} samples every {step:g} s last {duration:g} s; "
            "they must agree."
        ),
        (
            "ヘッダーに書かれた長さは約{stated}秒ですが、{step:g}秒ごとのデータ{count}個の長さは{duration:g}秒です。"
            "一致しなければなりません。"
        ),
    ),
    "cosmos_no_acceleration": (
        "The file has no block of acceleration; it must have at least one.",
        "ファイルに加速度のブロックがありません。1つ以上必要です。",
    ),
    # CSMIP.
    "csmip_two_numbers": (
        "Channel {channel} of the file is numbered {numbers}; it must have one number.",
        "ファイルの{channel}番目のチャンネルに複数の番号があります（{numbers}）。番号は1つでなければなりません。",
    ),
    "csmip_directions": (
        "The header of channel {channel} gives the directions {directions}; {taken} is taken.",
        "チャンネル{channel}のヘッダーの成分の方向が一致しません（{directions}）。{taken}として使います。",
    ),
    "csmip_acceleration_lines": (
        "Channel {channel} of the file has {count} lines that announce acceleration data; it must have one.",
        (
            "ファイルの{channel}番目のチャンネルに、加速度データの始まりを示す行が{count}行あります。"
            "1行でなければなりません。"
        ),
    ),
    "csmip_lengths": (
        (
            "Channel {channel} has {count} samples of acceleration every {step:g} s and {other_count} "
            "of {kind} "
            "every {other_step:g} s; they must last as long."
        ),
        (
            "チャンネル{channel}のデータは、加速度が{step:g}秒ごとに{count}個、「{kind}」が{other_step:g}秒ごとに"
            "{other_count}個です。同じ長さでなければなりません。"
        ),
    ),
    "csmip_no_end": (
        "The last channel has no end-of-data line /&; the file must be complete.",
        "最後のチャンネルに終わりの行（/&）がありません。ファイルが途中で切れています。",
    ),
    "csmip_channels_missing": (
        "The header counts {stated} channels and the file has {count}; it may have been cut.",
        (
            "ヘッダーによるとチャンネルは{stated}個ですが、ファイルには{count}個しかありません。"
            "途中で切れているかもしれません。"
        ),
    ),
    # ESM.
    "esm_no_acceleration": (
        "The DATA_TYPE is {kind}; it must be 'ACCELERATION'.",
        "「DATA_TYPE」が{kind}になっています。「ACCELERATION」でなければなりません。",
    ),
    "esm_duration": (
        (
            "The header's DURATION_S is {stated:g} and NDATA times SAMPLING_INTERVAL_S is {duration:g} s; "
            "they must agree."
        ),
        (
            "ヘッダーの「DURATION_S」は{stated:g}秒ですが、「NDATA」に「SAMPLING_INTERVAL_S」を掛けると"
            "{duration:g}秒です。一致しなければなりません。"
        ),
    ),
    # JMA.
    "jma_no_names": (
        "The header has no line of component names; it must have one such as NS,EW,UD.",
        "ヘッダーに成分名の行がありません。「NS,EW,UD」のような行が必要です。",
    ),
    "jma_rate": (
        "The sampling rate is {rate:g} Hz; it must be more than 0 Hz.",
        "サンプリングレートが{rate:g}Hzになっています。0より大きくなければなりません。",
    ),
    "jma_names_repeated": (
        "The component names are {names}; they must differ.",
        "成分名が「{names}」になっています。互いに異なる名前が必要です。",
    ),
    "jma_unknown_name": (
        "The component names have {name!r}; they must be among NS, EW, UD.",
        "成分名に「{name}」があります。「NS」「EW」「UD」のいずれかでなければなりません。",
    ),
    # K-NET.
    "knet_no_memo": (
        "The header does not end with Memo. on line 17; it must be the format's 17 lines.",
        "ヘッダーの17行目が「Memo.」ではありません。形式どおりの17行が必要です。",
    ),
    "knet_no_scale": (
        "The header has no scale factor in gal; it must be like 2000(gal)/8388608.",
        "ヘッダーにスケールファクター（gal）がありません。2000(gal)/8388608のように書いてください。",
    ),
    "knet_not_positive": (
        "The header's sampling frequency is {rate:g} Hz; it and the scale must be positive.",
        (
            "ヘッダーのサンプリング周波数が{rate:g}Hzになっています。"
            "サンプリング周波数とスケールファクターは正でなければなりません。"
        ),
    ),
    "knet_duration": (
        "The header states {stated:g} s and the file has {duration:g} s; they must agree.",
        "ヘッダーに書かれた長さは{stated:g}秒ですが、データは{duration:g}秒です。一致しなければなりません。",
    ),
    "knet_direction": (
        "The header's direction is {direction}; it must be N-S, E-W, U-D or 1 to 6.",
        "ヘッダーの方向が{direction}になっています。N-S、E-W、U-D、または1～6のいずれかでなければなりません。",
    ),
    "knet_offset_count": (
        "The header line {line} has {count} numbers; it must have {columns}.",
        "ヘッダーの{line}の行に数値が{count}個あります。{columns}個必要です。",
    ),
    "knet_no_date": (
        "The row {line} has no date and time; each must begin with them.",
        "{line}の行に日時がありません。各行は日時で始まらなければなりません。",
    ),
    "knet_no_offset": (
        "The header has no line #Offset; it must state what to subtract.",
        "ヘッダーに「#Offset」の行がありません。差し引く値が必要です。",
    ),
    "knet_rate": (
        "The header's sampling frequency is {rate:g} Hz and the rows' step {step:g} s; they must agree.",
        (
            "ヘッダーのサンプリング周波数は{rate:g}Hzですが、データの間隔は{step:g}秒です。"
            "一致しなければなりません。"
        ),
    ),
    # PEER.
    "peer_no_npts": (
        "The header has no NPTS and DT; it must state them.",
        "ヘッダーに「NPTS」と「DT」がありません。",
    ),
    "peer_no_acceleration": (
        "The file is a {kind} history; it must be an acceleration history.",
        "ファイルは{kind}の時刻歴です。加速度の時刻歴が必要です。",
    ),
    "velocity": ("velocity", "速度"),
    "displacement": ("displacement", "変位"),
    "counts": ("raw counts or volts of a recorder", "収録器の生のカウント値や電圧"),
    "peer_npts_line": (
        "The line {line} is not NPTS= a number, DT= a number; it must be.",
        "{line}の行が「NPTS= 数値, DT= 数値」の形になっていません。",
    ),
}
"""Texts by their keys: English, Japanese."""
