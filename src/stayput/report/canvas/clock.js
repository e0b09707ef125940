// The clock of the animation: play, pause, scrub, slow motion. It calls for a picture only when one is due.

/** Whether the reader has asked the system for less motion. */
export const prefersReducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** A function that runs at most once before the next picture is drawn. */
export function beforeNextFrame(work) {
  let due = false;
  return () => {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      work();
    });
  };
}

/**
 * A clock for a time span; "draw" is called with the time whenever the picture changes, "onPlaying" with
 * whether it plays. At the end it holds for so many seconds and starts again; with Infinity it stops there.
 */
export function player(draw, onPlaying, hold = 1.5) {
  let now = 0,
    start = 0,
    end = 0,
    playing = false,
    speed = 1,
    last = null,
    held = 0,
    ticking = false;
  const once = beforeNextFrame(() => {
    if (!playing) draw(now);
  });

  function tick(stamp) {
    ticking = playing && !document.hidden;
    const passed = last === null ? 0 : Math.min(0.25, (stamp - last) / 1000);
    last = stamp;
    if (!playing) return;
    if (now >= end) {
      held += passed;
      if (hold === Infinity) {
        ticking = false;
        play(false);
        return;
      }
      if (held > hold) {
        now = start;
        held = 0;
      }
    } else now = Math.min(end, now + passed * speed);
    draw(now);
    if (ticking) requestAnimationFrame(tick);
  }
  const begin = () => {
    if (!ticking && playing) {
      ticking = true;
      last = null;
      requestAnimationFrame(tick);
    }
  };
  document.addEventListener("visibilitychange", begin);

  function play(on) {
    playing = on && end > 0;
    if (playing && now >= end) now = start;
    held = 0;
    onPlaying(playing);
    begin();
    once();
  }
  return {
    play,
    toggle: () => play(!playing),
    seek(time) {
      play(false);
      now = Math.min(end, Math.max(0, time));
      once();
    },
    step(by) {
      this.seek(now + by);
    },
    faster(wanted) {
      speed = wanted;
    },
    redraw: once,
    get now() {
      return now;
    },
    get start() {
      return start;
    },
    get end() {
      return end;
    },
    get playing() {
      return playing;
    },
    /** Takes another span; the first one plays at once, unless it is to stand still at the time shown. */
    span(from, until, shown, still = prefersReducedMotion()) {
      const first = end === 0;
      start = from;
      end = until;
      now = first ? start : Math.min(now, end);
      if (first && !still) play(true);
      else {
        if (still && !playing) now = Math.min(end, shown);
        once();
      }
    },
  };
}
