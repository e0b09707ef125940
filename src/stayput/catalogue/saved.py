"""Values in files."""

TEXTS: dict[str, tuple[str, str]] = {
    "another": (
        "{file} holds no {kind}; it must be a file that save() of a {kind} wrote.",
        "{file}は{kind}のファイルではありません。{kind}のsave()で保存したファイルを指定してください。",
    ),
    "other_version": (
        "{file}, written by stayput {version}, cannot be read by this version; it must be as save() wrote it.",
        "stayput {version}で保存された{file}は、このバージョンでは読み込めません。save()で保存したままのファイルを指定してください。",
    ),
    "changed": (
        "{file} was changed after it was saved; it must be as save() wrote it.",
        "{file}は保存後に変更されています。save()で保存したままのファイルを指定してください。",
    ),
    "newer": (
        "{file}, written by stayput {version}, is in a newer format; it can be read by that version or a later one.",
        "stayput {version}で保存された{file}は、新しい形式です。そのバージョン以降で読み込んでください。",
    ),
    "not_ours": (
        "A {value} cannot be saved; what is saved must be made of stayput's own classes.",
        "{value}は保存できません。保存できるのはstayputのクラスだけです。",
    ),
}
