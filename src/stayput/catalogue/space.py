"""Pictures and animations of pieces in space."""

TEXTS: dict[str, tuple[str, str]] = {
    # The motion
    "peak_of_all": ("peak of all components {peak:.2f} m/s²", "全成分を合わせた最大加速度 {peak:.2f} m/s²"),
    # What became of them
    "upright": ("{name} did not overturn; it tilted by {tilt} and slid by {slide}.",
                "{name}は転倒しませんでした（傾き：{tilt}、移動量：{slide}）。"),
    "leaning": ("{name} did not overturn but was left leaning; it tilted by {tilt} and slid by {slide}.",
                ("{name}は転倒しませんでしたが、寄りかかったままになりました（傾き：{tilt}、移動量："
                 "{slide}）。")),
    "turned": ("{name} turned by up to {angle:.0f}°.", "{name}は最大{angle:.0f}°回転しました。"),
    "rolled": ("{name} rolled by {slide}.", "{name}は{slide}転がりました。"),
    "overturned": ("{name} overturned {time:.1f} s into the motion.",
                   "{name}は揺れ始めから{time:.1f}秒後に転倒しました。"),
    "failed": (("The run was given up, as contact forces were too rough or took too much work: nothing is "
                "known of it."),
               "接触力が収束しないか計算量が多すぎるため、計算を打ち切りました。結果は不明です。"),
    "none_fell": ("None of the {count} pieces overturned or fell off.",
                  "{count}個の家具はいずれも転倒・落下しませんでした。"),
    "some_fell": ("{fallen} of {count} pieces overturned or fell off: {which}.",
                  "{count}個の家具のうち{fallen}個が転倒または落下しました：{which}。"),
    "fell_at": ("{name} at {time:.1f} s", "{name}（{time:.1f}秒）"),
    "up_to_angle": ("up to {angle:.1f}°", "最大{angle:.1f}°"),
    "least_angle": ("less than 0.1°", "0.1°未満"),
    "state": ("tilt {tilt:.1f}°, slide {slide:.1f} cm", "傾き {tilt:.1f}°、移動量 {slide:.1f} cm"),
    # The player
    "piece": ("Piece", "家具"),
    "tilt": ("tilt", "傾き"),
    "slide": ("slide", "移動量"),
    "yaw": ("turn in plan", "水平面内の回転"),
    "view": ("View", "視点"),
    "view_free": ("Corner", "斜め"),
    "view_front": ("Front", "正面"),
    "view_side": ("Side", "側面"),
    "view_top": ("Top", "上"),
    "shaken": ("Move the room with the ground", "部屋を地盤とともに動かす"),
    "scene": ("Picture in space, turned by dragging or arrow keys", "立体図（ドラッグまたは矢印キーで回転）"),
    "about": ("About this picture", "この図について"),
    "strip": ("Floor acceleration and tilt over time", "床の加速度と傾きの時刻歴"),
    "tilt_of": ("Tilt: {name}, up to {angle}°", "傾き：{name}、最大{angle}°"),
    "keys": (("Drag to turn the picture, with the right button or two fingers to move it; the wheel or a "
              "pinch comes nearer. Space plays and pauses, the arrow keys step; while the picture has the "
              "focus they turn it, with Shift they move it, + and − come nearer and go back. 1 to 4 "
              "choose a view."),
             ("ドラッグで回転、右ボタンまたは2本指で移動、ホイールまたはピンチで拡大・縮小します。"
              "スペースキーで再生・一時停止、矢印キーでコマ送りができます。"
              "図を選択しているときは矢印キーで回転、Shift＋矢印キーで移動、＋と－で拡大・縮小します。"
              "1～4で視点を選べます。")),
    "caption": ("The floor's grid is {grid:g}\xa0m wide; what is lighter or striped is the front.",
                "床の格子の間隔は{grid:g}\xa0mです。明るい面または縞のある側が正面です。"),
    "caption_still": (("Outlines: places of people, doors and windows, which do not move and hold nothing "
                       "up."),
                      "線で示したものは人のいる場所、ドア、窓です。動かず、家具を支えません。"),
    "caption_moved": (("The room moves as the ground does: the record integrated twice, without its drift "
                       "below {corner:g}\xa0Hz{part}."),
                      ("部屋は地盤とともに動きます（記録を2回積分し、"
                       "{corner:g}\xa0Hz未満のゆっくりした動きを除いたもの{part}）。")),
    "no_webgl": ("This browser has no WebGL 2, so the pieces are drawn without light and shadows.",
                 "このブラウザーはWebGL 2に対応していないため、光や影のない図で表示しています。"),
    # Plots
    "axis_tilt": ("Tilt [°]", "傾き [°]"),
    "axis_slide": ("Slide [cm]", "移動量 [cm]"),
    "axis_yaw": ("Turn in plan [°]", "水平面内の回転 [°]"),
    "axis_x": ("x, towards the front [m]", "x、正面側 [m]"),
    "axis_y": ("y, across [m]", "y、左右 [m]"),
    "axis_x_room": ("x, from the left wall [m]", "x、左の壁から [m]"),
    "axis_y_room": ("y, from the near wall [m]", "y、手前の壁から [m]"),
    "plan": ("Seen from above: at first (dashed) and at the end", "平面図：最初（破線）と最後"),
    "floor_z": ("z, vertical", "z、上下"),
}
