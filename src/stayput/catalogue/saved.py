"""Values in files."""

TEXTS: dict[str, tuple[str, str]] = {
    "another": ("{file} holds no {kind}; it must be a file that save() of a {kind} wrote.",
                ("{file}は{kind}のファイルではありません。"
                 "{kind}のsave()で保存したファイルを指定してください。")),
    "other_version": (("{file} cannot be read by this version; it must be as save() of stayput {version} "
                       "wrote it, or be read by that."),
                      ("{file}はこのバージョンでは読み込めません。"
                       "stayput {version}のsave()で保存したままのファイルか、そのバージョンが必要です。")),
    "changed": ("{file} was changed after it was saved; it must be as save() wrote it.",
                "{file}は保存後に変更されています。save()で保存したままのファイルを指定してください。"),
    "not_ours": ("A {value} cannot be saved; what is saved must be made of stayput's own classes.",
                 "{value}は保存できません。保存できるのはstayputのクラスだけです。"),
}
